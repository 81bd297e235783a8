// SPDX-License-Identifier: MIT
// The axes of a spline, extended to what a curve in its parameter space visits.
#pragma once

#include "refine/compose/crossings.h"

#include <vector>

namespace nrb::refine {

// The polynomial pieces of a curve. The curve must outlive them.
std::vector<CurvePiece> pieces_of(const Spline &f);

// The axes of g; a periodic axis whose domain the curve leaves is unrolled over all periods that the curve
// visits. Throws Status::outside_domain if these are more than 65536, or if one of them is more than 2^52
// periods away.
Spline::Axes axes_under(const Spline &g, const std::vector<CurvePiece> &pieces);

} // namespace nrb::refine
