// SPDX-License-Identifier: MIT
// Where curves of a domain turn back.
#pragma once

#include "spline/spline.h"

#include <vector>

namespace nrb::face {

// The parameters, ascending, at which both coordinates of a curve reverse at once, as at a cusp. A search for
// intersections has to take the curve before and after such a place as two curves. The two coordinates may
// reverse at parameters that differ by little more than rounding.
std::vector<double> places_of_return(const Spline &curve);

} // namespace nrb::face
