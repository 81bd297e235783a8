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

// See nurbs_snap_boundary(). Both axes across are clamped at the boundaries; the axes along them are brought
// to one degree and one knot vector (refine/algebra/common_knots.h). With the layers B_0 at the other
// boundary and B_1 next to it, in homogeneous coordinates, the new layers are
//
//     A_0 = f B_0,   A_1 = f ((1 + c) B_0 + s (B_0 - B_1)),
//
// where f is a power of two that keeps the size of the weights. The derivative across is that of A_1 - A_0 in
// the direction of the tangent plane. It is s times the other one, whatever c, because c B_0 moves a point
// along itself. s keeps the mean length of the derivative over the control points, c keeps the mean weight of
// the layer. Throws Status::axes, incompatible, periodic, degree, tangent, weight_sign, and what clamping,
// reparametrize() and deviation() throw.
SnappedBoundary snap_boundary(const SplinePtr &spline, Boundary boundary, const SplinePtr &other,
                              Boundary other_boundary, int order, bool reversed);

} // namespace nrb::modify
