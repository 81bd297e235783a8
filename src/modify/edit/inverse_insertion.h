// SPDX-License-Identifier: MIT
// Inverse knot insertion: the knot that makes a point of a leg of the control polygon a control point (L.
// Piegl, "Modifying the shape of rational B-splines", CAD 21 (1989); Piegl & Tiller 11.4).
#pragma once

#include "spline/spline.h"

namespace nrb::modify {

struct LegInsertion {
    double knot;
    SplinePtr spline;
};

// See nurbs_insert_on_leg(). A knot t outside the domain, at an unclamped end, is inserted by the polar form
// of the end piece. Before the domain, the knots t_0, t_1, ... become t_1, ..., t, ..., so that the domain
// stays the same. The layer whose arguments all come before the domain is dropped, since no point of the
// domain depends on it; new layers are means of two old ones. Beyond the domain it is the same with the last
// knot. On a periodic axis, the copy of the knot that lies in the domain is inserted. Throws Status::degree,
// index, multiplicity; periodic if a periodic axis has fewer different layers than its degree; weight_sign if
// the weights at the ends of the leg do not have one sign, so that no knot makes a point inside it a control
// point; point_not_finite if an end of the leg is at infinity; and what refine() throws. Precondition: 0 <=
// ratio <= 1.
LegInsertion insert_on_leg(const SplinePtr &spline, int axis, int64_t point, double ratio);

// The leg from a control point to its neighbour along an axis, with its place nearest to a given point.
struct Leg {
    int64_t point; // where it starts
    double ratio;
    double distance; // of the given point
};

// The leg along an axis that is nearest to a point, the first one if there are several. Throws
// Status::degree. Precondition: the point is finite.
Leg nearest_leg(const Spline &spline, int axis, const double *point);

} // namespace nrb::modify
