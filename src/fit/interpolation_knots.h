// SPDX-License-Identifier: MIT
// Knots for interpolation, from the parameters of the data and what holds at their ends.
#pragma once

#include "basis/knot_vector.h"

#include <array>
#include <span>

namespace nrb::fit {

enum class End : int32_t { not_a_knot, natural, averaged };

// What holds at the start and at the end of an axis.
using Ends = std::array<End, 2>;

// Of parameters that increase strictly, with the place of the axis and of its first parameter in the caller's arrays:
// - Knots stand at the parameters, for even degrees in the middle between them, with degree + 1 at each end. At an
//   end that is not_a_knot the first degree / 2 of the inner ones are left out, which makes as many control points as
//   there are data; of these it keeps one more for each derivative that is given there. At one that is natural (odd degrees) none, which leaves (degree - 1) / 2 conditions to be given:
//   that the derivatives of orders (degree + 1) / 2 to degree - 1 vanish.
// - averaged (at both ends, without derivatives): knots averaged from `degree` consecutive parameters.
// - periodic: the same with a knot for each parameter but the last, which ends the period.
// Throws Status::too_few_points, degree, rule, order for more derivatives than knots are left out, and what
// make_knot_vector() does.
KnotVectorPtr interpolation_knots(int degree, std::span<const double> params, Ends ends, bool periodic,
                                  int axis, std::array<int, 2> derivatives = {});

// How many conditions a natural end adds.
constexpr int conditions_at(End end, int degree) noexcept {
    return end == End::natural ? (degree - 1) / 2 : 0;
}

} // namespace nrb::fit
