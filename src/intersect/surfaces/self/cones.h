// SPDX-License-Identifier: MIT
// The cones in which derivatives of a surface are, as a plane sees them.
#pragma once

#include "intersect/surfaces/self/tangents.h"

namespace nrb::intersect {

// Between two places x, y of a rectangle that parts cover S(x) - S(y) = P (x - y)_0 + Q (x - y)_1, P and Q being the means of S_u
// and S_v along the segment. If S_u and S_v, in coordinates (p, q) of a plane, have p > 0, q / p in [a, b], and q > 0, p / q in
// [c, d], so have P and Q, since that makes convex cones; and if no product of two such quotients reaches 1, P and Q have a
// positive determinant, so that S(x) = S(y) for x = y alone. How long derivatives are does not matter. Whether that holds for a plane
// that fits.
bool are_cones_apart(const std::vector<Tangents> &parts);

// At a side that is one point O (say v = 0) S_u vanishes. There polar coordinates about O, of points as a plane sees them, take
// the place of these of the plane: for S - O, with the angle t and the length r, the derivatives of t and log r by u and v are in
// cones as above, of which the quotients are
//     (log r)_u / t_u = cot of the angle from S - O to S_u,   t_v / (log r)_v = tan of the angle from S - O to S_v:
// if t_u > 0, (log r)_v > 0 and no product reaches 1, (t, log r) are different for different places. So are points, if t goes
// round by less than one turn, or by just one where the surface closes.
//
// Columns of parts begin at the side, `end` of `axis`, and lie side by side along the other axis. closed: they are all there is of the
// surface along that, and the last one goes on in the first one. Whether that holds for a plane that fits.
bool are_polar_cones_apart(const std::vector<std::vector<Tangents>> &columns, size_t axis, size_t end,
                           bool closed);

} // namespace nrb::intersect
