// SPDX-License-Identifier: MIT
// Conversion of places on pieces to parameters, and the part of a piece that a query asks for.
#pragma once

#include "closest/foot.h"
#include "closest/patch/patch_descent.h"

namespace nrb::closest {

// The box of local parameters of a piece, along the axes of the shape, that lies in the range of a query.
PatchBox box_in_range(const PieceGrid &pieces, int64_t piece, const Interval *range) noexcept;

// The parameters of a place in a piece, their one-sided limits, and whether they are on the boundary.
Foot foot_at(const PieceGrid &pieces, int64_t piece, const AxisValues &at, const Interval *range) noexcept;
// Whether the parameters of two feet differ by rounding only.
bool near_params(const PieceGrid &pieces, const Foot &a, const Foot &b) noexcept;
// closest_boundary or 0.
int32_t boundary_bit(const PieceGrid &pieces, const Foot &foot, const Interval *range) noexcept;

} // namespace nrb::closest
