// SPDX-License-Identifier: MIT
// Lines and polygons, circles and conics given by their axes, and helices.
#include "build/conics/conic_curves.h"
#include "build/helix.h"
#include "build/polylines.h"
#include "checks.h"
#include "guard.h"
#include "outputs.h"
#include "spline_data.h"

using namespace nrb;
using namespace nrb::capi;

namespace {

std::vector<double> counted(int64_t n) {
    std::vector<double> params(static_cast<size_t>(n));
    for (int64_t i = 0; i < n; ++i) {
        params[static_cast<size_t>(i)] = static_cast<double>(i);
    }
    return params;
}

} // namespace

nurbs_status nurbs_curve_line(int32_t dim, const double *a, const double *b, nurbs **out) {
    return guard([&] {
        require_out(out);
        check_dimension(dim);
        require(a, "a");
        require(b, "b");
        build::check_point(a, dim, "a");
        build::check_point(b, dim, "b");
        std::vector<double> points(a, a + dim);
        points.insert(points.end(), b, b + dim);
        give(build::polyline(dim, std::move(points), {0, 1}), out);
    });
}

nurbs_status nurbs_curve_polyline(int64_t n, int32_t dim, const double *points, int64_t point_stride,
                                  int64_t point_component_stride, const double *params, int64_t param_stride,
                                  nurbs **out) {
    return guard([&] {
        require_out(out);
        check_dimension(dim);
        check_length(n, "n");
        const ConstRecords corners = input("points", points, n, dim, point_stride, point_component_stride);
        std::vector<double> places =
            params == nullptr ? counted(n) : packed(input("params", params, n, param_stride));
        places.resize(static_cast<size_t>(n));
        give(build::polyline(dim, packed(corners), std::move(places)), out);
    });
}

nurbs_status nurbs_curve_polygon(int32_t dim, const double *center, const double *axis, const double *x,
                                 double radius, int64_t sides, nurbs **out) {
    return guard([&] {
        require_out(out);
        give(build::regular_polygon(build::make_placement(dim, center, axis, x, "center"), radius, sides),
             out);
    });
}

nurbs_status nurbs_curve_rounded_rectangle(int32_t dim, const double *center, const double *axis,
                                           const double *x, double width, double height, double corner_radius,
                                           nurbs **out) {
    return guard([&] {
        require_out(out);
        const build::Placement place = build::make_placement(dim, center, axis, x, "center");
        give(build::rounded_rectangle(place, width, height, corner_radius), out);
    });
}

nurbs_status nurbs_curve_circle(int32_t dim, const double *center, const double *axis, const double *x,
                                double radius, int32_t form, nurbs **out) {
    return guard([&] {
        require_out(out);
        const build::Placement place = build::make_placement(dim, center, axis, x, "center");
        build::check_positive_length(radius, "radius");
        give(build::ellipse(place, radius, radius, build::full_turn(), form), out);
    });
}

nurbs_status nurbs_curve_arc(int32_t dim, const double *center, const double *axis, const double *x,
                             double radius, double start, double sweep, int32_t form, nurbs **out) {
    return guard([&] {
        require_out(out);
        const build::Placement place = build::make_placement(dim, center, axis, x, "center");
        build::check_positive_length(radius, "radius");
        give(build::ellipse(place, radius, radius, build::make_turn(start, sweep), form), out);
    });
}

nurbs_status nurbs_curve_ellipse(int32_t dim, const double *center, const double *axis, const double *x,
                                 double radius_x, double radius_y, double start, double sweep, int32_t form,
                                 nurbs **out) {
    return guard([&] {
        require_out(out);
        const build::Placement place = build::make_placement(dim, center, axis, x, "center");
        build::check_positive_length(radius_x, "radius_x");
        build::check_positive_length(radius_y, "radius_y");
        give(build::ellipse(place, radius_x, radius_y, build::make_turn(start, sweep), form), out);
    });
}

nurbs_status nurbs_curve_parabola(int32_t dim, const double *vertex, const double *axis, const double *x,
                                  double focal_length, double start, double end, nurbs **out) {
    return guard([&] {
        require_out(out);
        give(build::parabola(build::make_placement(dim, vertex, axis, x, "vertex"), focal_length, start, end),
             out);
    });
}

nurbs_status nurbs_curve_hyperbola(int32_t dim, const double *center, const double *axis, const double *x,
                                   double radius_x, double radius_y, double start, double end, nurbs **out) {
    return guard([&] {
        require_out(out);
        give(build::hyperbola(build::make_placement(dim, center, axis, x, "center"), radius_x, radius_y,
                              start, end),
             out);
    });
}

nurbs_status nurbs_curve_helix(int32_t dim, const double *origin, const double *axis, const double *x,
                               double radius, double growth, double pitch, double start, double turns,
                               double tolerance, double *error, nurbs **out) {
    return guard([&] {
        require_out(out);
        const build::Placement place = build::make_placement(dim, origin, axis, x, "origin");
        build::HelixCurve made = build::helix(place, {radius, growth, pitch, start, turns}, tolerance);
        give(std::move(made.spline), out);
        put(error, made.error);
    });
}
