// SPDX-License-Identifier: MIT
// Several periods of a periodic axis as an ordinary axis.
#pragma once

#include "basis/knot_vector.h"

#include <cstdint>

namespace nrb::refine {

// The axis over its periods first, ..., end - 1, not clamped; period 0 is its domain. Layer i of the result
// is layer i modulo distinct_layers() of the periodic axis. Equal knots get equal copies; other knots are
// shifted by a multiple of the period, rounded once. Preconditions: the axis is periodic, first < end, and
// the magnitude of both is at most 2^52. Throws Status::periodic_knots if rounding makes too many knots
// equal, not_representable, overflow.
KnotVectorPtr over_periods(const KnotVector &axis, int64_t first, int64_t end);

} // namespace nrb::refine
