// Refinement.
#include "refine/insert.h"

#include "checks.h"
#include "guard.h"

using namespace nrb;
using namespace nrb::capi;

nurbs_status nurbs_insert_knot(const nurbs *g, int32_t axis, double knot, int32_t times, nurbs **out) {
    return guard([&] {
        require_out(out);
        check_axis(spline_of(g), axis);
        give(insert_knot(g->spline, axis, knot, times), out);
    });
}
