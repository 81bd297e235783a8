// SPDX-License-Identifier: MIT
// How far a spline is from the offset of a curve or a surface, with proof.
#pragma once

#include "fit/offset/offset_curve.h"
#include "spline/spline.h"

#include <array>
#include <vector>

namespace nrb::fit {

// Bounds of |R - (S + d N)| at equal parameters over each of the pieces between breaks, last axis fastest; infinite where there is
// none. The difference v = R - S has a part b along the surface and one a along N, so that |R - (S + d N)| = |(a - d, b)|. With
// E, F, G the coefficients of the first fundamental form,
//     |b|^2 = (G (v S_u)^2 - 2 F (v S_u)(v S_v) + E (v S_v)^2) / (E G - F^2),   a^2 - d^2 = (v^2 - d^2) - |b|^2
// and all of these are quotients of polynomials whose Bernstein coefficients bound them. Preconditions: surfaces of dimension 3; the
// breaks hold all knots of both in their common domain.
std::vector<double> offset_bounds(const Spline &surface, double distance, const Spline &candidate,
                                  const std::array<std::vector<double>, 2> &breaks);

// The same of |R - (C + d N)|, where b is the part of v = R - C across N: with n = V x C',
//     |b| = |v x n| / |n|
std::vector<double> offset_bounds(const Spline &curve, const CurveOffset &offset, const Spline &candidate,
                                  const std::vector<double> &breaks);

} // namespace nrb::fit
