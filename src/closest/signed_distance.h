// SPDX-License-Identifier: MIT
// Distances from a plane curve, with a sign for its sides.
#pragma once

#include "closest/closest.h"

namespace nrb::closest {

// As closest_points(), with distances that are positive to the left of the curve. Precondition: a curve of
// dimension 2; out.feet is not wanted.
void signed_distances(const Spline &curve, const ConstRecords &points, const Query &query,
                      const FeetOutputs &out);

} // namespace nrb::closest
