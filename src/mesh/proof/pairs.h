// SPDX-License-Identifier: MIT
// How far a quadratic function is from its linear interpolant on a triangle.
#pragma once

#include "base/numbers.h"
#include "mesh/proof/four.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace nrb::mesh {

using Values = std::array<double, 3>;

// The most of l_0 l_1 q[2] + l_1 l_2 q[0] + l_2 l_0 q[1] over l_i >= 0 with the sum 1: in the middle of a side, or at the centre of
// the circle about a triangle with sides of the squares q, where that is inside.
inline double most_of_pairs(const Values &q) noexcept {
    const double a = q[0], b = q[1], c = q[2];
    const double side = std::max({a, b, c, 0.0}) / 4;
    const bool inside = a > 0 && b > 0 && c > 0 && a < b + c && b < a + c && c < a + b;
    return inside ? std::max(side, a * b * c / (2 * (a * b + b * c + c * a) - (a * a + b * b + c * c)) *
                                       (1 + 64 * eps))
                  : side;
}

// How far a function N of a triangle can be from its linear interpolant, if its Hessian H is an affine function to within a radius. Side k is
// opposite of corner k. With means m_k of H along side k in its two ends, and d_k a twelfth of their difference,
//
//     interpolant - N = 1/2 sum l_i l_j m_k + sum l_i l_j (l_i - l_j) d_k + l_0 l_1 l_2 g
//
// (Taylor's formula with the remainder as an integral; g is 0 if H is constant). The sum of all |l_i l_j (l_i - l_j)| is at most 0.118, on a side 0.0963.
class Bend {
public:
    // q[m][k]: H along side k in corner m; rest[k]: what the radius adds along side k, rest[3]: on the whole triangle.
    Bend(const std::array<Four, 3> &q, const Four &rest) noexcept
        : rest_(rest), largest_(greatest(abs(q[0]), greatest(abs(q[1]), abs(q[2]))) + rest),
          least_(greatest(q[0] * -1, greatest(q[1] * -1, q[2] * -1)) + rest),
          most_(greatest(q[0], greatest(q[1], q[2])) + rest) {
        const Four from(q[1][0], q[2][1], q[0][2], 0), to(q[2][0], q[0][1], q[1][2], 0), both = from + to;
        means_ = both * 0.5;
        differences_ = abs(to - from) * (1.0 / 12);
        product_ = std::abs(both.sum() / 12 - (q[0][0] + q[1][1] + q[2][2]) / 6);
        all_ = 0.118 * std::max({differences_[0], differences_[1], differences_[2]}) + product_ / 27 +
               rest[3] / 8;
    }

    [[nodiscard]] double above() const noexcept {
        return most_of_pairs({-means_[0], -means_[1], -means_[2]}) / 2 + all_;
    }
    // The most of N if it is at most 0 in the ends of side k and -below in corner k. All terms with l_k but one of the side are at most l_k
    // times what `below` is to outweigh; the radius adds at most l_i l_j (1 + l_k) / (1 - l_k) / 2 times that of the side, along which
    // l_i l_j <= (1 - l_k)^2 / 4, as one sees on the line from corner k through the point.
    [[nodiscard]] double above(size_t k, double below) const noexcept {
        const size_t i = (k + 1) % 3, j = (k + 2) % 3;
        const double lifts = std::max({-means_[i], -means_[j], 0.0}) / 2 +
                             std::max(differences_[i], differences_[j]) + product_ / 4 +
                             std::max(rest_[i], rest_[j]) / 2;
        return lifts * (1 + 16 * eps) <= below
                   ? std::max(-means_[k], 0.0) / 8 + rest_[k] / 8 + 0.0963 * differences_[k]
                   : above();
    }
    [[nodiscard]] double both() const noexcept {
        return std::max(most_of_pairs({means_[0], means_[1], means_[2]}) / 2 + all_, above());
    }
    [[nodiscard]] double on_side(size_t k) const noexcept {
        return (std::abs(means_[k]) + rest_[k]) / 8 + 0.0963 * differences_[k];
    }

    // The most of the second derivative along side k, on the whole triangle.
    [[nodiscard]] double largest(size_t k) const noexcept { return largest_[k]; }
    // The same by its sign, and at least 0: N is above its interpolant by no more than the sum of l_i l_j / 2 times where it falls, and below
    // by where it rises. S. Waldron: The error in linear interpolation at the vertices of a simplex, SIAM J. Numer. Anal. 35, 1998.
    [[nodiscard]] double falling(size_t k) const noexcept { return std::max(least_[k], 0.0); }
    [[nodiscard]] double rising(size_t k) const noexcept { return std::max(most_[k], 0.0); }

private:
    Four rest_, largest_, least_, most_, means_, differences_; // of sides
    double product_, all_;
};

} // namespace nrb::mesh
