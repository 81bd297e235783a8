// SPDX-License-Identifier: MIT
// Several periods of a periodic axis as a plain one.
#pragma once

#include "basis/knot_vector.h"

#include <cstdint>

namespace nrb::refine {

// The axis over its periods first, ..., end - 1, not clamped; period 0 is its domain. Layer i is layer i
// modulo distinct_layers() of the periodic axis. Equal knots have equal copies; other knots are n periods
// away, rounded once. Preconditions: the axis is periodic, first < end, both of at most 2^52. Throws
// Status::periodic_knots if rounding makes too many knots equal, not_representable, overflow.
KnotVectorPtr over_periods(const KnotVector &axis, int64_t first, int64_t end);

} // namespace nrb::refine
