// SPDX-License-Identifier: MIT
// Splines that are closest to data, in the mean of squares.
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
    double value = 0;        // lambda or the target of Smoothing
    int penalty_order = 2;   // derivative that is penalised
    bool regularise = false; // of all minima take the one of the smallest penalty
    std::vector<FitCondition> conditions;
    ShapeWishes shape;
    Robust robust = Robust::none; // of fits of points
    double width = 0;             // of its function, 0: the usual one
};

struct Fitted {
    SplinePtr spline;
    Misfit misfit;
    double lambda;   // of the penalty
    double freedom;  // trace of the influence matrix
    double residual; // of the equations, relative to their right sides
    bool reached;    // the target
    bool settled;    // whether a shape that the data leave open is found
};

// The spline over the axes. Throws what normal_equations(), PenalisedSystem, Conditions, check_shape() and impose_shape() do, and
// Status::order if there is a penalty and no axis has the degree for it.
Fitted fit(const Statistics &statistics, const std::vector<KnotVectorPtr> &wanted, const FitWishes &given);

} // namespace nrb::fit
