// SPDX-License-Identifier: MIT
// Jets of an offset surface: its points with the derivatives that a patch takes.
#pragma once

#include "fit/offset/taylor.h"
#include "spline/spline.h"

#include <vector>

namespace nrb::fit {

// The sine of the angle between two directions below which rounding decides about their common normal.
inline constexpr double least_sine = 1e-9;

// O = S + d N with the unit normal N = S_u x S_v / |S_u x S_v|, at all combinations of the parameters, last
// axis fastest. left[k]: the limit from below on axis k. Throws Status::unsupported where S_u and S_v are
// parallel, or one of them is 0. Precondition: dimension 3.
std::vector<TaylorVector> offset_jets(const Spline &surface, double distance,
                                      const std::array<std::vector<double>, 2> &params,
                                      const std::array<bool, 2> &left);

} // namespace nrb::fit
