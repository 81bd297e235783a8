// SPDX-License-Identifier: MIT
// Images of splines under maps of points, approximated by splines over refined knots.
#pragma once

#include "spline/spline.h"

#include <array>
#include <functional>
#include <vector>

namespace nrb::fit {

// Maps points[n][dim] to images of the same size; may throw for points outside its domain.
using PointMap = std::function<void(const std::vector<double> &points, std::vector<double> &images)>;
// The spans of each axis that are to be cut: those for which [axis][span] is 1.
using Cuts = std::array<std::vector<char>, max_axes>;
// Bounds the distance of a candidate from the exact image of g at equal parameters; `refined` is g over the
// knots of the candidate. If that distance is too large, it also sets the spans to cut; none leaves the
// choice to the samples.
using Judge = std::function<double(const SplinePtr &refined, const SplinePtr &candidate, Cuts &cuts)>;

struct FittedImage {
    SplinePtr spline;
    double deviation;
    bool proven; // by the judge
};

// Approximates the image of g under the map F by a spline over refined knots of g with the weights w of g.
// Its numerators w(t) F(g(t)) are found by least squares from samples of every span (span_samples.h); they
// are exact up to rounding if F is affine.
// A span of an axis is cut if the univariate fit along that axis is off by more than a share of the tolerance
// and more than a share of the largest error. The error is measured at the nodes and between them, on the
// lines through the nodes of the other axes. The order of approximation determines the number of parts. A
// degree below 3 is raised to 3 instead where that takes fewer control points; it preserves the continuity.
// `judge` decides whether the whole candidate is within the tolerance. Without it, 2 degree + 3 samples along
// each axis of every cell decide. They also decide after three more rounds without a proof.
// Throws Status::not_converged if it would take more than 2^18 control points, too many samples or a span too
// short to be cut, or if further rounds make no progress; and what the map, refine() and elevate() throw.
FittedImage fit_image(const SplinePtr &g, const PointMap &map, double tolerance,
                      const Judge &judge = nullptr);

} // namespace nrb::fit
