// SPDX-License-Identifier: MIT
// Bounds of splines: axis-aligned and oriented boxes, tangent and normal cones, extreme points.
#include "checks.h"
#include "guard.h"
#include "outputs.h"
#include "part.h"

#include "base/tolerance.h"
#include "bounds/box.h"
#include "bounds/cone.h"
#include "build/placement.h"
#include "spline/kind.h"

#include <span>

using namespace nrb;
using namespace nrb::capi;

namespace {

void check_surface_in_space(const Spline &spline) {
    check_kind(spline, 2);
    check_dimension(spline, 3, 3);
}

void put_cone(const bounds::Cone &cone, double *direction, double *angle) {
    put_all(direction, cone.direction);
    put(angle, cone.angle);
}

} // namespace

nurbs_status nurbs_box(const nurbs *g, const double *range, double tolerance, double *lower, double *upper,
                       double *gap) {
    return guard([&] {
        const Spline &spline = spline_of(g);
        const Part part = checked_part(spline, range);
        check_tolerance(tolerance);
        require(lower, "lower");
        require(upper, "upper");
        check_apart({memory("lower", lower, spline.dim()), memory("upper", upper, spline.dim()),
                     memory("gap", gap, 1)},
                    {memory("range", range, 2 * int64_t{spline.axes()})});
        const bounds::Box box = bounds::bounding_box(spline, part, tolerance);
        put_all(lower, box.lower);
        put_all(upper, box.upper);
        put(gap, box.gap);
    });
}

nurbs_status nurbs_oriented_box(const nurbs *g, double tolerance, double *center, double *axes,
                                double *half) {
    return guard([&] {
        const Spline &spline = spline_of(g);
        check_tolerance(tolerance);
        require(center, "center");
        require(axes, "axes");
        require(half, "half");
        check_dimension(spline, 1, bounds::max_box_dimension);
        const int64_t dim = spline.dim();
        check_apart(
            {memory("center", center, dim), memory("axes", axes, dim * dim), memory("half", half, dim)}, {});
        const bounds::OrientedBox box = bounds::oriented_box(spline, tolerance);
        put_all(center, box.center);
        put_all(axes, box.axes);
        put_all(half, box.half);
    });
}

nurbs_status nurbs_tangent_cone(const nurbs *g, int32_t axis, const double *range, double tolerance,
                                double *direction, double *angle) {
    return guard([&] {
        const Spline &spline = spline_of(g);
        check_axis(spline, axis);
        const Part part = checked_part(spline, range);
        check_tolerance(tolerance);
        require(direction, "direction");
        require(angle, "angle");
        check_apart({memory("direction", direction, spline.dim()), memory("angle", angle, 1)},
                    {memory("range", range, 2 * int64_t{spline.axes()})});
        put_cone(bounds::tangent_cone(spline, axis, part, tolerance), direction, angle);
    });
}

nurbs_status nurbs_normal_cone(const nurbs *g, const double *range, double tolerance, double *direction,
                               double *angle) {
    return guard([&] {
        const Spline &spline = spline_of(g);
        check_surface_in_space(spline);
        const Part part = checked_part(spline, range);
        check_tolerance(tolerance);
        require(direction, "direction");
        require(angle, "angle");
        check_apart({memory("direction", direction, 3), memory("angle", angle, 1)},
                    {memory("range", range, 4)});
        put_cone(bounds::normal_cone(spline, part, tolerance), direction, angle);
    });
}

nurbs_status nurbs_extreme_point(const nurbs *g, const double *direction, const double *range,
                                 double tolerance, double *params, double *value, double *bound) {
    return guard([&] {
        const Spline &spline = spline_of(g);
        require(direction, "direction");
        build::check_direction(direction, spline.dim(), "direction");
        const Part part = checked_part(spline, range);
        check_tolerance(tolerance);
        const int64_t axes = spline.axes();
        check_apart({memory("params", params, axes), memory("value", value, 1), memory("bound", bound, 1)},
                    {memory("direction", direction, spline.dim()), memory("range", range, 2 * axes)});
        const bounds::ExtremePoint point = bounds::extreme_point(spline, direction, part, tolerance);
        put_all(params, std::span(point.params).first(static_cast<size_t>(axes)));
        put(value, point.value);
        put(bound, point.bound);
    });
}
