// SPDX-License-Identifier: MIT
#include "recognize/shape_fit.h"

#include <algorithm>
#include <cmath>

namespace nrb::recognize {

namespace {

using Points = std::vector<Vector3>;

// Twice the area that the polyline of the points sweeps about the origin, seen along the axis.
double swept(const Shape &shape, const Points &points) noexcept {
    double sum = 0;
    for (size_t i = 0; i + 1 < points.size(); ++i) {
        const Vector3 p = shape.local(points[i]), q = shape.local(points[i + 1]);
        sum += p.x * q.y - p.y * q.x;
    }
    return sum;
}

void turn_over(Shape &shape) noexcept {
    shape.z = -1 * shape.z;
    shape.y = -1 * shape.y;
}

// Turns x towards the start of the spline or, if that is on the axis, towards the first point that is well
// away from the axis.
void point_x_at_start(Shape &shape, const Points &points) noexcept {
    const auto from_axis = [&shape](const Vector3 &p) {
        const Vector3 q = shape.local(p);
        return std::hypot(q.x, q.y);
    };
    double farthest = 0;
    for (const Vector3 &p : points) {
        farthest = std::max(farthest, from_axis(p));
    }
    const bool away = from_axis(points.front()) > 1e-5 * farthest;
    const auto start = away ? points.begin()
                            : std::find_if(points.begin(), points.end(),
                                           [&](const Vector3 &p) { return from_axis(p) > farthest / 16; });
    const Vector3 q = start == points.end() ? Vector3{} : shape.local(*start);
    if (q.x != 0 || q.y != 0) {
        shape.set_frame(shape.z, q.x * shape.x + q.y * shape.y);
    }
}

// Moves the origin along the axis to the height of a point.
void move_along_axis(Shape &shape, const Vector3 &p) noexcept {
    shape.origin = shape.origin + dot(p - shape.origin, shape.z) * shape.z;
}

void place_line(Shape &shape, const Points &points) noexcept {
    move_along_axis(shape, points.front());
    double farthest = 0;
    for (const Vector3 &p : points) {
        const double at = shape.local(p).z;
        farthest = std::abs(at) > std::abs(farthest) ? at : farthest;
    }
    const double end = shape.local(points.back()).z;
    if ((std::abs(end) > 0.5 * std::abs(farthest) ? end : farthest) < 0) {
        shape.set_frame(-1 * shape.z, shape.x);
    }
}

void place_conic(Shape &shape, const Points &points) noexcept {
    const bool closed = shape.kind == shape_circle || shape.kind == shape_ellipse;
    if (shape.kind == shape_ellipse && shape.sizes[0] < shape.sizes[1]) {
        std::swap(shape.sizes[0], shape.sizes[1]);
        shape.set_frame(shape.z, shape.y);
    }
    if (shape.kind == shape_ellipse && shape.local(points.front()).x < 0) {
        shape.set_frame(shape.z, -1 * shape.x);
    }
    const double rise = shape.local(points.back()).y - shape.local(points.front()).y;
    if ((closed ? swept(shape, points) : rise) < 0) {
        turn_over(shape);
    }
    if (shape.kind == shape_circle) {
        point_x_at_start(shape, points);
    }
}

void place_plane(Shape &shape, const ShapeSamples &samples) noexcept {
    Vector3 sum;
    for (const Vector3 &n : samples.normals) {
        sum = sum + n;
    }
    if (dot(sum, shape.z) < 0) {
        turn_over(shape);
    }
    const Vector3 q{dot(samples.along, shape.x), dot(samples.along, shape.y), 0};
    if (std::hypot(q.x, q.y) > 1e-6 * length(samples.along)) {
        shape.set_frame(shape.z, q.x * shape.x + q.y * shape.y);
    }
}

void place_round(Shape &shape, const ShapeSamples &samples) noexcept {
    const Points &points = samples.points;
    if (shape.kind == shape_cylinder) {
        move_along_axis(shape, points.front());
        double sum = 0;
        for (const Vector3 &p : points) {
            sum += shape.local(p).z;
        }
        if (sum < 0) {
            turn_over(shape);
        }
    }
    const Vector3 &z = shape.z;
    const double most = std::abs(z.x) >= largest(z) ? z.x : std::abs(z.y) >= largest(z) ? z.y : z.z;
    if (shape.kind == shape_torus && most < 0) {
        turn_over(shape);
    }
    point_x_at_start(shape, points);
}

} // namespace

Shape placed_shape(const Shape &fitted, const ShapeSamples &samples, int dim) {
    Shape shape = fitted;
    switch (shape.kind) {
    case shape_line:
        place_line(shape, samples.points);
        break;
    case shape_plane:
        place_plane(shape, samples);
        break;
    case shape_cylinder:
    case shape_cone:
    case shape_torus:
        place_round(shape, samples);
        break;
    default:
        if (shape.planar()) {
            place_conic(shape, samples.points);
        }
    }
    shape.origin = samples.centre + shape.origin;
    if (dim == 2) {
        shape.origin.z = 0;
    }
    return shape;
}

} // namespace nrb::recognize
