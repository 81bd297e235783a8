// SPDX-License-Identifier: MIT
// A part of a surface, cut out without arithmetic.
#pragma once

#include "spline/spline.h"

#include <vector>

namespace nrb::fit {

// The control points that are active between the first and the last of rising parameters of the first axis,
// with their knots: bit for bit the same surface there, over a domain that contains these parameters. Cost:
// linear in the size of the part, whatever the size of the surface.
SplinePtr band_of(const Spline &surface, const std::vector<double> &params);

} // namespace nrb::fit
