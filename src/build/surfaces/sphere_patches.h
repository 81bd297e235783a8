// SPDX-License-Identifier: MIT
// The sphere as patches without poles.
#pragma once

#include "build/placement.h"
#include "spline/spline.h"

#include <vector>

namespace nrb::build {

// Six patches of degree 4 x 4 over the faces +X, +Y, -X, -Y, +Z, -Z of a cube (J. E. Cobb, "Tiling the sphere
// with rational Bezier patches", 1988). Under the stereographic projection from -Z, four arcs of 30 degrees
// bound the face +Z: the great circle x = z becomes the circle of radius sqrt(2) about (-1, 0). The arcs are
// the edges of the plane biquadratic patch (X, Y, W) with the corners (+-c, +-c), c = (sqrt(3) - 1) / 2, of
// weight 1, the middle points (+-m, 0) and (0, +-m), m = 2 sqrt(3) - 3, of weight cos(15 degrees), and the
// centre (0, 0) of weight 1. The patch on the sphere is (2 X W, 2 Y W, W^2 - X^2 - Y^2, W^2 + X^2 + Y^2). Its
// net has the symmetries of the square, and the nets of all faces are this one with coordinates permuted and
// negated, so that faces meet bit for bit. |S_u x S_v| is from 1.15 to 2.75 times the squared radius. With
// `half`, only the side Z > 0: +X, +Y, -X, -Y from the equator upwards, and +Z. Throws Status::length,
// not_representable.
std::vector<SplinePtr> sphere_patches(const Placement &place, double radius, bool half);

} // namespace nrb::build
