// SPDX-License-Identifier: MIT
// Splines closest to points without parameters.
#pragma once

#include "base/records.h"
#include "spline/spline.h"

namespace nrb::fit {

struct CloudWishes {
    int penalty_order = 2;
    double lambda = -1;       // factor of the penalty; below 0: found
    double first_lambda = -1; // where its path begins; below 0: found
    double tolerance = 1e-3;  // the smallest part of the sum that is worth a step
    int rounds = 100;         // most searches for the nearest points of all
};

struct CloudFit {
    SplinePtr spline;
    int64_t data_count;
    double weight, squares, rms;
    double largest;        // distance
    int64_t largest_index; // of the caller
    double lambda;
    double noise;        // of a distance
    int64_t on_boundary; // nearest points on an end or edge
    int64_t uncertified; // nearest points that are not proven to be
    int rounds;
    bool converged;
};

// The spline over the axes of a polynomial one for which sum w |x - s|^2 + lambda sum_k int (d^m s / dx_k^m)^2, with s the
// point of the spline that is nearest to x, is a minimum that is reached from the start. Each round finds the nearest points,
// with proof, replaces the squared distances by the models of SquaredDistance, and takes the step that makes their sum least,
// with a multiple of its square added, which grows until the true sum falls (K. Levenberg 1944, D. Marquardt 1963). Between
// rounds lambda falls to the one that is wanted. Throws what cloud_of() does, and Status::not_representable.
CloudFit fit_cloud(const SplinePtr &start, const ConstRecords &points, const ConstRecords &weights,
                   const CloudWishes &wishes);

} // namespace nrb::fit
