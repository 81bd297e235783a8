// Blended volumes whose denominators are functions of more than one parameter.
#pragma once

#include "spline/spline.h"

#include <vector>

namespace nrb::build {

// The volume of volume_coons() as the sum of its 6 + 12 + 8 terms: those with one denominator are added up
// first, and each of these sums is multiplied by the denominators of the others. The edges are those of the
// face that comes first, as are the corners, so that where faces differ the later ones are missed by up to
// the gap. Degrees are the sum of those of all denominators that differ, of faces and edges, and 1. Throws
// Status::gap, degree, weights_vanish and what product() throws. Precondition: 6 surfaces of the same
// dimension. Cost: that of the products.
SplinePtr sum_of_blends(const std::vector<SplinePtr> &faces, double tolerance);

} // namespace nrb::build
