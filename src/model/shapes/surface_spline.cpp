// SPDX-License-Identifier: MIT
#include "model/shapes/surface_spline.h"

#include "base/error.h"
#include "build/conics/arc.h"
#include "build/surfaces/profile.h"
#include "build/surfaces/revolve.h"
#include "build/surfaces/ruled_extruded.h"
#include "model/shapes/curve_spline.h"
#include "refine/forms/parametrization.h"
#include "refine/forms/transform.h"
#include "refine/parts/cut.h"

#include <algorithm>
#include <cmath>

namespace nrb::model {
namespace {

double length_of(Interval range) noexcept {
    return range.upper - range.lower;
}

void check_range(Interval range, const char *name) {
    if (!std::isfinite(length_of(range))) {
        fail(Status::length, "the surface has no ends along %s", name);
    }
    if (!(range.lower < range.upper)) {
        fail(Status::empty_domain, "%s from %s to %s is empty", name, Number(range.lower).text,
             Number(range.upper).text);
    }
}

SplinePtr over(SplinePtr spline, const Rectangle &range) {
    spline = refine::reparametrize(spline, 0, range.u);
    return refine::reparametrize(spline, 1, range.v);
}

build::Turn turn_over(Interval range) {
    return build::make_turn(range.lower, sweep_of(range), "start of the range", "range");
}

SplinePtr plane_spline(const build::Placement &place, const Rectangle &range) {
    std::vector<double> points(12);
    double *out = points.data();
    for (const double u : {range.u.lower, range.u.upper}) {
        for (const double v : {range.v.lower, range.v.upper}) {
            place.point(u, v, 0, out);
            out += 3;
        }
    }
    const auto axis = [](Interval ends) {
        return make_knot_vector(1, {ends.lower, ends.lower, ends.upper, ends.upper});
    };
    return make_result({axis(range.u), axis(range.v)}, 3, Form::polynomial, std::move(points));
}

// The surface of a profile rotated about the axis of the surface.
SplinePtr turned(const SurfaceShape &surface, const Rectangle &range, const build::Profile &profile) {
    return over(
        build::turned(surface.place, build::unit_arc(turn_over(range.u), build::arc_quarters), profile),
        range);
}

// The profile of a cylinder or a cone. The apex of a cone, where its range ends, gets the radius 0 exactly.
build::Profile straight_profile(const SurfaceShape &surface, const Rectangle &range) {
    const double slope = surface.kind == SurfaceKind::cone ? std::tan(surface.sizes[1]) : 0;
    const Interval all = natural_range(surface).v;
    const auto end = [&](double v) {
        const bool apex = v == all.lower || v == all.upper;
        const DoubleDouble radius = DoubleDouble(surface.sizes[0]) + DoubleDouble::product(v, slope);
        return build::ProfilePoint{apex ? DoubleDouble() : radius, v};
    };
    return build::bezier_profile({end(range.v.lower), end(range.v.upper)});
}

// The profile of a sphere or a torus.
build::Profile round_profile(const SurfaceShape &surface, const Rectangle &range) {
    const bool sphere = surface.kind == SurfaceKind::sphere;
    return build::arc_profile(turn_over(range.v), build::arc_quarters, sphere ? 0 : surface.sizes[0],
                              surface.sizes[sphere ? 0 : 1]);
}

SplinePtr moved(const SplinePtr &spline, const Vector3 &by) {
    constexpr double identity[9] = {1, 0, 0, 0, 1, 0, 0, 0, 1};
    const double way[3] = {by.x, by.y, by.z};
    return largest(by) == 0 ? spline : refine::transform(*spline, {3, 3, identity}, way);
}

// Rotates a curve by an angle about the axis of a placement.
SplinePtr turned_curve(const SplinePtr &curve, const build::Placement &place, double angle) {
    if (angle == 0) {
        return curve;
    }
    const build::Direction d = build::make_angle(angle, "start of u").direction();
    const auto image = [&](const Vector3 &p) {
        const Vector3 along = dot(place.z, p) * place.z;
        return along + d.cos * (p - along) + d.sin * cross(place.z, p);
    };
    const Vector3 x = image({1, 0, 0}), y = image({0, 1, 0}), z = image({0, 0, 1});
    const Vector3 origin = place.origin - image(place.origin);
    const double matrix[9] = {x.x, y.x, z.x, x.y, y.y, z.y, x.z, y.z, z.z};
    const double way[3] = {origin.x, origin.y, origin.z};
    return refine::transform(*curve, {3, 3, matrix}, way);
}

SplinePtr revolution_spline(const SurfaceShape &surface, const Rectangle &range) {
    const SplinePtr curve = turned_curve(curve_spline(*surface.curve, range.v), surface.place, range.u.lower);
    const Vector3 &c = surface.place.origin, &z = surface.place.z;
    const double point[3] = {c.x, c.y, c.z}, axis[3] = {z.x, z.y, z.z};
    return over(build::revolve(*curve, point, axis, sweep_of(range.u), build::arc_quarters), range);
}

SplinePtr extrusion_spline(const SurfaceShape &surface, const Rectangle &range) {
    const SplinePtr curve = moved(curve_spline(*surface.curve, range.u), range.v.lower * surface.vector);
    const Vector3 way = length_of(range.v) * surface.vector;
    const double vector[3] = {way.x, way.y, way.z};
    return over(build::extrude(curve, vector), range);
}

SplinePtr spline_part(const SplinePtr &spline, const Rectangle &range) {
    SplinePtr part = spline;
    for (const int axis : {0, 1}) {
        const Interval domain = spline->axis(axis).domain(), wish = axis == 0 ? range.u : range.v;
        const Interval inside = {std::max(wish.lower, domain.lower), std::min(wish.upper, domain.upper)};
        check_range(inside, axis == 0 ? "u" : "v");
        part = refine::restrict_axis(part, axis, inside.lower, inside.upper);
    }
    return part;
}

Interval negated(Interval range) noexcept {
    return {-range.upper, -range.lower};
}

SplinePtr trimmed_spline(const SurfaceShape &surface, const Rectangle &range) {
    return directed(surface, surface_spline(*surface.basis, range_in_basis(surface, range)));
}

} // namespace

Rectangle range_in_basis(const SurfaceShape &trimmed, const Rectangle &range) noexcept {
    return {trimmed.u_forward ? range.u : negated(range.u), trimmed.v_forward ? range.v : negated(range.v)};
}

SplinePtr directed(const SurfaceShape &trimmed, SplinePtr spline) {
    spline = trimmed.u_forward ? spline : refine::reverse(*spline, 0, false);
    return trimmed.v_forward ? spline : refine::reverse(*spline, 1, false);
}

SplinePtr surface_spline(const SurfaceShape &surface, const Rectangle &range) {
    check_range(range.u, "u");
    check_range(range.v, "v");
    switch (surface.kind) {
    case SurfaceKind::plane:
        return plane_spline(surface.place, range);
    case SurfaceKind::cylinder:
    case SurfaceKind::cone:
        return turned(surface, range, straight_profile(surface, range));
    case SurfaceKind::sphere:
    case SurfaceKind::torus:
        return turned(surface, range, round_profile(surface, range));
    case SurfaceKind::revolution:
        return revolution_spline(surface, range);
    case SurfaceKind::extrusion:
        return extrusion_spline(surface, range);
    case SurfaceKind::offset:
        fail(Status::unsupported, "an offset surface is approximated only");
    case SurfaceKind::trimmed:
        return trimmed_spline(surface, range);
    default:
        return spline_part(surface.spline, range);
    }
}

ParameterLaw law_at(const SurfaceShape &surface, int axis, double t) noexcept {
    switch (surface.kind) {
    case SurfaceKind::cylinder:
    case SurfaceKind::cone:
        return axis == 0 ? ParameterLaw::angle : ParameterLaw::linear;
    case SurfaceKind::sphere:
    case SurfaceKind::torus:
        return ParameterLaw::angle;
    case SurfaceKind::revolution:
        return axis == 0 ? ParameterLaw::angle : law_at(*surface.curve, t);
    case SurfaceKind::extrusion:
        return axis == 0 ? law_at(*surface.curve, t) : ParameterLaw::linear;
    case SurfaceKind::offset:
        return law_at(*surface.basis, axis, t);
    case SurfaceKind::trimmed:
        return law_at(*surface.basis, axis, (axis == 0 ? surface.u_forward : surface.v_forward) ? t : -t);
    default:
        return ParameterLaw::linear;
    }
}

} // namespace nrb::model
