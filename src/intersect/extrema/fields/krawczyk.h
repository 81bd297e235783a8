// SPDX-License-Identifier: MIT
// Krawczyk's operator for derivatives that are known to within intervals.
#pragma once

#include "base/numbers.h"
#include "intersect/contraction.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace nrb::intersect {

template <size_t N>
using Matrix = std::array<std::array<double, N>, N>;
template <size_t N>
using IntervalMatrix = std::array<std::array<Interval, N>, N>;

inline double middle(Interval x) noexcept {
    return x.lower / 2 + x.upper / 2;
}

// Of a matrix, by Gauss and Jordan with pivots of rows; false if it has none.
template <size_t N>
bool invert(Matrix<N> a, Matrix<N> &inverse) noexcept {
    inverse = {};
    for (size_t i = 0; i < N; ++i) {
        inverse[i][i] = 1;
    }
    for (size_t i = 0; i < N; ++i) {
        size_t pivot = i;
        for (size_t r = i + 1; r < N; ++r) {
            pivot = std::abs(a[r][i]) > std::abs(a[pivot][i]) ? r : pivot;
        }
        std::swap(a[i], a[pivot]);
        std::swap(inverse[i], inverse[pivot]);
        const double factor = 1 / a[i][i];
        if (!std::isfinite(factor)) {
            return false;
        }
        for (size_t c = 0; c < N; ++c) {
            a[i][c] *= factor;
            inverse[i][c] *= factor;
        }
        for (size_t r = 0; r < N; ++r) {
            const double times = r == i ? 0 : a[r][i];
            for (size_t c = 0; c < N; ++c) {
                a[r][c] -= times * a[i][c];
                inverse[r][c] -= times * inverse[i][c];
            }
        }
    }
    return true;
}

// A matrix M near the inverse of the middle of all derivatives, and how far from the identity M times them is.
template <size_t N>
struct Krawczyk {
    Contraction contraction;
    Matrix<N> inverse{};

    // Whether it contracts.
    bool operator()(const IntervalMatrix<N> &slopes);
};

// |M F' - I| <= |M middle - I| + |M| radius, and what rounding adds.
template <size_t N>
bool Krawczyk<N>::operator()(const IntervalMatrix<N> &slopes) {
    Matrix<N> centre{}, radius{};
    for (size_t i = 0; i < N; ++i) {
        for (size_t j = 0; j < N; ++j) {
            centre[i][j] = middle(slopes[i][j]);
            radius[i][j] =
                1.0001 * std::max(slopes[i][j].upper - centre[i][j], centre[i][j] - slopes[i][j].lower);
        }
    }
    contraction = {};
    if (!invert<N>(centre, inverse)) {
        return false;
    }
    double rho = 0, norm = 0;
    for (size_t i = 0; i < N; ++i) {
        double row = 0, size = 0;
        for (size_t j = 0; j < N; ++j) {
            double off = i == j ? -1 : 0, spread = 0, products = 1;
            for (size_t l = 0; l < N; ++l) {
                off += inverse[i][l] * centre[l][j];
                products += std::abs(inverse[i][l] * centre[l][j]);
                spread += std::abs(inverse[i][l]) * radius[l][j];
            }
            row += std::abs(off) + 1.0001 * spread + 8 * eps * products;
            size += std::abs(inverse[i][j]);
        }
        rho = std::max(rho, row);
        norm = std::max(norm, 1.0001 * size);
    }
    if (std::isfinite(rho) && std::isfinite(norm)) {
        contraction = {rho, norm};
    }
    return contraction.proven();
}

} // namespace nrb::intersect
