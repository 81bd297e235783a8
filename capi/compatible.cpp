// SPDX-License-Identifier: MIT
// Knots made equal: near-equal knots of one spline (snapping), and the knots of a set of splines.
#include "checks.h"
#include "guard.h"
#include "lists.h"
#include "outputs.h"

#include "reduce/compatible.h"
#include "reduce/snap.h"

using namespace nrb;
using namespace nrb::capi;

nurbs_status nurbs_snap_knots(const nurbs *g, int32_t axis, double tolerance, double *deviation,
                              nurbs **out) {
    return guard([&] {
        require_out(out);
        check_axis(spline_of(g), axis);
        reduce::Snapped snapped = reduce::snap_knots(g->spline, axis, tolerance);
        give(std::move(snapped.spline), out);
        put(deviation, snapped.deviation);
    });
}

nurbs_status nurbs_make_compatible(int64_t count, const nurbs *const *splines, double tolerance,
                                   uint32_t flags, double *deviation, nurbs_list **out) {
    return guard([&] {
        require_out(out);
        const std::vector<SplinePtr> given = splines_of(count, splines, "splines");
        if ((flags & ~NURBS_MAP_DOMAINS) != 0) {
            fail(Status::flags, "flags = 0x%x, expected NURBS_MAP_DOMAINS or 0", flags);
        }
        reduce::Compatible made = reduce::make_compatible(given, tolerance, flags != 0);
        give_list(std::move(made.splines), out);
        put(deviation, made.deviation);
    });
}
