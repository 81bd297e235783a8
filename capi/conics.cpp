// SPDX-License-Identifier: MIT
// Arcs of circles and conics from points, tangents, equations and foci.
#include "build/conics/conic_conditions.h"
#include "build/conics/conic_curves.h"
#include "build/conics/conic_focus.h"
#include "build/conics/implicit_conic.h"
#include "checks.h"
#include "guard.h"
#include "spline_data.h"

#include <array>

using namespace nrb;
using namespace nrb::capi;

namespace {

void check_plane_dimension(int32_t dim) {
    check_dimension(dim);
    if (dim < 2) {
        fail(Status::dimension, "dim = %d, expected at least 2", dim);
    }
}

build::Coordinates point_of(const double *point, int32_t dim, const char *name) {
    require(point, name);
    build::check_point(point, dim, name);
    return {point, static_cast<size_t>(dim)};
}

build::Coordinates direction_of(const double *direction, int32_t dim, const char *name) {
    require(direction, name);
    build::check_direction(direction, dim, name);
    return {direction, static_cast<size_t>(dim)};
}

} // namespace

nurbs_status nurbs_curve_arc_through(int32_t dim, const double *a, const double *b, const double *c,
                                     int32_t form, nurbs **out) {
    return guard([&] {
        require_out(out);
        check_plane_dimension(dim);
        const build::Coordinates start = point_of(a, dim, "a");
        const build::Coordinates between = point_of(b, dim, "b");
        give(build::arc_through(start, between, point_of(c, dim, "c"), form), out);
    });
}

nurbs_status nurbs_curve_arc_tangent(int32_t dim, const double *a, const double *tangent, const double *b,
                                     int32_t form, nurbs **out) {
    return guard([&] {
        require_out(out);
        check_plane_dimension(dim);
        const build::Coordinates start = point_of(a, dim, "a");
        const build::Coordinates direction = direction_of(tangent, dim, "tangent");
        give(build::arc_tangent(start, direction, point_of(b, dim, "b"), form), out);
    });
}

nurbs_status nurbs_curve_conic_triangle(int32_t dim, const double *p0, const double *p1, const double *p2,
                                        double shape_factor, nurbs **out) {
    return guard([&] {
        require_out(out);
        check_dimension(dim);
        point_of(p0, dim, "p0");
        point_of(p1, dim, "p1");
        point_of(p2, dim, "p2");
        give(build::conic_by_shape_factor(dim, p0, p1, p2, shape_factor), out);
    });
}

nurbs_status nurbs_curve_conic_shoulder(int32_t dim, const double *a, const double *tangent_a,
                                        const double *b, const double *tangent_b, double rho, nurbs **out) {
    return guard([&] {
        require_out(out);
        check_plane_dimension(dim);
        const build::Coordinates start = point_of(a, dim, "a"), end = point_of(b, dim, "b");
        const build::Coordinates leaving = direction_of(tangent_a, dim, "tangent_a");
        give(build::conic_shoulder(start, leaving, end, direction_of(tangent_b, dim, "tangent_b"), rho), out);
    });
}

nurbs_status nurbs_curve_conic_point(int32_t dim, const double *a, const double *tangent_a, const double *b,
                                     const double *tangent_b, const double *point, int32_t form,
                                     nurbs **out) {
    return guard([&] {
        require_out(out);
        check_plane_dimension(dim);
        const build::Coordinates start = point_of(a, dim, "a"), end = point_of(b, dim, "b");
        const build::Coordinates leaving = direction_of(tangent_a, dim, "tangent_a");
        const build::Coordinates arriving = direction_of(tangent_b, dim, "tangent_b");
        give(build::conic_point(start, leaving, end, arriving, point_of(point, dim, "point"), form), out);
    });
}

nurbs_status nurbs_curve_conic_through(int32_t dim, const double *points, int64_t point_stride,
                                       int64_t point_component_stride, int32_t form, nurbs **out) {
    return guard([&] {
        require_out(out);
        check_plane_dimension(dim);
        require(points, "points");
        const std::vector<double> all =
            packed(input("points", points, 5, dim, point_stride, point_component_stride));
        for (int64_t i = 0; i < 5; ++i) {
            const std::array<char, 10> name = {'p', 'o', 'i', 'n', 't', 's', '[', static_cast<char>('0' + i),
                                               ']', 0};
            build::check_point(all.data() + i * dim, dim, name.data());
        }
        give(build::conic_through({all.data(), 5 * static_cast<size_t>(dim)}, dim, form), out);
    });
}

nurbs_status nurbs_curve_conic_implicit(const double *coefficients, double start, double end, int32_t form,
                                        nurbs **out) {
    return guard([&] {
        require_out(out);
        require(coefficients, "coefficients");
        give(build::implicit_conic(coefficients, start, end, form), out);
    });
}

nurbs_status nurbs_curve_conic_focus(int32_t dim, const double *focus, const double *axis, const double *foot,
                                     double eccentricity, double start, double sweep, int32_t form,
                                     nurbs **out) {
    return guard([&] {
        require_out(out);
        require(focus, "focus");
        require(foot, "foot");
        give(build::conic_focus(build::focal_frame(dim, focus, axis, foot), eccentricity,
                                build::make_turn(start, sweep), form),
             out);
    });
}
