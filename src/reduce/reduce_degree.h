// SPDX-License-Identifier: MIT
// Degree reduction by least squares on control points: D. Lutterkort, J. Peters, U. Reif, "Polynomial degree
// reduction in the L2-norm equals best Euclidean approximation of Bezier coefficients", CAGD 16 (1999).
#pragma once

#include "reduce/reduce_knots.h"

namespace nrb::reduce {

// The closest spline of lower degree, where control points are compared after elevating it again. It has the
// knots of nurbs_reduce_degree() and the same clamped ends. Throws Status::times, degree, weight_sign,
// periodic_knots, not_representable.
Reduced reduce_degree(const SplinePtr &spline, int axis, int64_t times);

// The same without the bound; null where reduce_degree() throws Status::weight_sign, or if no weight is left
// somewhere.
SplinePtr lower_degree_if_valid(const SplinePtr &spline, int axis, int times);

} // namespace nrb::reduce
