// SPDX-License-Identifier: MIT
#include "model/shapes/surface_shape.h"

#include "base/error.h"
#include "model/shapes/curve_spline.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace nrb::model {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr Interval around = {0, turn};
constexpr Interval endless = {-infinity, infinity};
constexpr Interval none = {infinity, -infinity};

bool finite(Interval range) noexcept {
    return std::isfinite(range.lower) && std::isfinite(range.upper);
}

void include(Interval &range, double value) noexcept {
    range = {std::min(range.lower, value), std::max(range.upper, value)};
}

// The v on the side of the apex on which the radius is not negative.
Interval heights_of_cone(const SurfaceShape &cone) noexcept {
    const double slope = std::tan(cone.sizes[1]), apex = -cone.sizes[0] / slope;
    return slope > 0 ? Interval{apex, infinity} : (slope < 0 ? Interval{-infinity, apex} : endless);
}

Interval turned_around(Interval range, bool forward) noexcept {
    return forward ? range : Interval{-range.upper, -range.lower};
}

// Replaces the infinite ends of a range, so that it contains the given values with a margin.
Interval replaced(Interval range, Interval values, double size, double margin) noexcept {
    const double length = values.upper - values.lower;
    const double more = std::max({margin * length, margin * size, std::numeric_limits<double>::min()});

    if (!std::isfinite(range.lower)) {
        range.lower = std::min(values.lower, range.upper) - more;
    }
    if (!std::isfinite(range.upper)) {
        range.upper = std::max(values.upper, range.lower) + more;
    }
    return range;
}

// range_around() for an unbounded surface that is not an offset surface.
class PointsAround {
public:
    PointsAround(const SurfaceShape &surface, std::span<const Vector3> points, double margin)
        : surface_(surface), points_(points), margin_(margin) {
        for (const Vector3 &point : points_) {
            include(x_, local(point).x);
            include(y_, local(point).y);
            include(z_, local(point).z);
        }
        size_ = std::max({x_.upper - x_.lower, y_.upper - y_.lower, z_.upper - z_.lower});
    }

    [[nodiscard]] Rectangle range() const {
        const Rectangle all = natural_range(surface_);
        switch (surface_.kind) {
        case SurfaceKind::plane:
            return {replaced(all.u, x_, size_, margin_), replaced(all.v, y_, size_, margin_)};
        case SurfaceKind::revolution:
            return {all.u, finite(all.v) ? all.v : profile_range()};
        case SurfaceKind::extrusion:
            return extruded_range(all);
        default:
            return {all.u, heights(all.v)};
        }
    }

private:
    [[nodiscard]] Vector3 local(const Vector3 &point) const noexcept {
        return local_vector(point - surface_.place.origin);
    }
    [[nodiscard]] Vector3 local_vector(const Vector3 &p) const noexcept {
        return {dot(surface_.place.x, p), dot(surface_.place.y, p), dot(surface_.place.z, p)};
    }

    [[nodiscard]] Interval profile_range() const {
        if (surface_.curve->kind == CurveKind::line) {
            return profile_line_range();
        }
        double far = 0; // rotation keeps the distance from a point of the axis
        for (const Vector3 &point : points_) {
            far = std::max(far, length(point - surface_.place.origin));
        }
        return range_near(*surface_.curve, surface_.place.origin, far * (1 + margin_));
    }

    // The range of v of a cylinder, or of a cone, which ends at its apex. If the points are beyond the apex,
    // it is a range of the other half of the cone, where the radius is negative.
    [[nodiscard]] Interval heights(Interval all) const {
        const Interval range = replaced(endless, z_, size_, margin_);
        const double middle = (z_.lower + z_.upper) / 2;
        if (middle < all.lower) {
            all = {-infinity, all.lower};
        } else if (middle > all.upper) {
            all = {all.upper, infinity};
        }
        return {std::max(range.lower, all.lower), std::min(range.upper, all.upper)};
    }

    // The range of v where the profile is a line. A point gets its v from its height along the axis or, if
    // the line is perpendicular to the axis, from its radius. Where the line meets the axis, the range ends:
    // beyond, it would trace the same surface again, or the other half of a cone.
    [[nodiscard]] Interval profile_line_range() const {
        const CurveShape &line = *surface_.curve;
        const Vector3 start = local(line.place.origin), way = line.sizes[0] * local_vector(line.place.x);
        const double run = std::hypot(way.x, way.y);
        const double before = run > 0 ? (start.x * way.x + start.y * way.y) / (run * run) : 0;
        const double miss = std::hypot(start.x - before * way.x, start.y - before * way.y);
        const bool across = std::fabs(way.z) <= 1e-7 * run, meets = run > 0 && miss <= 1e-9 * length(start);
        Interval values = none;
        for (const Vector3 &point : points_) {
            const Vector3 p = local(point);
            const double side =
                std::sqrt(std::max(p.x * p.x + p.y * p.y - miss * miss, 0.0)) / std::max(run, 1e-300);
            include(values, across ? std::copysign(side, before) - before : (p.z - start.z) / way.z);
        }
        Interval range = replaced(endless, values, size_ / line.sizes[0], margin_);
        if (meets && (values.lower + values.upper) / 2 > -before) {
            range.lower = std::max(range.lower, -before);
        } else if (meets) {
            range.upper = std::min(range.upper, -before);
        }
        return range;
    }

    [[nodiscard]] Rectangle extruded_range(const Rectangle &all) const {
        return has_plane(*surface_.curve) ? extruded_plane_curve(all)
                                          : Rectangle{all.u, ways_of_bounded_curve(all.u)};
    }

    // Lines and conics are planar. A line has a plane with every direction except its own.
    static bool has_plane(const CurveShape &curve) noexcept { return curve.kind <= CurveKind::hyperbola; }

    // Let N be the normal of the plane of the curve through C, and V the vector of the extrusion. A point p
    // of the surface has v = (p - C) N / V N, and p - v V is on the curve.
    [[nodiscard]] Rectangle extruded_plane_curve(const Rectangle &all) const {
        const CurveShape &curve = *surface_.curve;
        const Vector3 &way = surface_.vector;
        const Vector3 normal =
            curve.kind == CurveKind::line ? cross(curve.place.x, cross(way, curve.place.x)) : curve.place.z;
        const double slope = dot(way, normal);
        Interval v = none, along = none;
        double far = 0;
        for (const Vector3 &point : points_) {
            const Vector3 p = point - curve.place.origin;
            const double t = dot(p, normal) / slope;
            const Vector3 foot = p - t * way;
            include(v, t);
            include(along, dot(foot, curve.place.x) / curve.sizes[0]);
            far = std::max(far, length(foot));
        }
        const double step = size_ / length(way);
        if (curve.kind == CurveKind::line) {
            return {replaced(all.u, along, size_ / curve.sizes[0], margin_),
                    replaced(all.v, v, step, margin_)};
        }
        const Interval u = range_near(curve, curve.place.origin, far * (1 + margin_));
        return {u, replaced(all.v, v, step, margin_)};
    }

    // The range of v, from the extents of the points and of the curve along V.
    [[nodiscard]] Interval ways_of_bounded_curve(Interval u) const {
        const double squared = dot(surface_.vector, surface_.vector);
        Interval points = none, curve = none;
        for (const Vector3 &point : points_) {
            include(points, dot(point, surface_.vector) / squared);
        }
        for (const Vector3 &point : hull_of(*surface_.curve, u)) {
            include(curve, dot(point, surface_.vector) / squared);
        }
        const Interval both = {points.lower - curve.upper, points.upper - curve.lower};
        return replaced(endless, both, size_ / std::sqrt(squared), margin_);
    }

    static std::vector<Vector3> hull_of(const CurveShape &curve, Interval range);

    const SurfaceShape &surface_;
    std::span<const Vector3> points_;
    double margin_;
    Interval x_ = none, y_ = none, z_ = none;
    double size_ = 0;
};

std::vector<Vector3> PointsAround::hull_of(const CurveShape &curve, Interval range) {
    const SplinePtr spline = curve_spline(curve, range);
    std::vector<Vector3> points;
    for (int64_t i = 0; i < spline->point_count(); ++i) {
        points.push_back({spline->coordinate(i, 0), spline->coordinate(i, 1), spline->coordinate(i, 2)});
    }
    return points;
}

// Points whose convex hull contains everything within a distance of the hull of the given ones. Each point is
// replaced by the vertices of an octahedron that contains the ball around it.
std::vector<Vector3> widened(std::span<const Vector3> points, double distance) {
    std::vector<Vector3> more;
    for (const Vector3 &point : points) {
        for (const double sign : {-1.0, 1.0}) {
            const double by = std::sqrt(3.0) * sign * distance;
            more.insert(more.end(),
                        {point + Vector3{by, 0, 0}, point + Vector3{0, by, 0}, point + Vector3{0, 0, by}});
        }
    }
    return more;
}

} // namespace

Rectangle natural_range(const SurfaceShape &surface) noexcept {
    switch (surface.kind) {
    case SurfaceKind::plane:
        return {endless, endless};
    case SurfaceKind::cylinder:
        return {around, endless};
    case SurfaceKind::cone:
        return {around, heights_of_cone(surface)};
    case SurfaceKind::sphere:
        return {around, {-std::numbers::pi / 2, std::numbers::pi / 2}};
    case SurfaceKind::torus:
        return {around, surface.range.v};
    case SurfaceKind::revolution:
        return {around, natural_range(*surface.curve)};
    case SurfaceKind::extrusion:
        return {natural_range(*surface.curve), endless};
    case SurfaceKind::offset:
        return natural_range(*surface.basis);
    case SurfaceKind::trimmed:
        return {turned_around(surface.range.u, surface.u_forward),
                turned_around(surface.range.v, surface.v_forward)};
    default:
        return {surface.spline->axis(0).domain(), surface.spline->axis(1).domain()};
    }
}

bool bounded(const SurfaceShape &surface) noexcept {
    const Rectangle range = natural_range(surface);
    return finite(range.u) && finite(range.v);
}

Measure measure_of(const SurfaceShape &surface, int axis) noexcept {
    const auto of_curve = [](const CurveShape &curve) {
        const CurveShape *at = &curve;
        while (at->kind == CurveKind::trimmed) {
            at = at->pieces.front().curve.get();
        }
        return at->kind == CurveKind::circle || at->kind == CurveKind::ellipse ? Measure::angle
                                                                               : Measure::ratio;
    };
    switch (surface.kind) {
    case SurfaceKind::plane:
        return Measure::length;
    case SurfaceKind::cylinder:
    case SurfaceKind::cone:
        return axis == 0 ? Measure::angle : Measure::length;
    case SurfaceKind::sphere:
    case SurfaceKind::torus:
        return Measure::angle;
    case SurfaceKind::revolution:
        return axis == 0 ? Measure::angle : of_curve(*surface.curve);
    case SurfaceKind::extrusion:
        return axis == 0 ? of_curve(*surface.curve) : Measure::ratio;
    case SurfaceKind::offset:
    case SurfaceKind::trimmed:
        return measure_of(*surface.basis, axis);
    default:
        return Measure::ratio;
    }
}

Rectangle range_around(const SurfaceShape &surface, std::span<const Vector3> points, double margin) {
    if (bounded(surface)) {
        return natural_range(surface);
    }
    if (points.empty()) {
        fail(Status::too_few_points, "the surface has no ends, and nothing bounds the face");
    }
    if (surface.kind == SurfaceKind::offset) {
        return range_around(*surface.basis, widened(points, surface.distance), margin);
    }
    return PointsAround(surface, points, margin).range();
}

} // namespace nrb::model
