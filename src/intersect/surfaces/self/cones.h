// SPDX-License-Identifier: MIT
// Injectivity of a surface from the cones of its derivatives, projected to a plane (cone tests).
#pragma once

#include "intersect/surfaces/self/tangents.h"

namespace nrb::intersect {

// Whether a plane is found that proves S injective on the rectangle of the domain that the parts cover. Let
// x, y be two places in the rectangle, and P and Q the means of S_u and S_v along the segment between them.
// Then
//     S(x) - S(y) = P (x - y)_0 + Q (x - y)_1.
// Let (p, q) be coordinates in the plane to which S is projected. If p > 0 and q / p is in [a, b] for S_u,
// and q > 0 and p / q is in [c, d] for S_v everywhere, the same holds for P and Q, since these conditions
// define convex cones. If all products of a number in [a, b] and one in [c, d] are less than 1, the
// determinant of P and Q is positive, so that S(x) = S(y) only if x = y. The lengths of the derivatives do
// not matter.
bool are_cones_apart(const std::vector<Tangents> &parts);

// The same on a rectangle with a pole: a side, say v = 0, that is one point O, at which S_u vanishes. Polar
// coordinates about O in the plane, the angle t and the length r of S - O, replace (p, q) above. The
// derivatives of (t, log r) by u and v are in cones, whose quotients are
//     (log r)_u / t_u = cot of the angle from S - O to S_u,
//     t_v / (log r)_v = tan of the angle from S - O to S_v.
// If t_u > 0, (log r)_v > 0 and all products of two such quotients are less than 1, (t, log r) is injective.
// So is S, except at the pole, if t covers less than one turn, or exactly one where the surface closes along
// u.
//
// columns: each consists of parts from the pole, side `end` of `axis`, outwards; the columns lie side by side
// along the other axis. closed: they cover the whole of that axis, along which the surface closes.
bool are_polar_cones_apart(const std::vector<std::vector<Tangents>> &columns, size_t axis, size_t end,
                           bool closed);

} // namespace nrb::intersect
