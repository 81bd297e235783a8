// SPDX-License-Identifier: MIT
// Parts of polynomial pieces, widened by a margin.
#pragma once

#include "bernstein/de_casteljau.h"
#include "pieces/tree/patch_kernel.h"

#include <algorithm>
#include <vector>

namespace nrb::intersect {

// A polynomial extends beyond its piece. What is proven of a part is proven of the wide part: the part with
// this share of its length added on every side.
constexpr double widening = 1.0 / 8;
// Where parts are halved, as a share of their length. It is not the middle, because symmetric shapes often
// intersect along isoparametric lines in the middle, and such curves would run along the sides of boxes.
constexpr double place_of_halves = 0.5 - 0x1.5p-6;
constexpr double least_length_of_parts = 0x1p-31; // as a share of the piece

// The matrix [degree + 1][degree + 1] that maps Bernstein coefficients [degree + 1] over [0, 1] to those over
// [lower, upper].
inline std::vector<double> part_matrix(int degree, double lower, double upper) {
    const auto n = static_cast<size_t>(degree) + 1;
    std::vector<double> matrix(n * n);
    pieces::part_matrix(degree, lower, upper, matrix.data());
    return matrix;
}

// Applies such a matrix to the coefficients along one axis. `to` must not overlap `from`.
inline void apply_along(const std::vector<double> &matrix, const AxisLayers &layers, const double *from,
                        double *to) {
    const auto n = static_cast<size_t>(layers.degree) + 1, inner = static_cast<size_t>(layers.inner);
    for (int64_t o = 0; o < layers.outer; ++o) {
        for (size_t r = 0; r < n; ++r, to += inner) {
            std::fill_n(to, inner, 0.0);
            for (size_t j = 0; j < n; ++j) {
                const double factor = matrix[r * n + j], *layer = from + j * inner;
                for (size_t c = 0; c < inner; ++c) {
                    to[c] += factor * layer[c];
                }
            }
        }
        from += n * inner;
    }
}

} // namespace nrb::intersect
