// SPDX-License-Identifier: MIT
// Points of an offset surface with the derivatives that a bicubic patch takes.
#pragma once

#include "numeric/vector3.h"
#include "spline/spline.h"

#include <vector>

namespace nrb::fit {

// The sine of the angle of two directions below which rounding decides about the normal of both.
inline constexpr double least_sine = 1e-9;

// O = S + d N with the unit normal N = S_u x S_v / |S_u x S_v|, and O_u, O_v, O_uv.
struct OffsetJet {
    Vector3 point, u, v, uv;
};

// At all combinations of parameters, last axis fastest; left[k]: the limit from below on axis k. Derivatives of N follow from those
// of n = S_u x S_v: with l = |n|
//     N_u = (n_u - l_u N) / l,   l_u = N n_u,   l_uv = (n_u n_v + N l n_uv - l_u l_v) / l
//     N_uv = (n_uv - l_u N_v - l_v N_u - l_uv N) / l
// Throws Status::unsupported where S_u and S_v are parallel or 0. Precondition: dimension 3.
std::vector<OffsetJet> offset_jets(const Spline &surface, double distance,
                                   const std::array<std::vector<double>, 2> &params,
                                   const std::array<bool, 2> &left);

} // namespace nrb::fit
