// SPDX-License-Identifier: MIT
// Lines, circles, conics, planes and the simple surfaces: where one stands, and how far a point is from it.
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
    shape_cone, // one half of it
    shape_torus,
};

// One of the shape_ constants with its numbers as nurbs_recognize() has them; x, y, z is a right-handed
// frame of unit vectors, z the axis. In dimension 2 all third coordinates are 0, but for z = (0, 0, +-1).
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
    // With z of unit length and y across it.
    void set_frame(const Vector3 &axis, const Vector3 &direction) noexcept;
    [[nodiscard]] bool planar() const noexcept { return kind >= shape_circle && kind <= shape_hyperbola; }
};

// The equation k.x x^2 + k.y y^2 + k.z z^2 + 2 l x + c = 0 of a shape in its frame, each coefficient within 3
// eps of itself. A circle or conic is that of its plane.
struct Quadric {
    Vector3 k;
    double l = 0;
    double c = 0;

    // The largest magnitude of k: a step s from a point with the value f and half the gradient h changes f by
    // at most 2 h s + curvature() s^2, and by at least 2 h s - curvature() s^2 along the gradient. So a point
    // is at least f / (h + sqrt(h^2 + curvature() f)) and at most f / (h + sqrt(h^2 - curvature() f)) from a
    // zero, f = |value|.
    [[nodiscard]] double curvature() const noexcept { return largest(k); }
    // Whether the square of half the gradient is the value less c.
    [[nodiscard]] bool round() const noexcept;
};
// Precondition: not a point, line, plane or torus.
Quadric quadric_of(const Shape &shape) noexcept;

// A distance of a point in the frame of the shape from it, with a sign where the shape has sides: exact but
// for conics that are no circles, where it is at most the true one and equal to it in the limit. For circles
// and conics in their plane.
double signed_distance(const Shape &shape, const Vector3 &p) noexcept;
// At most the true distance, with that from the plane of a curve.
double least_distance(const Shape &shape, const Vector3 &p) noexcept;
// At least the true distance, within a circle's or conic's plane, and from one half of a cone or one branch
// of a hyperbola; almost always equal to it.
double most_distance(const Shape &shape, const Vector3 &p) noexcept;

} // namespace nrb::recognize
