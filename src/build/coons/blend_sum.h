// SPDX-License-Identifier: MIT
// Blended volumes whose denominators are functions of more than one parameter.
#pragma once

#include "spline/spline.h"

#include <vector>

namespace nrb::build {

// The volume of volume_coons() as the sum of its 6 + 12 + 8 terms: terms with one denominator are added up
// first, and each of these sums is multiplied by the denominators of the others. Edges and corners are taken
// from the face that comes first, so that where faces differ the later ones are missed by up to the gap.
// Degrees are the sum of the degrees of all denominators that differ, of faces and edges, plus 1. Throws
// Status::gap, degree, weights_vanish and what product() throws. Precondition: 6 surfaces of the same
// dimension. Cost: that of the products.
SplinePtr sum_of_blends(const std::vector<SplinePtr> &faces, double tolerance);

} // namespace nrb::build
