// SPDX-License-Identifier: MIT
// Bounds of the distance between two splines of equal degrees whose knots differ slightly.
#pragma once

#include "spline/spline.h"

namespace nrb::reduce {

// An upper bound of |a(t) - b(t)| over the domain, in the Euclidean norm. Both splines are refined to the
// union of their knots, clamped. With their control points P_i, Q_i and weights v_i, w_i there,
//
//     a - b = sum N_i (v_i P_i - w_i Q_i - b (v_i - w_i)) / sum N_i v_i
//           = sum N_i v_i ((P_i - Q_i) + (1 - w_i / v_i) (Q_i - b)) / sum N_i v_i.
//
// So the largest |P_i - Q_i| + |1 - w_i / v_i| r_i is a bound, where r_i is the distance from Q_i to the
// farthest control point of b that is active together with it: b lies in their convex hull wherever N_i > 0.
//
// The rounding of the refinement is added, except on axes whose layers are only copied: a row of n + 1
// coefficients with relative errors within 3 n eps, n <= degree, gives a point with an error within
// (3.5 n + 1) eps of the largest one, on each axis and for both splines, and twice that where weights divide.
//
// Unless the weights of both splines are all positive, or all negative, the result is the upper bound of
// deviation() in bounds/deviation.h, which costs more, and includes rounding even where nothing moved.
// Preconditions: same number of axes, degrees, dimension and form, and the same domain on every axis.
double deviation_bound(const SplinePtr &a, const SplinePtr &b);

// An upper bound of |dg/dt| along an axis, and so of how far points move for each unit by which the parameter
// changes. With homogeneous points A, w about any centre c
//
//     g' = ((A - c w)' - (g - c) w') / w,
//
// which is bounded by the largest control points of the terms of the numerator, divided by the smallest
// weight. Infinite at jumps, and unless all weights are positive.
double speed_bound(const Spline &given, int axis);

} // namespace nrb::reduce
