// SPDX-License-Identifier: MIT
// Deformations: warping, flattening, bending, free-form deformation, fairing, and boundaries moved onto
// others.
#include "checks.h"
#include "guard.h"
#include "outputs.h"
#include "part.h"

#include "base/representable.h"
#include "base/tolerance.h"
#include "build/placement.h"
#include "modify/deform/bend.h"
#include "modify/deform/fair.h"
#include "modify/deform/flatten.h"
#include "modify/deform/free_form.h"
#include "modify/deform/snap_boundary.h"
#include "modify/deform/warp.h"

#include <array>
#include <cmath>

using namespace nrb;
using namespace nrb::capi;

namespace {

void check_vector(const double *direction, const Spline &spline, const char *name) {
    require(direction, name);
    build::check_direction(direction, spline.dim(), name);
}

void check_place_in_space(const double *point, const Spline &spline, const char *name) {
    require(point, name);
    build::check_point(point, spline.dim(), name);
}

void check_order_in(int32_t order, int32_t least, int32_t most) {
    if (order < least || order > most) {
        fail(Status::order, "order = %d, expected %d to %d", order, least, most);
    }
}

void give_deformed(modify::DeformedShape shape, double *deviation, int32_t *proven, ::nurbs **out) {
    give(std::move(shape.spline), out);
    put(deviation, shape.deviation);
    put(proven, int32_t{shape.proven ? 1 : 0});
}

} // namespace

nurbs_status nurbs_warp(const nurbs *g, const double *range, const double *direction, double distance,
                        int32_t order, nurbs **out) {
    return guard([&] {
        require_out(out);
        const Part part = checked_part(spline_of(g), range);
        check_vector(direction, *g->spline, "direction");
        if (!std::isfinite(distance)) {
            fail(Status::length, "distance = %s is not finite", Number(distance).text);
        }
        check_order_in(order, 0, 7);
        give(modify::warp(g->spline, part, direction, distance, order), out);
    });
}

nurbs_status nurbs_flatten(const nurbs *g, const double *range, const double *point, const double *normal,
                           const double *direction, double *moved, nurbs **out) {
    return guard([&] {
        require_out(out);
        const Part part = checked_part(spline_of(g), range);
        check_place_in_space(point, *g->spline, "point");
        check_vector(normal, *g->spline, "normal");
        if (direction != nullptr) {
            check_vector(direction, *g->spline, "direction");
        }
        modify::Flattened made = modify::flatten(g->spline, part, point, normal, direction);
        give(std::move(made.spline), out);
        put(moved, made.moved);
    });
}

nurbs_status nurbs_bend(const nurbs *g, const double *origin, const double *along, const double *across,
                        double curvature, double lower, double upper, double tolerance, double *deviation,
                        int32_t *proven, nurbs **out) {
    return guard([&] {
        require_out(out);
        const Spline &spline = spline_of(g);
        if (spline.dim() < 2) {
            fail(Status::dimension, "dimension %d of g, expected at least 2", spline.dim());
        }
        check_place_in_space(origin, spline, "origin");
        check_vector(along, spline, "along");
        check_vector(across, spline, "across");
        check_factor(curvature, "curvature");
        if (!(lower < upper)) {
            fail(Status::empty_domain, "lower = %s, expected less than upper = %s", Number(lower).text,
                 Number(upper).text);
        }
        check_positive_tolerance(tolerance);
        const modify::Bend rule =
            modify::make_bend(spline.dim(), origin, along, across, curvature, lower, upper);
        give_deformed(modify::bend(g->spline, rule, tolerance), deviation, proven, out);
    });
}

nurbs_status nurbs_free_form_deform(const nurbs *g, const nurbs *volume, const double *lower,
                                    const double *upper, double tolerance, double *deviation, int32_t *proven,
                                    nurbs **out) {
    return guard([&] {
        require_out(out);
        const Spline &spline = spline_of(g);
        require(volume, "volume");
        const int axes = volume->spline->axes();
        if (volume->spline->dim() != axes || spline.dim() != axes) {
            fail(Status::dimension, "dimension %d of g and %d of volume, expected %d, its number of axes",
                 spline.dim(), volume->spline->dim(), axes);
        }
        check_place_in_space(lower, spline, "lower");
        check_place_in_space(upper, spline, "upper");
        for (int k = 0; k < axes; ++k) {
            if (!(lower[k] < upper[k]) || !std::isfinite(upper[k] - lower[k])) {
                fail(Status::empty_domain, "lower[%d] = %s, expected less than upper[%d] = %s", k,
                     Number(lower[k]).text, k, Number(upper[k]).text);
            }
        }
        check_positive_tolerance(tolerance);
        give_deformed(modify::free_form_deform(g->spline, volume->spline, lower, upper, tolerance), deviation,
                      proven, out);
    });
}

nurbs_status nurbs_fair(const nurbs *g, int32_t order, const int32_t *keep, double tolerance,
                        double *energies, double *bound, nurbs **out) {
    return guard([&] {
        require_out(out);
        const Spline &spline = spline_of(g);
        check_order_in(order, 1, 3);
        check_keep(spline, keep);
        check_tolerance(tolerance);
        check_apart({memory("energies", energies, 2), memory("bound", bound, 1)},
                    {memory("keep", keep, int64_t{2} * spline.axes())});
        modify::Faired made = modify::fair(g->spline, order, keep, tolerance);
        const std::array found{made.energy_before, made.energy_after};
        if (energies != nullptr) {
            require_representable(found, "energies");
        }
        give(std::move(made.spline), out);
        put_all(energies, found);
        put(bound, made.bound);
    });
}

nurbs_status nurbs_snap_boundary(const nurbs *g, int32_t axis, int32_t end, const nurbs *other,
                                 int32_t other_axis, int32_t other_end, int32_t order, uint32_t flags,
                                 double *bound, nurbs **out) {
    return guard([&] {
        require_out(out);
        check_axis(spline_of(g), axis);
        require(other, "other");
        check_axis(*other->spline, other_axis);
        const modify::Boundary boundary{axis, upper_end(end, "end")};
        const modify::Boundary other_boundary{other_axis, upper_end(other_end, "other_end")};
        check_order_in(order, 0, 1);
        const bool curve = g->spline->axes() == 1;
        if ((flags & ~(curve ? 0 : NURBS_REVERSED)) != 0) {
            fail(Status::flags, "flags = 0x%x, expected %s", flags,
                 curve ? "0 for a curve" : "NURBS_REVERSED or 0");
        }
        modify::SnappedBoundary made = modify::snap_boundary(
            g->spline, boundary, other->spline, other_boundary, order, (flags & NURBS_REVERSED) != 0);
        give(std::move(made.spline), out);
        put(bound, made.bound);
    });
}
