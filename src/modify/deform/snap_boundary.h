// SPDX-License-Identifier: MIT
// A boundary moved onto that of another spline.
#pragma once

#include "spline/spline.h"

namespace nrb::modify {

struct Boundary {
    int axis;
    bool upper;
};

struct SnappedBoundary {
    SplinePtr spline;
    double bound; // proven, of the distance to the given spline
};

// See nurbs_snap_boundary(). The axes across the boundaries are clamped there; the axes along them are
// brought to one degree and one knot vector (refine/algebra/common_knots.h). In homogeneous coordinates, let
// B_0 be the layer at the other boundary and B_1 the one next to it. The new layers are
//
//     A_0 = f B_0,   A_1 = f ((1 + c) B_0 + s (B_0 - B_1)),
//
// where f is a power of two that keeps the size of the weights. The derivative across the boundary follows
// from the part of A_1 - A_0 in the tangent plane. It is s times that of the other spline, whatever c is,
// because c B_0 moves a point along itself only. s is chosen to keep the mean length of the derivative over
// the control points, c to keep the mean weight of the second layer. Throws Status::axes, incompatible,
// periodic, degree, tangent, weight_sign, and what clamping, reparametrize() and deviation() throw.
SnappedBoundary snap_boundary(const SplinePtr &spline, Boundary boundary, const SplinePtr &other,
                              Boundary other_boundary, int order, bool reversed);

} // namespace nrb::modify
