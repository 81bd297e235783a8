// Arcs of any conic in any dimension, from their ends and a homogeneous control point between them.
#pragma once

#include "spline/spline.h"

#include <cstdint>
#include <span>
#include <vector>

namespace nrb {

// The curve with the homogeneous Bezier points (A, 1), (h, w), (B, 1), in offsets from A, which keeps them accurate
// far from the origin: the control point h / w may be at infinity (w = 0, parallel tangents) or behind the arc (w
// < 0, more than half an ellipse). In the affine picture in which the conic is a circle (w < 1) the arc has the angle 2
// acos w; in that in which it is x^2 - y^2 = 1 (w > 1), the length 2 acosh w in u.
struct ConicArc {
    std::vector<double> start;  // A
    std::vector<double> end;    // B
    std::vector<double> middle; // h - w A
    double weight;              // w
};

// Arcs one after the other, in pieces of equal angles as the form says or of equal lengths of at most 2, knots
// evenly spaced; their ends bit for bit. A single arc may have NURBS_ARC_SMOOTH. Throws NURBS_ERROR_CONIC if a
// weight is -1 or less, where the curve passes through infinity, and what make_spline() throws.
SplinePtr conic_curve(std::span<const ConicArc> arcs, int32_t form);

// The weights 1, `weight`, 1; polynomial for 1. Throws what make_spline() throws.
SplinePtr conic_segment(int dim, const double *p0, const double *p1, const double *p2, double weight);

// The conic with a control triangle and C_sf = w1^2 / (w0 w2): degenerate ones, for 0 and infinity, have degree 1. Throws
// NURBS_ERROR_FACTOR for a factor that is negative or NaN.
SplinePtr conic_by_shape_factor(int dim, const double *p0, const double *p1, const double *p2, double factor);

} // namespace nrb
