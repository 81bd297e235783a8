// SPDX-License-Identifier: MIT
// Lengths of tangents of which only the directions are known.
#pragma once

#include "fit/axis_interpolation.h"

#include <span>
#include <vector>

namespace nrb::fit {

// The factors of targets[n][dim], the right-hand sides of the conditions of the axis. They are 1 except for
// the first derivatives at `directions` (in rising order), which get those factors, of either sign, that
// minimise the integral of the squared second derivative over the pieces of the curve.
// These factors solve linear equations with a symmetric positive definite matrix of one row per direction, by
// conjugate gradients. An element of the matrix is small for tangents far apart, so that factors of the
// matrix without these elements are a good preconditioner. The number of products with the matrix, each at
// the cost of two interpolations, therefore hardly grows with the number of directions. Throws Status::rank,
// not_converged, not_representable. Precondition: the directions are not 0.
std::vector<double> tangent_lengths(const AxisInterpolation &axis, std::span<const int64_t> directions,
                                    int dim, const std::vector<double> &targets);

// Throws Status::tangent unless every tangent points along its direction and is longer than rounding errors.
void check_along(std::span<const int64_t> directions, int dim, const std::vector<double> &targets,
                 const std::vector<double> &lengths);

} // namespace nrb::fit
