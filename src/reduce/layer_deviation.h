// SPDX-License-Identifier: MIT
// How far apart two splines of the same degrees are, when their knots differ a little.
#pragma once

#include "spline/spline.h"

namespace nrb::reduce {

// An upper bound of |a(t) - b(t)| over the domain, in the Euclidean norm. Both are refined to the union of
// their knots, clamped. With control points P_i, Q_i and weights v_i, w_i there,
//
//     a - b = sum N_i (v_i P_i - w_i Q_i - b (v_i - w_i)) / sum N_i v_i
//           = sum N_i v_i ((P_i - Q_i) + (1 - w_i / v_i) (Q_i - b)) / sum N_i v_i,
//
// so that the largest |P_i - Q_i| + |1 - w_i / v_i| r_i is a bound, r_i the distance from Q_i to the farthest
// control point of b that is active together with it: b lies in their hull wherever N_i > 0. The rounding of
// the refinement is added, but on axes whose layers are copied: a row of n + 1 coefficients that are within 3
// n eps of themselves, n <= degree, gives a point within (3.5 n + 1) eps of the largest one, on each axis and
// for both splines, twice that where weights divide. Unless all weights of either are positive, or all
// negative, it is the upper bound of deviation() of bounds/deviation.h, which costs more, and has rounding
// even where nothing moved. Preconditions: same number of axes, degrees, dimension and form, and the same
// domain on every axis.
double deviation_bound(const SplinePtr &a, const SplinePtr &b);

// An upper bound of |dg/dt| along an axis, and with it of how far points move for each unit by which the
// parameter does: with homogeneous points A, w about any centre c
//
//     g' = ((A - c w)' - (g - c) w') / w,
//
// at most the largest control points of the numerator's parts by the smallest weight. Infinite unless all
// weights are positive, and at jumps.
double speed_bound(const Spline &given, int axis);

} // namespace nrb::reduce
