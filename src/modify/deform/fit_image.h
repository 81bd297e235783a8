// Images of splines under maps of points, as splines over refined knots.
#pragma once

#include "spline/spline.h"

#include <functional>
#include <vector>

namespace nrb {

// points[n][dim] to images of the same size; may throw what it does not map.
using PointMap = std::function<void(const std::vector<double> &points, std::vector<double> &images)>;
// The distance of a candidate from the exact image, at equal parameters.
using Judge = std::function<double(const SplinePtr &candidate)>;

struct FittedImage {
    SplinePtr spline;
    double deviation;
};

// The spline over refined knots of g, of its degrees and with its weights, whose numerators w(t) F(g(t)) are found by
// local projection (span_samples.h): exactly, to rounding, where F is affine. Along each axis every span is cut where
// interpolation by polynomials of the degree is off by more than a share of the tolerance at the places between its
// nodes, in as many parts as its order promises, on the lines of the nodes of the other axes. The whole is judged
// by `judge`, or by 2 degree + 3 samples along each axis of every cell. Throws NURBS_ERROR_NOT_CONVERGED if that
// takes more than 2^18 control points, or spans that cannot be cut, and what the map and refine() throw.
FittedImage fit_image(const SplinePtr &g, const PointMap &map, double tolerance,
                      const Judge &judge = nullptr);

} // namespace nrb
