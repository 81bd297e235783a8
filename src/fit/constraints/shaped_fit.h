// SPDX-License-Identifier: MIT
// Fits of a prescribed shape.
#pragma once

#include "fit/constraints/conditions.h"
#include "fit/constraints/shape.h"
#include "fit/least_squares/smoothing.h"

namespace nrb::fit {

// From the minimum without a shape, that with it, for the same factor of the penalty. `data`: equations without conditions;
// `equations`: the same with the squares of the conditions, which hold for the result.
// Throws what Inequalities does.
void impose_shape(const NormalEquations &data, const NormalEquations &equations, const StencilMatrix *penalty,
                  double lambda, const std::vector<LinearRow> &conditions, const ShapeWishes &wishes,
                  Smoothed &found);

} // namespace nrb::fit
