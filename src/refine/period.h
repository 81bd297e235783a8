// The knots of a periodic axis beyond those that it stores.
#pragma once

#include "basis/knot_vector.h"

#include <vector>

namespace nrb {

// The stored knots with `lead` more on either side, each a period away from one that is known. Knots that are
// equal have equal copies, whatever the rounding. Throws NURBS_ERROR_NOT_REPRESENTABLE when a knot overflows.
// Precondition: the axis is periodic.
std::vector<double> extended_knots(const KnotVector &axis, int64_t lead);

} // namespace nrb
