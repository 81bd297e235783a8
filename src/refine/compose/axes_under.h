// SPDX-License-Identifier: MIT
// What a curve in the parameter space of a spline runs over.
#pragma once

#include "refine/compose/crossings.h"

#include <vector>

namespace nrb::refine {

// The pieces of a curve, which must outlive them.
std::vector<CurvePiece> pieces_of(const Spline &f);

// The axes of g under a curve; periodic ones that it leaves, over all periods that it runs through. Throws Status::outside_domain for
// more than 65536 of them, or any that is more than 2^52 periods away.
Spline::Axes axes_under(const Spline &g, const std::vector<CurvePiece> &pieces);

} // namespace nrb::refine
