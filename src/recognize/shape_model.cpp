// SPDX-License-Identifier: MIT
#include "recognize/shape_model.h"

#include <cmath>

namespace nrb::recognize {

void Shape::set_frame(const Vector3 &axis, const Vector3 &direction) noexcept {
    z = unit(axis);
    x = unit_across(direction, z);
    y = cross(z, x);
}

bool Quadric::round() const noexcept {
    return k.x == 1 && k.y == 1 && (k.z == 1 || k.z == 0) && l == 0;
}

Quadric quadric_of(const Shape &shape) noexcept {
    const double a = shape.sizes[0], b = shape.sizes[1];
    switch (shape.kind) {
    case shape_sphere:
        return {{1, 1, 1}, 0, -a * a};
    case shape_cone:
        return {{std::cos(a) * std::cos(a), std::cos(a) * std::cos(a), -std::sin(a) * std::sin(a)}, 0, 0};
    case shape_ellipse:
        return {{b / a, a / b, 0}, 0, -a * b};
    case shape_hyperbola:
        return {{b / a, -a / b, 0}, 0, -a * b};
    case shape_parabola:
        return {{0, 1, 0}, -2 * a, 0};
    default: // circle, cylinder
        return {{1, 1, 0}, 0, -a * a};
    }
}

double signed_distance(const Shape &shape, const Vector3 &p) noexcept {
    const double a = shape.sizes[0];
    switch (shape.kind) {
    case shape_point:
        return length(p);
    case shape_line:
        return std::hypot(p.x, p.y);
    case shape_plane:
        return p.z;
    case shape_circle:
    case shape_cylinder:
        return std::hypot(p.x, p.y) - a;
    case shape_sphere:
        return length(p) - a;
    case shape_cone:
        return std::hypot(p.x, p.y) * std::cos(a) - p.z * std::sin(a);
    case shape_torus:
        return std::hypot(std::hypot(p.x, p.y) - a, p.z) - shape.sizes[1];
    default:
        break;
    }
    const Quadric q = quadric_of(shape);
    const double value = q.k.x * p.x * p.x + q.k.y * p.y * p.y + 2 * q.l * p.x + q.c;
    const double half = std::hypot(q.k.x * p.x + q.l, q.k.y * p.y);
    const double divisor = half + std::sqrt(half * half + q.curvature() * std::abs(value));
    return divisor > 0 ? value / divisor : 0;
}

namespace {

// A point of a conic with its derivatives: for an ellipse with respect to the angle, otherwise with respect
// to y.
struct ConicPoint {
    double x, y, dx, dy, ddx, ddy;
};
ConicPoint conic_point(const Shape &shape, double t) noexcept {
    const double a = shape.sizes[0], b = shape.sizes[1];
    if (shape.kind == shape_ellipse) {
        const double c = std::cos(t), s = std::sin(t);
        return {a * c, b * s, -a * s, b * c, -a * c, -b * s};
    }
    if (shape.kind == shape_parabola) {
        return {t * t / (4 * a), t, t / (2 * a), 1, 1 / (2 * a), 0};
    }
    const double root = std::hypot(1, t / b), slope = t / b / root;
    return {a * root, t, a / b * slope, 1, a / b / b / (root * root * root), 0};
}

// Newton's method for the foot point. The result is an upper bound whether or not it converges, as every
// iterate is a point of the conic.
double conic_distance(const Shape &shape, const Vector3 &p) noexcept {
    const bool ellipse = shape.kind == shape_ellipse;
    double t = ellipse ? std::atan2(shape.sizes[0] * p.y, shape.sizes[1] * p.x) : p.y;
    ConicPoint q = conic_point(shape, t);
    double distance = std::hypot(q.x - p.x, q.y - p.y);
    for (int round = 0; round < 12; ++round) {
        const double speed = q.dx * q.dx + q.dy * q.dy, bend = (q.x - p.x) * q.ddx + (q.y - p.y) * q.ddy;
        const double slope = (q.x - p.x) * q.dx + (q.y - p.y) * q.dy;
        t -= slope / (speed + bend > speed / 4 ? speed + bend : speed);
        q = conic_point(shape, t);
        const double next = std::hypot(q.x - p.x, q.y - p.y);
        if (!(next < distance)) {
            break;
        }
        distance = next;
    }
    return distance;
}

// The distance from the outer part of a torus, which may intersect itself: if the nearest point of the
// generating circle is beyond the axis, the nearest point of the torus is one of its two points on the axis.
double torus_distance(const Shape &shape, const Vector3 &p) noexcept {
    const double major = shape.sizes[0], minor = shape.sizes[1];
    const double s = std::hypot(p.x, p.y), d = std::hypot(s - major, p.z);
    if (minor > major && (major - s) * minor > major * d) {
        return std::hypot(s, std::abs(p.z) - std::sqrt((minor - major) * (minor + major)));
    }
    return std::abs(d - minor);
}

} // namespace

double most_distance(const Shape &shape, const Vector3 &p) noexcept {
    const double a = shape.sizes[0];
    switch (shape.kind) {
    case shape_cone:
        return std::hypot(p.x, p.y) * std::sin(a) + p.z * std::cos(a) > 0
                   ? std::abs(signed_distance(shape, p))
                   : length(p);
    case shape_torus:
        return torus_distance(shape, p);
    case shape_ellipse:
    case shape_parabola:
    case shape_hyperbola:
        return conic_distance(shape, p);
    default:
        return std::abs(signed_distance(shape, p));
    }
}

double least_distance(const Shape &shape, const Vector3 &p) noexcept {
    const double d = signed_distance(shape, p);
    return shape.planar() ? std::hypot(d, p.z) : std::abs(d);
}

} // namespace nrb::recognize
