// SPDX-License-Identifier: MIT
// Arcs of any conic in any dimension, from their ends and a homogeneous control point between them.
#pragma once

#include "build/plane_frame.h"
#include "spline/spline.h"

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

namespace nrb::build {

// The curve with the homogeneous Bezier points (A, 1), (h, w), (B, 1). The control point h / w may be at
// infinity (w = 0, parallel tangents) or on the far side of the arc (w < 0, more than half an ellipse). In
// the affine picture in which the conic is a circle (w < 1) the arc has the angle 2 acos w. In the picture in
// which it is x^2 - y^2 = 1 (w > 1) the arc has the length 2 acosh w in u.
struct ConicArc {
    std::vector<double> start;  // A
    std::vector<double> end;    // B
    std::vector<double> middle; // h - w A, which is as accurate far from the origin
    double weight;              // w
    double below;               // 1 - w and 1 + w, which cannot be computed from w accurately
    double above;
    std::vector<double> u; // w < 1: the images of the unit vectors of the picture, in which A is at (1, 0)
    std::vector<double> v;
};

// From B - A and h - w A as vectors of a plane, and its map to the space. Twice the precision keeps arcs of
// nearly a whole ellipse accurate, where 1 + w and the two vectors nearly cancel. Throws Status::conic if w
// is -1 or less, because the curve then passes through infinity.
using PlaneMap = std::function<std::vector<double>(Point2)>;
ConicArc make_conic_arc(std::vector<double> start, std::vector<double> end, const Point2 &chord,
                        const Point2 &middle, const DoubleDouble &weight, const PlaneMap &to_space);

// Arcs one after the other, with knots evenly spaced, in pieces of equal angles as the form says, or of equal
// lengths of at most 2; their ends are exact bit for bit. A single arc may have arc_smooth. Throws what
// make_shape() throws.
SplinePtr conic_curve(std::span<const ConicArc> arcs, int32_t form);

// The weights 1, `weight`, 1; polynomial for 1. Throws what make_shape() throws.
SplinePtr conic_segment(int dim, const double *p0, const double *p1, const double *p2, double weight);

// The conic with a control triangle and C_sf = w1^2 / (w0 w2). Degenerate conics, for 0 and infinity, have
// degree 1. Throws Status::factor for a factor that is negative or NaN, and what make_shape() throws.
SplinePtr conic_by_shape_factor(int dim, const double *p0, const double *p1, const double *p2, double factor);

} // namespace nrb::build
