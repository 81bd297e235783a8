// SPDX-License-Identifier: MIT
// How long tangents are of which only the directions are known.
#pragma once

#include "fit/axis_interpolation.h"

#include <span>
#include <vector>

namespace nrb::fit {

// Factors of targets[n][dim], of the conditions of the axis: 1, but for the first derivatives at `directions`, in
// rising order, those for which the integral over the pieces of the squared second derivative is smallest, of either sign.
// They are the solution of linear equations with a symmetric positive matrix of as many rows as directions, which is found by
// conjugate gradients: an element of it is small for tangents far apart, so that factors of the others precondition them, and
// the number of products with it, each at the cost of two interpolations, hardly grows with their number. Throws Status::rank, not_converged, not_representable.
// Precondition: directions that are not 0.
std::vector<double> tangent_lengths(const AxisInterpolation &axis, std::span<const int64_t> directions,
                                    int dim, const std::vector<double> &targets);

// Throws Status::tangent unless all tangents go along their directions, longer than rounding.
void check_along(std::span<const int64_t> directions, int dim, const std::vector<double> &targets,
                 const std::vector<double> &lengths);

} // namespace nrb::fit
