// SPDX-License-Identifier: MIT
// The normal equations of a spline over given knots, from statistics of the data.
#pragma once

#include "fit/least_squares/stencil_matrix.h"
#include "fit/statistics/statistics.h"

#include <vector>

namespace nrb::fit {

// The normal equations matrix x = right of the minimum of sum_i w_i |y_i - s(t_i)|^2 over the control points
// x of s, in double-double precision. Values and weights are in units of their scales, so that nothing
// overflows.
struct NormalEquations {
    std::vector<KnotVectorPtr> axes;
    StencilMatrix matrix;
    std::vector<DoubleDouble> right;   // [unknowns][dim]
    std::vector<DoubleDouble> squares; // [dim]: sum w_i y_i^2
    std::vector<double> support; // [unknowns]: the sum of the weights where the function does not vanish
    DoubleDouble weight;         // sum w_i
    int64_t data_count;
    int dim;
};

// Throws what FitAxis throws. The error of the matrix is at most `support` times 2^-61 for each axis and
// degree, and that of the other sums likewise.
NormalEquations normal_equations(const Statistics &statistics, const std::vector<KnotVectorPtr> &axes,
                                 const Index &least_reach = {});

} // namespace nrb::fit
