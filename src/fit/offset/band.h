// SPDX-License-Identifier: MIT
// A part of a surface that needs no arithmetic.
#pragma once

#include "spline/spline.h"

#include <vector>

namespace nrb::fit {

// The control points that are active between the first and the last of rising parameters of the first axis, with their knots: the same
// surface there to the bit, over a domain that holds these parameters. Cost: linear in its size, whatever that of the surface is.
SplinePtr band_of(const Spline &surface, const std::vector<double> &params);

} // namespace nrb::fit
