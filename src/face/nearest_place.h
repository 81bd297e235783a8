// SPDX-License-Identifier: MIT
// What is known of a surface beyond its spline.
#pragma once

#include "face/covering.h"

#include <functional>

namespace nrb::face {

// The parameters, in the domain, of the point of a surface that is nearest to a point in space; empty if that has to be searched for.
using NearestPlace = std::function<Point2(const double *point)>;

} // namespace nrb::face
