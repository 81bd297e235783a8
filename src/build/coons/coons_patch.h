// SPDX-License-Identifier: MIT
// The Boolean sum of two blends, which is a Coons patch (S. A. Coons 1967; W. J. Gordon 1969), as a
// tensor-product surface.
#pragma once

#include "build/coons/blend_axis.h"
#include "build/coons/corner.h"

namespace nrb::build {

// With blending functions f_i(u), g_j(v) for the values and derivatives i, j at the ends,
//
//     S(u, v) = sum_i f_i(u) A_i(v) + sum_j g_j(v) (B_j(u) - sum_i f_i(u) m_ij),
//
// where the A_i are S(u0, v), S(u1, v), S_u(u0, v), S_u(u1, v), the functions of the axis `v`, the B_j are
// likewise the functions of the axis `u`, and m_ij is what A_i and B_j have in common at a corner. `own` is
// what the given functions have at the corners. Functions that differ from m there are corrected first: the
// difference times g_j is added to A_i, the difference times f_i to B_j. The layers of control points at an
// edge are those of the boundary over the knots of the surface, and the corners are the points of m; the
// layers next to an edge depend only on its boundary and cross tangent. Throws Status::overflow,
// not_representable, and what make_result() throws. Cost: order + order products for each coordinate of the
// net, where the order is 2 or 4.
SplinePtr coons_patch(BlendAxis u, BlendAxis v, const CornerPair &own, const CornerMatrix &m, Form form);

} // namespace nrb::build
