// SPDX-License-Identifier: MIT
#include "model/shapes/nearest_place.h"

#include "model/shapes/curve_map.h"
#include "model/shapes/surface_spline.h"

#include <algorithm>
#include <cmath>

namespace nrb::model {
namespace {

// Cylindrical coordinates about the axis of a placement. A negative radius goes with the opposite angle.
struct Cylindrical {
    double angle, radius, height;
};

Cylindrical cylindrical(const build::Placement &place, const double *point) noexcept {
    const Vector3 from = Vector3{point[0], point[1], point[2]} - place.origin;
    const double x = dot(from, place.x), y = dot(from, place.y);
    return {std::atan2(y, x), std::hypot(x, y), dot(from, place.z)};
}

// Whether a part of a surface is of that half of a cone where the radius is negative.
bool beyond_apex(const SurfaceShape &surface, Interval heights) noexcept {
    return surface.kind == SurfaceKind::cone &&
           surface.sizes[0] + (heights.lower + heights.upper) / 2 * std::tan(surface.sizes[1]) < 0;
}

// The parameter v of the foot point on the profile, a line or a circle in the half-plane of the point.
double along_profile(const SurfaceShape &surface, const Cylindrical &at) noexcept {
    switch (surface.kind) {
    case SurfaceKind::cone: {
        const double slope = std::tan(surface.sizes[1]);
        return (at.height + slope * (at.radius - surface.sizes[0])) / (1 + slope * slope);
    }
    case SurfaceKind::sphere:
        return std::atan2(at.height, at.radius);
    case SurfaceKind::torus:
        return std::atan2(at.height, at.radius - surface.sizes[0]);
    default:
        return at.height;
    }
}

// The angle modulo full turns in a range, or the nearer end of the range.
double angle_in(double angle, Interval range) noexcept {
    const double turns = std::floor((angle - range.lower) / turn);
    const double first = angle - turns * turn;
    if (first <= range.upper) {
        return first;
    }
    return first - range.upper < range.lower + turn - first ? range.upper : range.lower;
}

bool is_elementary(const SurfaceShape &surface) noexcept {
    const SurfaceKind kind = surface.kind;
    return kind == SurfaceKind::cylinder || kind == SurfaceKind::cone || kind == SurfaceKind::sphere ||
           (kind == SurfaceKind::torus && surface.sizes[1] < surface.sizes[0]);
}

} // namespace

face::NearestPlace nearest_place(const SurfaceShape &surface, const SplinePtr &spline) {
    if (!is_elementary(surface)) {
        return {};
    }
    const bool opposite = beyond_apex(surface, spline->axis(1).domain());
    return [surface, spline, opposite](const double *point) {
        Cylindrical at = cylindrical(surface.place, point);
        if (opposite) {
            at = {at.angle + turn / 2, -at.radius, at.height};
        }
        face::Point2 x{at.angle, along_profile(surface, at)};
        for (const int k : {0, 1}) {
            const KnotVector &axis = spline->axis(k);
            const ParameterLaw law = law_at(surface, k, axis.domain().lower);
            double &t = x[static_cast<size_t>(k)];
            t = law == ParameterLaw::angle ? angle_in(t, axis.domain())
                                           : std::clamp(t, axis.domain().lower, axis.domain().upper);
            t = to_spline_parameter(law, axis, t);
        }
        return x;
    };
}

} // namespace nrb::model
