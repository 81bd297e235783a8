// SPDX-License-Identifier: MIT
// Splines continued beyond their ends: extension, unclamping, and periodic form.
#include "checks.h"
#include "guard.h"
#include "outputs.h"

#include "reduce/periodic_form.h"
#include "refine/forms/homogeneous.h"
#include "refine/parts/continuation.h"

using namespace nrb;
using namespace nrb::capi;

nurbs_status nurbs_extend(const nurbs *g, int32_t axis, int32_t end, double amount, int32_t order,
                          nurbs **out) {
    return guard([&] {
        require_out(out);
        check_axis(spline_of(g), axis);
        const bool upper = upper_end(end, "end");
        check_order(order);
        give(refine::extend(g->spline, axis, upper, amount, order), out);
    });
}

nurbs_status nurbs_unclamp(const nurbs *g, int32_t axis, uint32_t flags, nurbs **out) {
    return guard([&] {
        require_out(out);
        check_axis(spline_of(g), axis);
        const refine::AxisEnds ends = decode_ends(flags, NURBS_HOMOGENEOUS, "NURBS_HOMOGENEOUS");
        const bool homogeneous = (flags & NURBS_HOMOGENEOUS) != 0 && g->spline->rational();
        give(refine::unclamp(homogeneous ? refine::in_form(g->spline, Form::homogeneous) : g->spline, axis,
                             ends),
             out);
    });
}

nurbs_status nurbs_make_periodic(const nurbs *g, int32_t axis, double tolerance, double *deviation,
                                 int32_t *order, nurbs **out) {
    return guard([&] {
        require_out(out);
        check_axis(spline_of(g), axis);
        reduce::PeriodicForm form = reduce::make_periodic(g->spline, axis, tolerance);
        give(std::move(form.spline), out);
        put(deviation, form.deviation);
        put(order, int32_t{form.order});
    });
}

nurbs_status nurbs_detect_periodic(const nurbs *g, int32_t axis, int32_t *periodic) {
    return guard([&] {
        require(periodic, "periodic");
        check_axis(spline_of(g), axis);
        *periodic = reduce::wraps(*g->spline, axis) ? 1 : 0;
    });
}
