// SPDX-License-Identifier: MIT
// Least-squares fits of splines to data.
#pragma once

#include "fit/constraints/conditions.h"
#include "fit/constraints/shape.h"
#include "fit/least_squares/misfit.h"
#include "fit/least_squares/smoothing.h"
#include "spline/spline.h"

#include <vector>

namespace nrb::fit {

enum class Robust : int32_t { none, huber, tukey };

struct FitWishes {
    Smoothing smoothing = Smoothing::none;
    double value = 0;        // lambda, or the target of Smoothing::discrepancy
    int penalty_order = 2;   // order of the derivative that is penalised
    bool regularise = false; // of all minima take that of the smallest penalty
    std::vector<FitCondition> conditions;
    ShapeWishes shape;
    Robust robust = Robust::none; // for fits of points only
    double width = 0;             // of its weight function, 0: the usual one
};

struct Fitted {
    SplinePtr spline;
    Misfit misfit;
    double lambda;   // of the penalty
    double freedom;  // trace of the influence matrix
    double residual; // of the equations, relative to their right sides
    bool reached;    // whether the target was reached
    bool settled;    // whether the search for a shape that the data leave open has converged
};

// The fitted spline over the axes `wanted`. Throws what normal_equations(), PenalisedSystem, Conditions,
// check_shape() and impose_shape() throw, and Status::order if there is a penalty and its order is above the
// degree of every axis.
Fitted fit(const Statistics &statistics, const std::vector<KnotVectorPtr> &wanted, const FitWishes &given);

} // namespace nrb::fit
