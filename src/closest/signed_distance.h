// SPDX-License-Identifier: MIT
// Signed distances from a plane curve.
#pragma once

#include "closest/closest.h"

namespace nrb::closest {

// As closest_points(), but distances are positive to the left of the curve and negative to its right.
// Precondition: the curve has dimension 2. out.feet is not used; out.distances is required.
void signed_distances(const Spline &curve, const ConstRecords &points, const Query &query,
                      const FeetOutputs &out);

} // namespace nrb::closest
