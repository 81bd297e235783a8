#include "query/shape_model.h"

#include <cmath>

namespace nrb {

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
    case NURBS_SHAPE_SPHERE:
        return {{1, 1, 1}, 0, -a * a};
    case NURBS_SHAPE_CONE:
        return {{std::cos(a) * std::cos(a), std::cos(a) * std::cos(a), -std::sin(a) * std::sin(a)}, 0, 0};
    case NURBS_SHAPE_ELLIPSE:
        return {{b / a, a / b, 0}, 0, -a * b};
    case NURBS_SHAPE_HYPERBOLA:
        return {{b / a, -a / b, 0}, 0, -a * b};
    case NURBS_SHAPE_PARABOLA:
        return {{0, 1, 0}, -2 * a, 0};
    default: // circle, cylinder
        return {{1, 1, 0}, 0, -a * a};
    }
}

double signed_distance(const Shape &shape, const Vector3 &p) noexcept {
    const double a = shape.sizes[0];
    switch (shape.kind) {
    case NURBS_SHAPE_POINT:
        return length(p);
    case NURBS_SHAPE_LINE:
        return std::hypot(p.x, p.y);
    case NURBS_SHAPE_PLANE:
        return p.z;
    case NURBS_SHAPE_CIRCLE:
    case NURBS_SHAPE_CYLINDER:
        return std::hypot(p.x, p.y) - a;
    case NURBS_SHAPE_SPHERE:
        return length(p) - a;
    case NURBS_SHAPE_CONE:
        return std::hypot(p.x, p.y) * std::cos(a) - p.z * std::sin(a);
    case NURBS_SHAPE_TORUS:
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

double least_distance(const Shape &shape, const Vector3 &p) noexcept {
    const double d = signed_distance(shape, p);
    return shape.planar() ? std::hypot(d, p.z) : std::abs(d);
}

} // namespace nrb
