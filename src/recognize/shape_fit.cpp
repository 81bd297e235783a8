// SPDX-License-Identifier: MIT
#include "recognize/shape_fit.h"

#include "numeric/solvers/small_svd.h"
#include "recognize/conic_axes.h"
#include "recognize/shape_refine.h"

#include <algorithm>
#include <cmath>

namespace nrb::recognize {

namespace {

using Points = std::vector<Vector3>;

constexpr double cutoff = 1e-14; // relative, for singular values of equations that are refined later

Vector3 mean_of(const Points &points) noexcept {
    Vector3 sum;
    for (const Vector3 &p : points) {
        sum = sum + p;
    }
    return (1 / static_cast<double>(points.size())) * sum;
}

Vector3 vector_of(const std::vector<double> &x) noexcept {
    return {x[0], x[1], x[2]};
}

SmallSvd principal(const Points &points, const Vector3 &centre) {
    std::vector<double> rows;
    for (const Vector3 &p : points) {
        const Vector3 q = p - centre;
        rows.insert(rows.end(), {q.x, q.y, q.z});
    }
    return {rows, 3};
}

// The mean of the points; z along the principal axis of least spread, x along that of most. In dimension 2, z
// is (0, 0, 1).
Shape plane_of(const Points &points, int dim) {
    Shape shape;
    shape.kind = shape_plane;
    shape.origin = mean_of(points);
    const SmallSvd axes = principal(points, shape.origin);
    const Vector3 longest = vector_of(axes.direction(2));
    shape.set_frame(dim == 2 ? Vector3{0, 0, 1} : vector_of(axes.direction(0)),
                    dim == 2 && longest.z != 0 ? Vector3{1, 0, 0} : longest);
    return shape;
}

Shape line_of(const Points &points) {
    Shape shape;
    shape.kind = shape_line;
    shape.origin = mean_of(points);
    const SmallSvd axes = principal(points, shape.origin);
    shape.set_frame(vector_of(axes.direction(2)), vector_of(axes.direction(0)));
    return shape;
}

// The circle or sphere that fits points of the plane z = 0 or of space, by |p|^2 = 2 c . p + k.
struct Round {
    Vector3 centre;
    double radius;
};
Round round_through(const Points &points, bool plane) {
    const int n = plane ? 3 : 4;
    std::vector<double> rows, right;
    for (const Vector3 &p : points) {
        rows.insert(rows.end(), {p.x, p.y});
        if (!plane) {
            rows.push_back(p.z);
        }
        rows.push_back(1);
        right.push_back(p.x * p.x + p.y * p.y + (plane ? 0 : p.z * p.z));
    }
    const std::vector<double> solved = SmallSvd(rows, n, right).solution(cutoff);
    const Vector3 centre{solved[0] / 2, solved[1] / 2, plane ? 0 : solved[2] / 2};
    return {centre, std::sqrt(std::max(0.0, solved.back() + dot(centre, centre)))};
}

Points local_points(const Shape &frame, const Points &points, bool flat) {
    Points result;
    for (const Vector3 &p : points) {
        result.push_back(frame.local(p));
        result.back().z = flat ? 0 : result.back().z;
    }
    return result;
}

Vector3 global(const Shape &frame, const Vector3 &p) noexcept {
    return frame.origin + p.x * frame.x + p.y * frame.y + p.z * frame.z;
}

Shape refined_if(const Shape &shape, const Points &points, double tolerance) {
    const bool usable = std::isfinite(shape.sizes[0]) && std::isfinite(shape.sizes[1]) &&
                        shape.sizes[0] > 0 && std::isfinite(length(shape.origin)) &&
                        std::isfinite(length(shape.y));
    return usable ? refined(shape, points, tolerance) : Shape{};
}

Shape circle_in(const Shape &plane, const Points &points, double tolerance) {
    const Round round = round_through(local_points(plane, points, true), true);
    Shape shape = plane;
    shape.kind = shape_circle;
    shape.origin = global(plane, round.centre);
    shape.sizes[0] = round.radius;
    return refined_if(shape, points, tolerance);
}

double reach_of(const Points &points, double Vector3::*coordinate) noexcept {
    double reach = 0;
    for (const Vector3 &p : points) {
        reach = std::max(reach, std::abs(p.*coordinate));
    }
    return reach;
}

// The equation of the conic that fits points in their plane. Coordinates are scaled to the same extent on
// both axes, so that the equations of even a short arc are well conditioned.
std::vector<double> conic_through(const Points &points) {
    const double a = reach_of(points, &Vector3::x), b = reach_of(points, &Vector3::y);
    if (!(a > 0) || !(b > 0)) {
        return {};
    }
    std::vector<double> rows;
    for (const Vector3 &p : points) {
        const double x = p.x / a, y = p.y / b;
        rows.insert(rows.end(), {x * x, x * y, y * y, x, y, 1});
    }
    std::vector<double> q = SmallSvd(rows, 6).direction(0);
    const double factors[] = {1 / a / a, 1 / a / b, 1 / b / b, 1 / a, 1 / b, 1};
    for (size_t i = 0; i < q.size(); ++i) {
        q[i] *= factors[i];
    }
    return q;
}

Vector3 in_plane(const Shape &plane, const double *x) noexcept {
    return x[0] * plane.x + x[1] * plane.y;
}

// An ellipse or hyperbola; empty if the fitted equation is not of the requested kind.
Shape central_conic_in(int32_t kind, const Shape &plane, const Points &points, double tolerance) {
    const Points flat = local_points(plane, points, true);
    const std::vector<double> q = conic_through(flat);
    ConicAxes axes{};
    if (q.empty() || !find_conic_axes(q.data(), axes) ||
        axes.type != (kind == shape_ellipse ? conic_ellipse : conic_hyperbola)) {
        return {};
    }
    Shape shape = plane;
    shape.kind = kind;
    shape.origin = plane.origin + in_plane(plane, axes.origin);
    shape.set_frame(plane.z, in_plane(plane, axes.x));
    std::copy_n(axes.sizes, 2, shape.sizes);
    if (kind == shape_hyperbola && shape.local(points.front()).x < 0) { // points go on the branch x > 0
        shape.set_frame(plane.z, -1 * shape.x);
    }
    return shape.sizes[1] > 0 ? refined_if(shape, points, tolerance) : Shape{};
}

// The parabola x = a y^2 + b y + c with its axis along x of the frame.
Shape parabola_along(const Shape &frame, const Points &points, double tolerance) {
    std::vector<double> rows, right;
    for (const Vector3 &p : local_points(frame, points, true)) {
        rows.insert(rows.end(), {p.y * p.y, p.y, 1});
        right.push_back(p.x);
    }
    const std::vector<double> solved = SmallSvd(rows, 3, right).solution(cutoff);
    const double a = solved[0], at = -solved[1] / (2 * a);
    Shape shape = frame;
    shape.kind = shape_parabola;
    shape.origin = frame.origin + at * frame.y + (solved[2] + solved[1] * at / 2) * frame.x;
    shape.sizes[0] = 1 / (4 * std::abs(a));
    shape.set_frame(frame.z, a < 0 ? -1 * frame.x : frame.x);
    return refined_if(shape, points, tolerance);
}

// The axis of a parabola is the direction in which its quadratic part vanishes. In a short arc, that
// direction is poorly determined, and the normal of the chord serves as well; the better of both results is
// taken.
Shape parabola_in(const Shape &plane, const Points &points, double tolerance) {
    const std::vector<double> q = conic_through(local_points(plane, points, true));
    if (q.empty()) {
        return {};
    }
    const double size = std::hypot(q[0] - q[2], q[1]), half = std::atan2(q[1], q[0] - q[2]) / 2;
    const bool upper = q[0] + q[2] >= 0; // larger eigenvalue dominates; the axis belongs to the other
    const double axis[] = {upper ? -std::sin(half) : std::cos(half), upper ? std::cos(half) : std::sin(half)};
    Shape frame = plane, across = plane;
    frame.set_frame(plane.z, in_plane(plane, axis));
    across.set_frame(plane.z, plane.y);
    const Shape first = size > 0 ? parabola_along(frame, points, tolerance) : Shape{};
    const Shape second = parabola_along(across, points, tolerance);
    return first.kind != shape_none && largest_distance(first, points) <= largest_distance(second, points)
               ? first
               : second;
}

Shape sphere_through(const Points &points, double tolerance) {
    const Round round = round_through(points, false);
    Shape shape;
    shape.kind = shape_sphere;
    shape.origin = round.centre;
    shape.sizes[0] = round.radius;
    return refined_if(shape, points, tolerance);
}

// All normals are orthogonal to the axis.
Shape cylinder_through(const ShapeSamples &samples, double tolerance) {
    Shape shape;
    shape.kind = shape_cylinder;
    const SmallSvd axes = principal(samples.normals, {});
    shape.set_frame(vector_of(axes.direction(0)), vector_of(axes.direction(2)));
    const Round round = round_through(local_points(shape, samples.points, true), true);
    shape.origin = global(shape, round.centre);
    shape.sizes[0] = round.radius;
    return refined_if(shape, samples.points, tolerance);
}

// All tangent planes pass through the apex, and all normals make the same angle with the axis.
Shape cone_through(const ShapeSamples &samples, double tolerance) {
    std::vector<double> rows, right;
    for (size_t i = 0; i < samples.normals.size(); ++i) {
        const Vector3 &n = samples.normals[i];
        rows.insert(rows.end(), {n.x, n.y, n.z});
        right.push_back(dot(n, samples.feet[i]));
    }
    Shape shape;
    shape.kind = shape_cone;
    shape.origin = vector_of(SmallSvd(rows, 3, right).solution(cutoff));
    const SmallSvd axes = principal(samples.normals, mean_of(samples.normals));
    const Vector3 into = mean_of(samples.points) - shape.origin;
    Vector3 axis = vector_of(axes.direction(0));
    axis = dot(axis, into) < 0 ? -1 * axis : axis;
    shape.set_frame(axis, vector_of(axes.direction(2)));
    double sum = 0;
    for (const Vector3 &p : samples.feet) {
        const Vector3 q = shape.local(p);
        sum += std::atan2(std::hypot(q.x, q.y), q.z);
    }
    shape.sizes[0] = sum / static_cast<double>(samples.feet.size());
    return refined_if(shape, samples.points, tolerance);
}

// The line along a normal n at p meets the axis through c with direction a if (p x n) . a + n . (c x a) = 0,
// which is linear in a and c x a (Pluecker coordinates).
Shape torus_through(const ShapeSamples &samples, double tolerance) {
    std::vector<double> rows;
    for (size_t i = 0; i < samples.normals.size(); ++i) {
        const Vector3 &n = samples.normals[i], m = cross(samples.feet[i], n);
        rows.insert(rows.end(), {m.x * (1 / samples.size), m.y * (1 / samples.size), m.z * (1 / samples.size),
                                 n.x, n.y, n.z});
    }
    const std::vector<double> line = SmallSvd(rows, 6).direction(0);
    const Vector3 a{line[0], line[1], line[2]}, moment{line[3], line[4], line[5]};
    Shape shape;
    shape.kind = shape_torus;
    shape.set_frame(a, any_normal(unit(a)));
    shape.origin = samples.size / dot(a, a) * cross(a, moment);
    Points section;
    for (const Vector3 &p : local_points(shape, samples.points, false)) {
        section.push_back({std::hypot(p.x, p.y), p.z, 0});
    }
    const Round round = round_through(section, true);
    shape.origin = shape.origin + round.centre.y * shape.z;
    shape.sizes[0] = round.centre.x;
    shape.sizes[1] = round.radius;
    return shape.sizes[1] > 0 ? refined_if(shape, samples.points, tolerance) : Shape{};
}

Shape point_at_origin() noexcept {
    Shape shape;
    shape.kind = shape_point;
    return shape;
}

} // namespace

Shape fitted_shape(int32_t kind, const ShapeSamples &samples, int dim, double tolerance) {
    const Points &points = samples.points;
    switch (kind) {
    case shape_point:
        return point_at_origin();
    case shape_line:
        return line_of(points);
    case shape_circle:
        return circle_in(plane_of(points, dim), points, tolerance);
    case shape_parabola:
        return parabola_in(plane_of(points, dim), points, tolerance);
    case shape_ellipse:
    case shape_hyperbola:
        return central_conic_in(kind, plane_of(points, dim), points, tolerance);
    case shape_plane:
        return plane_of(points, dim);
    case shape_sphere:
        return sphere_through(points, tolerance);
    default:
        break;
    }
    if (samples.normals.size() < 6) {
        return {};
    }
    return kind == shape_cylinder ? cylinder_through(samples, tolerance)
           : kind == shape_cone   ? cone_through(samples, tolerance)
                                  : torus_through(samples, tolerance);
}

} // namespace nrb::recognize
