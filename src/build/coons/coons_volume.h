// SPDX-License-Identifier: MIT
// Coons volumes: volumes from their six faces by transfinite interpolation.
#pragma once

#include "spline/spline.h"

#include <vector>

namespace nrb::build {

// See nurbs_volume_coons(). Let f_a, g_b, h_c be the linear blending functions of axes 0, 1 and 2, F_a, G_b,
// H_c the faces at the ends of these axes, E the edges and V the corners. Then (W. J. Gordon, C. A. Hall
// 1973)
//
//     V(u, v, w) = sum_a f_a F_a + sum_b g_b (G_b - sum_a f_a E_ab)
//                  + sum_c h_c (H_c - sum_a f_a E_ac - sum_b g_b (E_bc - sum_a f_a V_abc)).
//
// Every edge is the mean of the edges of the two faces that meet there, and faces with other edges are
// corrected first. The outer layers of control points are those of the faces over the knots of the volume.
// All this needs weights of faces that are products of one function for each axis; for others the terms are
// summed up one by one (blend_sum.h). Throws Status::axes, dimension, gap, weights_vanish for a corner at
// infinity, and what make_blend_axis(), sum_of_blends() and make_result() throw. Precondition: 6 faces. Cost:
// linear in the points of the result.
SplinePtr volume_coons(const std::vector<SplinePtr> &faces, double tolerance);

} // namespace nrb::build
