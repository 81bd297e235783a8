// SPDX-License-Identifier: MIT
// Knots for interpolation, from the parameters of the data and the end conditions.
#pragma once

#include "basis/knot_vector.h"

#include <array>
#include <span>

namespace nrb::fit {

enum class End : int32_t { not_a_knot, natural, averaged };

// The end conditions at the start and at the end of an axis.
using Ends = std::array<End, 2>;

// Knots for strictly increasing parameters. `derivatives` are the numbers of derivatives given at the start
// and at the end; `axis` is the number of the axis in messages.
// - not_a_knot, natural: inner knots at the parameters, for even degrees midway between them, and a knot of
//   multiplicity degree + 1 at each end. At an end that is not_a_knot, the first degree / 2 inner knots are
//   left out, so that there are as many control points as data; one of these knots is kept for each
//   derivative that is given there. At a natural end (odd degrees) none is left out. This leaves
//   (degree - 1) / 2 conditions to be added: the derivatives of orders (degree + 1) / 2 to degree - 1 vanish.
// - averaged (at both ends, without derivatives): each inner knot is the mean of `degree` consecutive
//   parameters.
// - periodic axes: as above, with a knot for each parameter but the last, which ends the period.
// Throws Status::too_few_points, degree, rule, order if more derivatives are given at an end than knots are
// left out there, and what make_knot_vector() throws.
KnotVectorPtr interpolation_knots(int degree, std::span<const double> params, Ends ends, bool periodic,
                                  int axis, std::array<int, 2> derivatives = {});

// How many conditions a natural end adds.
constexpr int conditions_at(End end, int degree) noexcept {
    return end == End::natural ? (degree - 1) / 2 : 0;
}

} // namespace nrb::fit
