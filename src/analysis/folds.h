// SPDX-License-Identifier: MIT
// Whether a surface or volume folds over.
#pragma once

#include "spline/spline.h"

#include <array>
#include <optional>

namespace nrb::analysis {

enum Fold : int32_t {
    fold_none = 0,  // proven: there is none
    fold_found,     // proven: there is one
    fold_undecided, // neither
};

struct FoldTest {
    int32_t result = 0; // one of the fold_ constants
    std::optional<std::array<double, max_axes>> positive;
    std::optional<std::array<double, max_axes>> negative;
};

// Examines the signs of Bernstein coefficients of the determinant J; where they differ, of its halves.
// Factors of J that vanish to rounding on boundaries of pieces are divided out. The reference is for a
// surface in space; null: its vector area. Throws Status::direction, not_representable.
FoldTest fold_test(const Spline &spline, const double *reference);

} // namespace nrb::analysis
