// SPDX-License-Identifier: MIT
// Lines, circles, conics, planes and simple surfaces: their parameters, and distances of points from them.
#pragma once

#include "numeric/vector3.h"

#include <cstdint>

namespace nrb::recognize {

enum ShapeKind : int32_t {
    shape_none = 0,
    shape_point,
    shape_line,
    shape_circle,
    shape_ellipse,
    shape_parabola,
    shape_hyperbola,
    shape_plane,
    shape_sphere,
    shape_cylinder,
    shape_cone, // one half of the double cone
    shape_torus,
};

// A shape: one of the shape_ constants with its numbers as specified for nurbs_recognize(). x, y, z is a
// right-handed frame of unit vectors with z as the axis. In dimension 2, all third coordinates are 0 except
// for z = (0, 0, +-1).
struct Shape {
    int32_t kind = shape_none;
    Vector3 origin;
    Vector3 x{1, 0, 0};
    Vector3 y{0, 1, 0};
    Vector3 z{0, 0, 1};
    double sizes[3] = {0, 0, 0};

    [[nodiscard]] Vector3 local(const Vector3 &point) const noexcept {
        const Vector3 p = point - origin;
        return {dot(x, p), dot(y, p), dot(z, p)};
    }
    // Sets z to the normalized axis, x to the normalized part of `direction` orthogonal to it, and y = z x x.
    void set_frame(const Vector3 &axis, const Vector3 &direction) noexcept;
    [[nodiscard]] bool planar() const noexcept { return kind >= shape_circle && kind <= shape_hyperbola; }
};

// The equation k.x x^2 + k.y y^2 + k.z z^2 + 2 l x + c = 0 of a shape in its own frame, with coefficients
// accurate to 3 eps. For a circle or conic, the equation in its plane.
struct Quadric {
    Vector3 k;
    double l = 0;
    double c = 0;

    // The largest magnitude of k. A step s from a point at which the equation has the value f and half its
    // gradient has length h changes f by at most 2 h s + curvature() s^2, and along the gradient by at least
    // 2 h s - curvature() s^2. A point with f = |value| is therefore at least
    //   f / (h + sqrt(h^2 + curvature() f)) and at most f / (h + sqrt(h^2 - curvature() f))
    // away from a zero.
    [[nodiscard]] double curvature() const noexcept { return largest(k); }
    // Whether the squared length of half the gradient is the value minus c.
    [[nodiscard]] bool round() const noexcept;
};
// Precondition: not a point, line, plane or torus.
Quadric quadric_of(const Shape &shape) noexcept;

// The distance of a point, given in the frame of the shape, from the shape, with a sign if the shape has
// sides. It is exact except for ellipses, parabolas and hyperbolas, where it is a lower bound that becomes
// exact near the conic. For circles and conics, the distance is measured within their plane.
double signed_distance(const Shape &shape, const Vector3 &p) noexcept;
// A lower bound on the distance; for curves, it includes the distance from their plane.
double least_distance(const Shape &shape, const Vector3 &p) noexcept;
// An upper bound on the distance, almost always equal to it: for circles and conics within their plane, for a
// cone from one half, for a hyperbola from one branch.
double most_distance(const Shape &shape, const Vector3 &p) noexcept;

} // namespace nrb::recognize
