// SPDX-License-Identifier: MIT
// Images of splines under maps of points, as splines over refined knots.
#pragma once

#include "spline/spline.h"

#include <array>
#include <functional>
#include <vector>

namespace nrb::fit {

// points[n][dim] to images of the same size; may throw for points that it does not map.
using PointMap = std::function<void(const std::vector<double> &points, std::vector<double> &images)>;
// The spans of each axis that are to be cut: [axis][span] is 1.
using Cuts = std::array<std::vector<char>, max_axes>;
// The distance of a candidate from the exact image of g, at equal parameters; `refined` is g over the same
// knots. Also which spans to cut if that is too much; none to leave the choice to the samples.
using Judge = std::function<double(const SplinePtr &refined, const SplinePtr &candidate, Cuts &cuts)>;

struct FittedImage {
    SplinePtr spline;
    double deviation;
    bool proven; // by the judge
};

// The spline over refined knots of g, with its weights, whose numerators w(t) F(g(t)) are found by least
// squares (span_samples.h): exactly, to rounding, if F is affine. Along each axis a span is cut if the spline
// along it is off by more than a share of the tolerance, and of the largest error, at the nodes and between
// them, on the lines of the nodes of the other axes. It is cut in as many parts as its order promises. A
// degree below 3 is raised to 3 instead where this takes fewer control points; this leaves all continuity as
// it was. `judge` decides about the whole, or else 2 degree + 3 samples along each axis of every cell do;
// these samples also decide when three more rounds bring no proof. Throws Status::not_converged if it takes
// more than 2^18 control points, or spans that cannot be cut, and what the map, refine() and elevate() throw.
FittedImage fit_image(const SplinePtr &g, const PointMap &map, double tolerance,
                      const Judge &judge = nullptr);

} // namespace nrb::fit
