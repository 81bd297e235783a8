// SPDX-License-Identifier: MIT
// Least-squares fits of splines to point clouds.
#pragma once

#include "base/records.h"
#include "spline/spline.h"

namespace nrb::fit {

struct CloudWishes {
    int penalty_order = 2;
    double lambda = -1;       // factor of the penalty; below 0: chosen
    double first_lambda = -1; // where lambda starts; below 0: chosen
    double tolerance = 1e-3;  // smallest relative decrease of the sum that is worth a step
    int rounds = 100;         // most searches for all nearest points
};

struct CloudFit {
    SplinePtr spline;
    int64_t data_count;
    double weight, squares, rms;
    double largest;        // largest distance of a point
    int64_t largest_index; // of the caller
    double lambda;
    double noise;        // rounding error of a distance
    int64_t on_boundary; // nearest points on an end or edge
    int64_t uncertified; // nearest points that are not proven to be
    int rounds;
    bool converged;
};

// Minimises sum w |x - s|^2 + lambda sum_k int (d^m s / dx_k^m)^2 over the splines on the axes of `start`, a
// polynomial spline, where s is the point of the spline nearest to x (orthogonal distance fitting). The
// result is a local minimum, the one that is reached from the start. Each round finds the nearest points,
// with proof, and replaces the squared distances by the models of SquaredDistance. It then takes the step
// that minimises the sum of the models plus a multiple of the square of the step, which grows until the true
// sum falls (K. Levenberg 1944, D. Marquardt 1963). Between rounds lambda falls to the value that is wanted.
// Throws what cloud_of() throws, and Status::not_representable.
CloudFit fit_cloud(const SplinePtr &start, const ConstRecords &points, const ConstRecords &weights,
                   const CloudWishes &wishes);

} // namespace nrb::fit
