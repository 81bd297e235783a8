// SPDX-License-Identifier: MIT
#include "build/surfaces/quadrics.h"

#include "base/error.h"
#include "base/representable.h"
#include "build/surfaces/profile.h"
#include "refine/knots/bezier_rows.h"

#include <array>
#include <cmath>

namespace nrb::build {

namespace {

Turn pole_to_pole() noexcept {
    return {Angle::quarters(-1), Angle::quarters(2)};
}

[[noreturn]] void fail_latitudes(double south, double north) {
    fail(Status::angle, "latitudes south = %s and north = %s, expected -pi/2 <= south < north <= pi/2",
         Number(south).text, Number(north).text);
}

Turn latitudes(double south, double north) {
    const Angle from = make_angle(south, "south"), to = make_angle(north, "north");
    const double pole = Angle::quarters(1).radians();
    const Angle sweep = to.plus(from, -1, 1);
    if (from.radians() < -pole || to.radians() > pole || !(sweep.radians() > 0)) {
        fail_latitudes(south, north);
    }
    return {from, sweep};
}

void check_end_radius(double radius, const char *name) {
    if (!std::isfinite(radius) || radius < 0) {
        fail(Status::length, "%s = %s, expected a finite length of at least 0", name, Number(radius).text);
    }
}

void check_semi_axes(double radius_x, double radius_y) {
    check_positive_length(radius_x, "radius_x");
    check_positive_length(radius_y, "radius_y");
}

void check_hyperboloid(const HyperboloidSize &size) {
    const auto &[radius_x, radius_y, radius_z, bottom, top, two_sheets] = size;
    check_semi_axes(radius_x, radius_y);
    check_positive_length(radius_z, "radius_z");
    if (!std::isfinite(bottom) || !std::isfinite(top) || !(bottom < top)) {
        fail(Status::length, "bottom = %s and top = %s, expected finite heights, bottom below top",
             Number(bottom).text, Number(top).text);
    }
    if (two_sheets && bottom < radius_z && top > -radius_z) {
        fail(Status::length, "bottom = %s and top = %s, expected both at least %s or both at most -%s",
             Number(bottom).text, Number(top).text, Number(radius_z).text, Number(radius_z).text);
    }
}

} // namespace

SplinePtr spherical_patch(const Placement &place, double radius, const Turn &turn, double south, double north,
                          int32_t form) {
    check_positive_length(radius, "radius");
    return turned(place, unit_arc(turn, form), arc_profile(latitudes(south, north), form, 0, radius));
}

SplinePtr sphere(const Placement &place, double radius, int32_t form) {
    check_positive_length(radius, "radius");
    return turned(place, unit_arc(full_turn(), form), arc_profile(pole_to_pole(), form, 0, radius));
}

SplinePtr ellipsoid(const Placement &place, double radius_x, double radius_y, double radius_z, int32_t form) {
    check_semi_axes(radius_x, radius_y);
    check_positive_length(radius_z, "radius_z");
    Profile profile = arc_profile(pole_to_pole(), form, 0, 1);
    for (ProfilePoint &point : profile.points) {
        point.height = DoubleDouble(radius_z) * point.height;
    }
    return turned(place, unit_arc(full_turn(), form), profile, radius_x, radius_y);
}

SplinePtr cylinder(const Placement &place, double radius, double height, const Turn &turn, int32_t form) {
    check_positive_length(radius, "radius");
    check_positive_length(height, "height");
    return turned(place, unit_arc(turn, form), bezier_profile({{radius, 0}, {radius, height}}));
}

SplinePtr cone(const Placement &place, double base_radius, double top_radius, double height, const Turn &turn,
               int32_t form) {
    check_end_radius(base_radius, "base_radius");
    check_end_radius(top_radius, "top_radius");
    if (base_radius == top_radius) {
        fail(Status::length, "base_radius = %s is top_radius, expected two radii that differ",
             Number(base_radius).text);
    }
    check_positive_length(height, "height");
    return turned(place, unit_arc(turn, form), bezier_profile({{base_radius, 0}, {top_radius, height}}));
}

SplinePtr torus(const Placement &place, double major_radius, double minor_radius, const Turn &turn,
                const Turn &tube, int32_t form) {
    check_positive_length(major_radius, "major_radius");
    check_positive_length(minor_radius, "minor_radius");
    return turned(place, unit_arc(turn, form), arc_profile(tube, form, major_radius, minor_radius));
}

SplinePtr paraboloid(const Placement &place, double radius_x, double radius_y, double height,
                     const Turn &turn, int32_t form) {
    check_semi_axes(radius_x, radius_y);
    check_positive_length(height, "height");
    return turned(place, unit_arc(turn, form), bezier_profile({{0, 0}, {0.5, 0}, {1, height}}), radius_x,
                  radius_y);
}

// (2 s - 1)^2 has the control points 1, -1, 1.
SplinePtr saddle(const Placement &place, double radius_x, double radius_y, double height) {
    check_semi_axes(radius_x, radius_y);
    check_positive_length(height, "height");
    constexpr std::array<double, 3> line = {-1, 0, 1}, square = {1, -1, 1};
    std::vector<double> points(27);
    for (size_t i = 0; i < 9; ++i) {
        const size_t k = i / 3, l = i % 3;
        place.point(line[k] * radius_x, line[l] * radius_y, (square[k] - square[l]) * height,
                    points.data() + 3 * i);
    }
    require_representable(points, "control points");
    const KnotVectorPtr axis = refine::bezier_knots(2, std::array<double, 2>{0, 1});
    return make_result({axis, axis}, 3, Form::polynomial, std::move(points));
}

SplinePtr hyperboloid(const Placement &place, const HyperboloidSize &size, const Turn &turn, int32_t form) {
    check_hyperboloid(size);
    return turned(place, unit_arc(turn, form),
                  hyperbola_profile(size.radius_z, size.bottom, size.top, size.two_sheets), size.radius_x,
                  size.radius_y);
}

} // namespace nrb::build
