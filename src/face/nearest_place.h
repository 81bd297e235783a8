// SPDX-License-Identifier: MIT
// What is known of a surface beyond its spline.
#pragma once

#include "face/covering.h"

#include <functional>

namespace nrb::face {

// Inverts the parametrization of a surface: gives the parameters, in the domain, of its point nearest to a
// point in space. Empty if nearest points have to be searched for.
using NearestPlace = std::function<Point2(const double *point)>;

} // namespace nrb::face
