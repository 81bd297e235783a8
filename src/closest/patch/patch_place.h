// SPDX-License-Identifier: MIT
// Places on pieces as parameters, and the part of a piece that a query asks for.
#pragma once

#include "closest/foot.h"
#include "closest/patch/patch_descent.h"

namespace nrb::closest {

// The box in a piece, along the axes of the shape, that is in the range of a query.
PatchBox box_in_range(const PieceGrid &pieces, int64_t piece, const Interval *range) noexcept;

// Parameters, sides and whether they are on the boundary, of a place in a piece.
Foot foot_at(const PieceGrid &pieces, int64_t piece, const AxisValues &at, const Interval *range) noexcept;
// Whether two places differ by rounding only.
bool near_params(const PieceGrid &pieces, const Foot &a, const Foot &b) noexcept;
// closest_boundary or 0.
int32_t boundary_bit(const PieceGrid &pieces, const Foot &foot, const Interval *range) noexcept;

} // namespace nrb::closest
