// SPDX-License-Identifier: MIT
// Fits under shape constraints.
#pragma once

#include "fit/constraints/conditions.h"
#include "fit/constraints/shape.h"
#include "fit/least_squares/smoothing.h"

namespace nrb::fit {

// Moves `found` from the minimum without a shape to that with it, for the same factor of the penalty. `data`:
// the equations without conditions. `equations`: the same with the squares of the conditions, which hold for
// the result. Throws what Inequalities throws.
void impose_shape(const NormalEquations &data, const NormalEquations &equations, const StencilMatrix *penalty,
                  double lambda, const std::vector<LinearRow> &conditions, const ShapeWishes &wishes,
                  Smoothed &found);

} // namespace nrb::fit
