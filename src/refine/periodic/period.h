// SPDX-License-Identifier: MIT
// The knots of a periodic axis beyond the stored period.
#pragma once

#include "basis/knot_vector.h"

#include <vector>

namespace nrb::refine {

// Overwrites the knots before `first` and after `last`, which are one period of `step` knots apart, by copies
// of known knots a period away. Equal knots get equal copies, whatever the rounding. Throws
// Status::not_representable if a knot overflows. Precondition: first + step == last < knots.size().
void continue_knots(std::vector<double> &knots, size_t first, size_t last, size_t step);

// The stored knots with `lead` more on either side, made in the same way. Throws Status::not_representable if
// a knot overflows. Precondition: the axis is periodic.
std::vector<double> extended_knots(const KnotVector &axis, int64_t lead);

} // namespace nrb::refine
