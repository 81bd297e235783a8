// SPDX-License-Identifier: MIT
// Volumes from their faces.
#pragma once

#include "spline/spline.h"

#include <vector>

namespace nrb::build {

// See nurbs_volume_coons(). With f_a, g_b, h_c the linear blending functions of the axes, F, G, H the faces,
// E the edges and V the corners (W. J. Gordon, C. A. Hall 1973),
//
//     V(u, v, w) = sum_a f_a F_a + sum_b g_b (G_b - sum_a f_a E_ab)
//                  + sum_c h_c (H_c - sum_a f_a E_ac - sum_b g_b (E_bc - sum_a f_a V_abc)),
//
// every face corrected first where its edges are not the means of both that meet there. The outer layers of
// control points are those of the faces over the knots of the volume. This needs weights of faces that are
// products of one function for each axis; others are summed up term by term (blend_sum.h). Throws
// Status::axes, dimension, gap, weights_vanish for a corner at infinity, and what make_blend_axis(),
// sum_of_blends() and make_result() throw. Precondition: 6 faces. Cost: linear in the points of the result.
SplinePtr volume_coons(const std::vector<SplinePtr> &faces, double tolerance);

} // namespace nrb::build
