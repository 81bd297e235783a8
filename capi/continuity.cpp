// SPDX-License-Identifier: MIT
// Continuity at knots, and between the ends of two curves.
#include "checks.h"
#include "guard.h"
#include "outputs.h"

#include "analysis/continuity.h"
#include "base/tolerance.h"

#include <utility>

using namespace nrb;
using namespace nrb::capi;

namespace {

analysis::ContinuityRule checked_rule(double position, double derivative, double angle) {
    const struct {
        const char *name;
        double value;
    } all[] = {
        {"position_tolerance", position}, {"derivative_tolerance", derivative}, {"angle_tolerance", angle}};
    for (const auto &[name, value] : all) {
        check_tolerance(value, name);
    }
    return {position, derivative, angle};
}

} // namespace

nurbs_status nurbs_continuity(const nurbs *g, int32_t axis, double position_tolerance,
                              double derivative_tolerance, double angle_tolerance, int64_t cap, double *knots,
                              int32_t *knot_orders, int32_t *orders, int32_t *geometric_orders,
                              double *position_gaps, double *angles, double *curvature_gaps, int64_t *count) {
    return guard([&] {
        check_axis(spline_of(g), axis);
        const analysis::ContinuityRule rule =
            checked_rule(position_tolerance, derivative_tolerance, angle_tolerance);
        check_length(cap, "cap");
        const std::vector<analysis::KnotContinuity> rows = analysis::continuity(g->spline, axis, rule);
        const int64_t filled = checked_cap(cap, std::ssize(rows));
        check_apart({memory("knots", knots, filled), memory("knot_orders", knot_orders, filled),
                     memory("orders", orders, filled), memory("geometric_orders", geometric_orders, filled),
                     memory("position_gaps", position_gaps, filled), memory("angles", angles, filled),
                     memory("curvature_gaps", curvature_gaps, filled), memory("count", count, 1)},
                    {});
        for (size_t i = 0; std::cmp_less(i, filled); ++i) {
            put(knots, i, rows[i].knot);
            put(knot_orders, i, int32_t{rows[i].knot_order});
            put(orders, i, int32_t{rows[i].found.order});
            put(geometric_orders, i, int32_t{rows[i].found.geometric});
            put(position_gaps, i, rows[i].found.position_gap);
            put(angles, i, rows[i].found.angle);
            put(curvature_gaps, i, rows[i].found.curvature_gap);
        }
        put(count, int64_t{std::ssize(rows)});
    });
}

nurbs_status nurbs_continuity_between(const nurbs *a, int32_t end_a, const nurbs *b, int32_t end_b,
                                      double position_tolerance, double derivative_tolerance,
                                      double angle_tolerance, int32_t *order, int32_t *geometric,
                                      double *position_gap, double *angle, double *curvature_gap) {
    return guard([&] {
        require(a, "a");
        require(b, "b");
        const bool upper_a = upper_end(end_a, "end_a"), upper_b = upper_end(end_b, "end_b");
        const analysis::ContinuityRule rule =
            checked_rule(position_tolerance, derivative_tolerance, angle_tolerance);
        const analysis::Continuity found =
            analysis::continuity_between(*a->spline, upper_a, *b->spline, upper_b, rule);
        put(order, int32_t{found.order});
        put(geometric, int32_t{found.geometric});
        put(position_gap, found.position_gap);
        put(angle, found.angle);
        put(curvature_gap, found.curvature_gap);
    });
}
