// SPDX-License-Identifier: MIT
// Proven bounds of the distance of a spline from the offset of a curve or a surface.
#pragma once

#include "fit/offset/offset_curve.h"
#include "spline/spline.h"

#include <array>
#include <vector>

namespace nrb::fit {

// Upper bounds of |R - (S + d N)| at equal parameters on each of the pieces between breaks, last axis
// fastest, for the candidate R and the surface S with unit normal N; infinite where there is none. Let b be
// the tangential part of the difference v = R - S, and a its component along N, so that |R - (S + d N)| =
// |(a - d, b)|. With the coefficients E, F, G of the first fundamental form,
//     |b|^2 = (G (v S_u)^2 - 2 F (v S_u)(v S_v) + E (v S_v)^2) / (E G - F^2)
//     a^2 - d^2 = (v^2 - d^2) - |b|^2
// All of these are quotients of polynomials, which are bounded by their Bernstein coefficients.
// Preconditions: surfaces of dimension 3; the breaks include all knots of both splines in their common
// domain.
std::vector<double> offset_bounds(const Spline &surface, double distance, const Spline &candidate,
                                  const std::array<std::vector<double>, 2> &breaks);

// The same for |R - (C + d N)|, where b is the part of v = R - C perpendicular to N: with n = V x C',
//     |b| = |v x n| / |n|
std::vector<double> offset_bounds(const Spline &curve, const CurveOffset &offset, const Spline &candidate,
                                  const std::vector<double> &breaks);

} // namespace nrb::fit
