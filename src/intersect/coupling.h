// SPDX-License-Identifier: MIT
// A componentwise Krawczyk bound for nonlinear equations: how far zeros can be apart, unknown by unknown.
#pragma once

#include "intersect/contraction.h"
#include "intersect/intervals.h"

#include <algorithm>
#include <array>
#include <cstddef>

namespace nrb::intersect {

// Let F be N - 1 equations in N unknowns z, one of which, z_k, is held fixed; y denotes the others. R bounds
// |I - M F'| entry by entry, with row and column k equal to 0, and S bounds the column M F'_k. The mean value
// theorem gives, row by row, |(y - y0) - M (F(z) - F(z0)) + S (z_k - z0_k)| <= R |y - y0|, so that
//     |y - y0| <= (I - R)^-1 (|M (F(z) - F(z0))| + |S| |z_k - z0_k|)
// if the spectral radius of R is less than 1. I - R is then a nonsingular M-matrix and its inverse is
// nonnegative, whatever the units of the unknowns: elimination without pivoting only adds to the inverse, and
// its pivots stay above 0.
template <size_t N>
class Coupling {
public:
    [[nodiscard]] double off(size_t i, size_t j) const noexcept { return offs_[i][j]; }
    void set_off(size_t i, size_t j, double off) noexcept { offs_[i][j] = off; }
    void clear() noexcept { offs_ = {}; }
    // Computes (I - R)^-1. most: the largest diagonal entry allowed, about 1 / (1 - spectral radius); false
    // if one is larger.
    bool invert(double most) noexcept {
        std::array<Place<N>, N> left{};
        for (size_t i = 0; i < N; ++i) {
            for (size_t j = 0; j < N; ++j) {
                inverse_[i][j] = i == j ? 1 : 0;
                left[i][j] = inverse_[i][j] - offs_[i][j];
            }
        }
        for (size_t p = 0; p < N; ++p) {
            if (!eliminate(p, 1 / most, left)) {
                return false;
            }
        }
        for (size_t i = 0; i < N; ++i) {
            if (!(inverse_[i][i] <= most)) {
                return false;
            }
            for (double &x : inverse_[i]) {
                x *= 1.0001; // far more than rounding
            }
        }
        return true;
    }
    // (I - R)^-1 size.
    [[nodiscard]] Place<N> reach(const Place<N> &size) const noexcept { return product(inverse_, size); }
    // The largest row sum of R. If it is less than 1, reach_in_norm() is the bound that follows from it in
    // the maximum norm, the same for all unknowns.
    [[nodiscard]] double norm() const noexcept {
        double most = 0;
        for (const Place<N> &row : offs_) {
            double sum = 0;
            for (const double x : row) {
                sum += x;
            }
            most = std::max(most, sum);
        }
        return 1.0001 * most;
    }
    [[nodiscard]] Place<N> reach_in_norm(const Place<N> &size) const noexcept {
        Place<N> reach{};
        reach.fill(1.0001 * largest(size) / (1 - norm()));
        return reach;
    }
    // R reach.
    [[nodiscard]] Place<N> drift(const Place<N> &reach) const noexcept { return product(offs_, reach); }

private:
    using Matrix = std::array<Place<N>, N>;

    bool eliminate(size_t p, double least, Matrix &left) noexcept {
        const double pivot = left[p][p];
        if (!(pivot >= least)) {
            return false;
        }
        for (size_t j = 0; j < N; ++j) {
            left[p][j] /= pivot;
            inverse_[p][j] /= pivot;
        }
        for (size_t i = 0; i < N; ++i) {
            const double factor = left[i][p];
            for (size_t j = 0; j < N && i != p; ++j) {
                left[i][j] -= factor * left[p][j];
                inverse_[i][j] -= factor * inverse_[p][j];
            }
        }
        return true;
    }
    static Place<N> product(const Matrix &matrix, const Place<N> &by) noexcept {
        Place<N> result{};
        for (size_t i = 0; i < N; ++i) {
            for (size_t j = 0; j < N; ++j) {
                result[i] += matrix[i][j] * by[j];
            }
            result[i] *= 1.0001;
        }
        return result;
    }

    Matrix offs_{}, inverse_{};
};

} // namespace nrb::intersect
