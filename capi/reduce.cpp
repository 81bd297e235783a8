// SPDX-License-Identifier: MIT
// Knot removal, degree reduction and simplification, which move the shape by no more than a proven bound, and
// the deviation of two splines.
#include "checks.h"
#include "guard.h"
#include "outputs.h"

#include "bounds/deviation.h"
#include "reduce/reduce_degree.h"
#include "reduce/remove_knot.h"
#include "reduce/simplify.h"

using namespace nrb;
using namespace nrb::capi;

namespace {

void give_reduced(reduce::Reduced result, double *bound, nurbs **out) {
    give(std::move(result.spline), out);
    put(bound, result.bound);
}

} // namespace

nurbs_status nurbs_deviation(const nurbs *f, const nurbs *g, double *at_least, double *at_most) {
    return guard([&] {
        require(f, "f");
        require(g, "g");
        const pieces::Enclosure found = bounds::deviation(*f->spline, *g->spline);
        put(at_least, found.lower);
        put(at_most, found.upper);
    });
}

nurbs_status nurbs_remove_knot(const nurbs *g, int32_t axis, double knot, int32_t times, double tolerance,
                               int32_t *removed, double *bound, nurbs **out) {
    return guard([&] {
        require_out(out);
        check_axis(spline_of(g), axis);
        const reduce::KnotRemoval result = reduce::remove_knot(g->spline, axis, knot, times, tolerance);
        give(result.spline, out);
        put(removed, static_cast<int32_t>(result.removed));
        put(bound, result.bound);
    });
}

nurbs_status nurbs_reduce_knots(const nurbs *g, int32_t axis, double tolerance, double *bound, nurbs **out) {
    return guard([&] {
        require_out(out);
        require(g, "g");
        if (axis < -1 || axis >= g->spline->axes()) {
            fail(Status::axis, "axis = %d, expected -1 to %d", axis, g->spline->axes() - 1);
        }
        give_reduced(reduce::reduce_knots(g->spline, axis, tolerance), bound, out);
    });
}

nurbs_status nurbs_reduce_degree(const nurbs *g, int32_t axis, int32_t times, double *bound, nurbs **out) {
    return guard([&] {
        require_out(out);
        check_axis(spline_of(g), axis);
        give_reduced(reduce::reduce_degree(g->spline, axis, times), bound, out);
    });
}

nurbs_status nurbs_simplify(const nurbs *g, double tolerance, double *bound, nurbs **out) {
    return guard([&] {
        require_out(out);
        require(g, "g");
        give_reduced(reduce::simplify(g->spline, tolerance), bound, out);
    });
}
