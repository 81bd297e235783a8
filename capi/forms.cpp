// SPDX-License-Identifier: MIT
// Degree elevation, and changes of form: reversed or permuted axes, other domains, weights, homogeneous
// points.
#include "refine/degree/elevate.h"
#include "refine/forms/homogeneous.h"
#include "refine/forms/parametrization.h"
#include "refine/forms/transpose.h"

#include "checks.h"
#include "guard.h"

using namespace nrb;
using namespace nrb::capi;

namespace {

void check_reverse_flags(uint32_t flags) {
    if ((flags & ~NURBS_KEEP_DOMAIN) != 0) {
        fail(Status::flags, "flags = 0x%08x, expected 0 or NURBS_KEEP_DOMAIN", flags);
    }
}

} // namespace

nurbs_status nurbs_elevate(const nurbs *g, int32_t axis, int32_t times, nurbs **out) {
    return guard([&] {
        require_out(out);
        check_axis(spline_of(g), axis);
        give(refine::elevate(g->spline, axis, times), out);
    });
}

nurbs_status nurbs_reverse(const nurbs *g, int32_t axis, uint32_t flags, nurbs **out) {
    return guard([&] {
        require_out(out);
        check_axis(spline_of(g), axis);
        check_reverse_flags(flags);
        give(refine::reverse(*g->spline, axis, flags != 0), out);
    });
}

nurbs_status nurbs_transpose(const nurbs *g, const int32_t *permutation, nurbs **out) {
    return guard([&] {
        require_out(out);
        const Spline &spline = spline_of(g);
        require(permutation, "permutation");
        give(refine::transpose(spline, permutation), out);
    });
}

nurbs_status nurbs_reparametrize(const nurbs *g, int32_t axis, double lower, double upper, nurbs **out) {
    return guard([&] {
        require_out(out);
        check_axis(spline_of(g), axis);
        give(refine::reparametrize(g->spline, axis, {lower, upper}), out);
    });
}

nurbs_status nurbs_make_rational(const nurbs *g, nurbs **out) {
    return guard([&] {
        require_out(out);
        require(g, "g");
        give(refine::make_rational(g->spline), out);
    });
}

nurbs_status nurbs_to_homogeneous(const nurbs *g, nurbs **out) {
    return guard([&] {
        require_out(out);
        give(refine::to_homogeneous(spline_of(g)), out);
    });
}

nurbs_status nurbs_from_homogeneous(const nurbs *g, nurbs **out) {
    return guard([&] {
        require_out(out);
        give(refine::from_homogeneous(spline_of(g)), out);
    });
}
