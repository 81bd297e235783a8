// SPDX-License-Identifier: MIT
// Coons volumes of faces whose weights are not products of one factor for each axis.
#pragma once

#include "spline/spline.h"

#include <vector>

namespace nrb::build {

// The volume of volume_coons() as the sum of its 6 + 12 + 8 terms, for faces, edges and corners. Terms with
// the same denominator are added first; each of these sums is then multiplied by the denominators of the
// others. Edges and corners are taken from the first of the faces that share them, so where faces differ, the
// volume misses the later ones by up to the gap. Degrees are the sum of the degrees of all distinct
// denominators, of faces and edges, plus 1. Throws Status::gap, degree, weights_vanish and what product()
// throws. Precondition: 6 surfaces of the same dimension. Cost: that of the products.
SplinePtr sum_of_blends(const std::vector<SplinePtr> &faces, double tolerance);

} // namespace nrb::build
