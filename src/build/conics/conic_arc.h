// SPDX-License-Identifier: MIT
// Conic arcs in any dimension, from their ends and the homogeneous control point between them.
#pragma once

#include "build/plane_frame.h"
#include "spline/spline.h"

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

namespace nrb::build {

// The rational quadratic curve with the homogeneous Bezier points (A, 1), (h, w), (B, 1). The control point h
// / w may be at infinity (w = 0, parallel tangents) or on the far side of the arc (w < 0, more than half an
// ellipse). The picture of the conic is its affine image in a standard position: a circle if w < 1, on which
// the arc has the angle 2 acos w; the hyperbola x^2 - y^2 = 1 if w > 1, on which the arc has the length 2
// acosh w in the hyperbolic parameter u.
struct ConicArc {
    std::vector<double> start;  // A
    std::vector<double> end;    // B
    std::vector<double> middle; // h - w A, which stays accurate far from the origin
    double weight;              // w
    double below;               // 1 - w and 1 + w, which cannot be computed accurately from the rounded w
    double above;
    std::vector<double> u; // w < 1: what the unit vectors of the picture map to; A is at (1, 0) there
    std::vector<double> v;
};

// The arc with given B - A (`chord`) and h - w A (`middle`), vectors of a plane that `to_space` maps to
// space. In double-double precision, arcs of nearly a whole ellipse stay accurate, where 1 + w and the two
// vectors nearly cancel. Throws Status::conic if w <= -1, because the curve then passes through infinity.
using PlaneMap = std::function<std::vector<double>(Point2)>;
ConicArc make_conic_arc(std::vector<double> start, std::vector<double> end, const Point2 &chord,
                        const Point2 &middle, const DoubleDouble &weight, const PlaneMap &to_space);

// The curve of consecutive arcs, over evenly spaced knots; it meets the ends of the arcs bit for bit.
// Elliptic arcs are divided into pieces of equal angles in their picture, as the form says, the others into
// pieces of equal lengths of at most 2 in u. arc_smooth is allowed for a single arc only. Throws what
// make_shape() throws.
SplinePtr conic_curve(std::span<const ConicArc> arcs, int32_t form);

// The quadratic curve with the weights 1, `weight`, 1; polynomial if `weight` is 1. Throws what make_shape()
// throws.
SplinePtr conic_segment(int dim, const double *p0, const double *p1, const double *p2, double weight);

// The conic with the control triangle p0, p1, p2 and the shape factor C_sf = w1^2 / (w0 w2). The degenerate
// conics, the chord for the factor 0 and the two legs for infinity, have degree 1. Throws Status::factor for
// a factor that is negative or NaN, and what make_shape() throws.
SplinePtr conic_by_shape_factor(int dim, const double *p0, const double *p1, const double *p2, double factor);

} // namespace nrb::build
