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

// See nurbs_insert_on_leg(). A knot outside the domain is inserted by the polar form of the end piece. From a
// vector t_0, t_1, ... the new vector has t_1, ..., t, ..., so that the domain is the same. The layer whose
// arguments all come before the domain is dropped, since no point of the domain depends on it; new layers are
// means of two old ones. On a periodic axis the knot is inserted where its copy is in the domain. Throws
// Status::degree, index, multiplicity; periodic if a periodic axis has fewer different layers than its
// degree; weight_sign if the weights at the ends of the leg do not have one sign, so that no knot makes a
// point inside it a control point; point_not_finite if an end of the leg is at infinity; and what refine()
// throws. Precondition: 0 <= ratio <= 1.
LegInsertion insert_on_leg(const SplinePtr &spline, int axis, int64_t point, double ratio);

struct Leg {
    int64_t point; // where it starts
    double ratio;
    double distance; // of the point given
};

// The nearest leg along an axis, the first one if there are several. Throws Status::degree. Precondition: the
// point is finite.
Leg nearest_leg(const Spline &spline, int axis, const double *point);

} // namespace nrb::modify
