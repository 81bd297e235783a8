// SPDX-License-Identifier: MIT
// Antiderivatives of polynomial splines.
#pragma once

#include "spline/spline.h"

namespace nrb::refine {

// The integral of a polynomial spline along an axis, from the lower end of its domain. The degree is one
// higher, and the knots are the same except that the first and the last one occur once more. A periodic axis
// becomes an ordinary one. Successive layers differ by S_i = P_i (t_(i+p+1) - t_i) / (p + 1) (de Boor, "A
// Practical Guide to Splines", X). Each S_i has 3 roundings and their sum is compensated, so layer j is
// within 2 eps of the sum of the |S_i| before it. If the start is not clamped, the first layer is a sum of
// S_i as well. Throws Status::rational, degree, not_representable, overflow. Cost: linear in the number of
// points.
SplinePtr antiderivative(const Spline &spline, int axis);

} // namespace nrb::refine
