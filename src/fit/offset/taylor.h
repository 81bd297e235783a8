// SPDX-License-Identifier: MIT
// Taylor polynomials of the second order along each of two axes, and their arithmetic.
#pragma once

#include "numeric/vector3.h"

#include <array>
#include <cmath>

namespace nrb::fit {

inline constexpr int taylor_order = 2;

// f(x, y) = sum c_ij x^i y^j without powers of x or y above the second; c_ij is the derivative over i! j!.
struct Taylor {
    static constexpr size_t count = taylor_order + 1;
    std::array<std::array<double, count>, count> c{};
};

inline Taylor operator*(double s, Taylor a) noexcept {
    for (auto &row : a.c) {
        for (double &x : row) {
            x *= s;
        }
    }
    return a;
}

inline Taylor sum(Taylor a, double factor, const Taylor &b) noexcept {
    for (size_t i = 0; i < Taylor::count; ++i) {
        for (size_t j = 0; j < Taylor::count; ++j) {
            a.c[i][j] += factor * b.c[i][j];
        }
    }
    return a;
}

inline Taylor operator*(const Taylor &a, const Taylor &b) noexcept {
    Taylor product;
    for (size_t i = 0; i < Taylor::count; ++i) {
        for (size_t j = 0; j < Taylor::count; ++j) {
            for (size_t k = 0; k <= i; ++k) {
                for (size_t l = 0; l <= j; ++l) {
                    product.c[i][j] += a.c[k][l] * b.c[i - k][j - l];
                }
            }
        }
    }
    return product;
}

// 1 / sqrt(a), by Newton steps r (3 - a r^2) / 2. A step raises the order k up to which r is right to
// 2 k + 1.
inline Taylor inverse_root(const Taylor &a) noexcept {
    Taylor root;
    root.c[0][0] = 1 / std::sqrt(a.c[0][0]);
    for (int known = 0; known < 2 * taylor_order; known = 2 * known + 1) {
        Taylor rest = -1.0 * (a * (root * root));
        rest.c[0][0] += 3;
        root = 0.5 * (root * rest);
    }
    return root;
}

struct TaylorVector {
    std::array<Taylor, space_dim> x;

    [[nodiscard]] Vector3 at(size_t i, size_t j) const noexcept {
        return {x[0].c[i][j], x[1].c[i][j], x[2].c[i][j]};
    }
    void set(size_t i, size_t j, const Vector3 &v) noexcept {
        x[0].c[i][j] = v.x;
        x[1].c[i][j] = v.y;
        x[2].c[i][j] = v.z;
    }
};

inline TaylorVector cross(const TaylorVector &a, const TaylorVector &b) noexcept {
    TaylorVector result;
    for (size_t c = 0; c < 3; ++c) {
        const size_t d = (c + 1) % 3, e = (c + 2) % 3;
        result.x[c] = sum(a.x[d] * b.x[e], -1, a.x[e] * b.x[d]);
    }
    return result;
}

// n / |n|
inline TaylorVector unit(const TaylorVector &n) noexcept {
    Taylor square;
    for (const Taylor &x : n.x) {
        square = sum(square, 1, x * x);
    }
    const Taylor factor = inverse_root(square);
    return {{n.x[0] * factor, n.x[1] * factor, n.x[2] * factor}};
}

// s + d n
inline TaylorVector moved(const TaylorVector &s, double d, const TaylorVector &n) noexcept {
    return {{sum(s.x[0], d, n.x[0]), sum(s.x[1], d, n.x[1]), sum(s.x[2], d, n.x[2])}};
}

} // namespace nrb::fit
