// SPDX-License-Identifier: MIT
// Recognition of simple shapes: whether a curve or surface is a line, circle, conic, plane, sphere, cylinder,
// cone or torus to a tolerance.
#pragma once

#include "recognize/shape_model.h"
#include "spline/spline.h"

namespace nrb::recognize {

struct Recognition {
    Shape shape;
    double deviation = 0; // proven upper bound; 0 with shape_none
};

// The first shape from which no point is farther than the tolerance, in the following order: for a curve
// point, line, circle, parabola, ellipse, hyperbola; for a surface point, line, plane, sphere, cylinder,
// cone, torus. Points and lines come first for surfaces because a surface that is no larger, or no wider,
// than the tolerance has no meaningful normal. Parabolas come before ellipses, because ellipses approximate a
// parabola as closely as one likes. Throws Status::axes, dimension, not_representable. Cost: some hundred
// evaluations and, for each shape that fits the samples to the tolerance, a few products for each Bezier
// piece.
Recognition recognize(const Spline &given, double tolerance);

} // namespace nrb::recognize
