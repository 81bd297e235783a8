// SPDX-License-Identifier: MIT
// Changes of the weights that keep the shape: normalization and rational linear reparametrization.
#include "refine/forms/weights.h"

#include "checks.h"
#include "guard.h"

using namespace nrb;
using namespace nrb::capi;

nurbs_status nurbs_normalize_weights(const nurbs *g, nurbs **out) {
    return guard([&] {
        require_out(out);
        require(g, "g");
        give(refine::normalize_weights(g->spline), out);
    });
}

nurbs_status nurbs_reparametrize_moebius(const nurbs *g, int32_t axis, double ratio, nurbs **out) {
    return guard([&] {
        require_out(out);
        check_axis(spline_of(g), axis);
        give(refine::reparametrize_moebius(g->spline, axis, ratio), out);
    });
}

nurbs_status nurbs_equalize_end_weights(const nurbs *g, int32_t axis, nurbs **out) {
    return guard([&] {
        require_out(out);
        check_axis(spline_of(g), axis);
        give(refine::equalize_end_weights(g->spline, axis), out);
    });
}
