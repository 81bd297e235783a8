// SPDX-License-Identifier: MIT
// The shape of Bezier patches in searches for nearest points: homogeneous coefficients along the axes of
// degree > 0.
#pragma once

#include "bernstein/products.h"

#include <array>
#include <cstdint>

namespace nrb::pieces {

// Patches with more coefficients are not squared: it is not worth its cost.
inline constexpr int64_t most_squared = 1024;

// Coefficients [0, coefficients) of `lanes` doubles, last axis fastest: (x, y, ..., w, 0, ...), where lanes
// is a multiple of 4. A polynomial patch has w = 1.
struct PatchShape {
    int axes = 0; // number of axes of degree > 0
    std::array<int, max_axes> degrees{};
    int dim = 0;
    int lanes = 0;
    bool weighted = false;

    [[nodiscard]] int64_t coefficients() const noexcept {
        int64_t count = 1;
        for (int k = 0; k < axes; ++k) {
            count *= degrees[static_cast<size_t>(k)] + 1;
        }
        return count;
    }
    [[nodiscard]] int64_t values() const noexcept { return coefficients() * lanes; }
    // Number of coefficients of products of two such polynomials.
    [[nodiscard]] int64_t products() const noexcept {
        int64_t count = 1;
        for (int k = 0; k < axes; ++k) {
            count *= 2 * degrees[static_cast<size_t>(k)] + 1;
        }
        return count;
    }
    [[nodiscard]] int degree(int k) const noexcept { return degrees[static_cast<size_t>(k)]; }
};

// One number for each axis.
using AxisValues = std::array<double, max_axes>;

} // namespace nrb::pieces
