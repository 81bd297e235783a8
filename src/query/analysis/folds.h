// Whether a surface or volume folds over.
#pragma once

#include "spline/spline.h"

#include <array>
#include <optional>

namespace nrb {

struct FoldTest {
    int32_t result = 0; // one of the NURBS_FOLD_ constants
    std::optional<std::array<double, max_axes>> positive;
    std::optional<std::array<double, max_axes>> negative;
};

// The signs of Bernstein coefficients of the determinant J, whose factors that vanish on boundaries of pieces
// to rounding are divided out, and of halves where they differ. The reference, of a surface in space, null:
// its vector area. Throws NURBS_ERROR_DIRECTION, _NOT_REPRESENTABLE.
FoldTest fold_test(const Spline &spline, const double *reference);

} // namespace nrb
