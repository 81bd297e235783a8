// Degree and form.
#include "refine/elevate.h"

#include "checks.h"
#include "guard.h"

using namespace nrb;
using namespace nrb::capi;

nurbs_status nurbs_elevate(const nurbs *g, int32_t axis, int32_t times, nurbs **out) {
    return guard([&] {
        require_out(out);
        check_axis(spline_of(g), axis);
        give(elevate(g->spline, axis, times), out);
    });
}
