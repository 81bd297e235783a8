// SPDX-License-Identifier: MIT
// Level curves of functions on surfaces: silhouettes, isophotes and parabolic curves, reflection and
// highlight lines, zeros of implicit polynomials, and levels of scalar splines.
#include "batch.h"
#include "checks.h"
#include "guard.h"
#include "implicit_argument.h"
#include "meets.h"
#include "watched.h"

#include "base/checked.h"
#include "base/tolerance.h"
#include "intersect/levels/contours.h"
#include "intersect/levels/function_levels.h"
#include "intersect/levels/reflections.h"
#include "numeric/vector3.h"
#include "spline/kind.h"

#include <array>
#include <cmath>
#include <memory>
#include <span>
#include <utility>

using namespace nrb;
using namespace nrb::capi;

namespace {

using intersect::ContourKind;
using intersect::ReflectionKind;

const Spline &surface_in_space(const nurbs *g) {
    const Spline &surface = surface_of(g);
    check_dimension(surface, 3, 3);
    return surface;
}

ContourKind checked_kind(int32_t kind) {
    if (kind < NURBS_CONTOUR_SILHOUETTE || kind > NURBS_CONTOUR_PARABOLIC) {
        fail(Status::rule, "kind = %d, expected one of the NURBS_CONTOUR_ constants", kind);
    }
    return static_cast<ContourKind>(kind);
}

std::array<double, 3> checked_place(const double *x, const char *name) {
    require(x, name);
    for (int c = 0; c < 3; ++c) {
        if (!std::isfinite(x[c])) {
            fail(Status::direction, "%s[%d] = %s, expected a number", name, c, Number(x[c]).text);
        }
    }
    return {x[0], x[1], x[2]};
}

// The direction as a unit vector.
std::array<double, 3> checked_direction(const double *d, const char *name) {
    require(d, name);
    check_direction(name, d);
    const Vector3 u = unit(Vector3{d[0], d[1], d[2]});
    return {u.x, u.y, u.z};
}

std::array<double, 3> checked_vector(ContourKind kind, const double *d) {
    switch (kind) {
    case ContourKind::parabolic:
        return {};
    case ContourKind::perspective:
        return checked_place(d, "d");
    default:
        return checked_direction(d, "d");
    }
}

ReflectionKind checked_reflection(int32_t kind) {
    if (kind < NURBS_REFLECTION_HIGHLIGHT || kind > NURBS_REFLECTION_FROM) {
        fail(Status::rule, "kind = %d, expected one of the NURBS_REFLECTION_ constants", kind);
    }
    return static_cast<ReflectionKind>(kind);
}

std::array<double, 3> checked_eye(ReflectionKind kind, const double *eye) {
    switch (kind) {
    case ReflectionKind::along:
        return checked_direction(eye, "eye");
    case ReflectionKind::from:
        return checked_place(eye, "eye");
    default:
        return {};
    }
}

std::span<const double> checked_cosines(ContourKind kind, int64_t n, const double *cosines) {
    check_length(n, "n");
    if (kind != ContourKind::isophote && n > 0) {
        fail(Status::count, "n = %lld cosines, expected 0 for all but isophotes", static_cast<long long>(n));
    }
    checked_array(n, "cosines");
    if (n > 0) {
        require(cosines, "cosines");
    }
    for (int64_t i = 0; i < n; ++i) {
        if (!(std::abs(cosines[i]) <= 1)) {
            fail(Status::factor, "cosines[%lld] = %s, expected one in [-1, 1]", static_cast<long long>(i),
                 Number(cosines[i]).text);
        }
    }
    return {cosines, static_cast<size_t>(n)};
}

} // namespace

nurbs_status nurbs_surface_contours(const nurbs *g, int32_t kind, const double *d, int64_t n,
                                    const double *cosines, double tolerance, nurbs_meet **out) {
    return guard([&] {
        require_out(out);
        const Spline &surface = surface_in_space(g);
        const ContourKind contour = checked_kind(kind);
        const std::array<double, 3> vector = checked_vector(contour, d);
        const std::span<const double> all = checked_cosines(contour, n, cosines);
        check_positive_tolerance(tolerance);
        give_meet(intersect::surface_contours(surface, contour, vector, all, tolerance), out);
    });
}

nurbs_status nurbs_surface_contours_with(const nurbs *g, int32_t kind, const double *d, int64_t n,
                                         const double *cosines, double tolerance,
                                         const nurbs_call_options *call, nurbs_meet **out) {
    return watched(call, out, [&] { return nurbs_surface_contours(g, kind, d, n, cosines, tolerance, out); });
}

nurbs_status nurbs_surface_reflections(const nurbs *g, int32_t kind, const double *eye,
                                       const double *direction, int64_t n, const double *points,
                                       int64_t point_stride, int64_t point_component_stride, double tolerance,
                                       nurbs_meet **out) {
    return guard([&] {
        require_out(out);
        const Spline &surface = surface_in_space(g);
        require(direction, "direction");
        if (n > 0) {
            require(points, "points");
        }
        const ReflectionKind reflection = checked_reflection(kind);
        const std::array<double, 3> seen = checked_eye(reflection, eye),
                                    along = checked_direction(direction, "direction");
        check_length(n, "n");
        const ConstRecords lights = input("points", points, n, 3, point_stride, point_component_stride);
        check_positive_tolerance(tolerance);
        check_points("points", lights);
        give_meet(intersect::surface_reflections(surface, reflection, seen, along, lights, tolerance), out);
    });
}

nurbs_status nurbs_surface_reflections_with(const nurbs *g, int32_t kind, const double *eye,
                                            const double *direction, int64_t n, const double *points,
                                            int64_t point_stride, int64_t point_component_stride,
                                            double tolerance, const nurbs_call_options *call,
                                            nurbs_meet **out) {
    return watched(call, out, [&] {
        return nurbs_surface_reflections(g, kind, eye, direction, n, points, point_stride,
                                         point_component_stride, tolerance, out);
    });
}

nurbs_status nurbs_surface_level(const nurbs *g, int32_t degree, const double *coefficients, double tolerance,
                                 nurbs_meet **out) {
    return guard([&] {
        require_out(out);
        const Spline &surface = surface_in_space(g);
        const intersect::ImplicitForm form = checked_form(3, degree, coefficients);
        check_positive_tolerance(tolerance);
        give_meet(intersect::implicit_level(surface, form, tolerance), out);
    });
}

nurbs_status nurbs_surface_level_with(const nurbs *g, int32_t degree, const double *coefficients,
                                      double tolerance, const nurbs_call_options *call, nurbs_meet **out) {
    return watched(call, out, [&] { return nurbs_surface_level(g, degree, coefficients, tolerance, out); });
}

nurbs_status nurbs_surface_level_curves(const nurbs *g, const nurbs *scalar, int64_t n, const double *values,
                                        double tolerance, nurbs_meet **out) {
    return guard([&] {
        require_out(out);
        surface_in_space(g);
        const Spline &function = named(scalar, "scalar");
        const std::span<const double> all = checked_values(n, values, "values");
        check_kind(function, 2, "scalar");
        check_dimension(function, 1, 1, "scalar");
        check_positive_tolerance(tolerance);
        give_meet(intersect::scalar_levels(g->spline, scalar->spline, all, tolerance), out);
    });
}

nurbs_status nurbs_surface_level_curves_with(const nurbs *g, const nurbs *scalar, int64_t n,
                                             const double *values, double tolerance,
                                             const nurbs_call_options *call, nurbs_meet **out) {
    return watched(call, out,
                   [&] { return nurbs_surface_level_curves(g, scalar, n, values, tolerance, out); });
}
