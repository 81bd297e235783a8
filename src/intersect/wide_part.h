// SPDX-License-Identifier: MIT
// Parts of polynomials with a room around them.
#pragma once

#include "bernstein/de_casteljau.h"
#include "pieces/tree/patch_kernel.h"

#include <algorithm>
#include <vector>

namespace nrb::intersect {

// Polynomials go on beyond their pieces. What is proven of a part is proven of this much more of it on all sides, in parts
// of its length.
constexpr double widening = 1.0 / 8;
// Where parts are halved: what is symmetric meets in curves along middles, which would run along sides of boxes.
constexpr double place_of_halves = 0.5 - 0x1.5p-6;
constexpr double least_length_of_parts = 0x1p-31; // in parts of pieces

// Of Bernstein coefficients [degree + 1] those between two places: [degree + 1][degree + 1].
inline std::vector<double> part_matrix(int degree, double lower, double upper) {
    const auto n = static_cast<size_t>(degree) + 1;
    std::vector<double> matrix(n * n);
    pieces::part_matrix(degree, lower, upper, matrix.data());
    return matrix;
}

// A matrix on the coefficients along an axis; `to` does not overlap `from`.
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
