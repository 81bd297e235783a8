// SPDX-License-Identifier: MIT
// Surfaces and volumes from curves and surfaces: extrusion, revolution, ruling, tensor sums and products,
// swung surfaces.
#include "checks.h"
#include "guard.h"

#include "build/surfaces/revolve.h"
#include "build/surfaces/ruled_extruded.h"
#include "build/surfaces/tensor.h"

using namespace nrb;
using namespace nrb::capi;

nurbs_status nurbs_extrude(const nurbs *g, const double *vector, nurbs **out) {
    return guard([&] {
        require_out(out);
        require(g, "g");
        require(vector, "vector");
        give(build::extrude(g->spline, vector), out);
    });
}

nurbs_status nurbs_revolve(const nurbs *g, const double *point, const double *axis, double sweep,
                           int32_t form, nurbs **out) {
    return guard([&] {
        require_out(out);
        give(build::revolve(spline_of(g), point, axis, sweep, form), out);
    });
}

nurbs_status nurbs_ruled(const nurbs *a, const nurbs *b, uint32_t flags, nurbs **out) {
    return guard([&] {
        require_out(out);
        require(a, "a");
        require(b, "b");
        if ((flags & ~NURBS_RULED_CARTESIAN) != 0) {
            fail(Status::flags, "flags = 0x%x, expected NURBS_RULED_CARTESIAN or 0", flags);
        }
        give(build::ruled(a->spline, b->spline, flags != 0), out);
    });
}

nurbs_status nurbs_tensor_sum(const nurbs *a, double alpha, const nurbs *b, double beta, nurbs **out) {
    return guard([&] {
        require_out(out);
        require(a, "a");
        require(b, "b");
        check_factor(alpha, "alpha");
        check_factor(beta, "beta");
        give(build::tensor_sum(*a->spline, alpha, *b->spline, beta), out);
    });
}

nurbs_status nurbs_tensor_product(const nurbs *a, const nurbs *b, nurbs **out) {
    return guard([&] {
        require_out(out);
        require(a, "a");
        require(b, "b");
        give(build::tensor_product(*a->spline, *b->spline), out);
    });
}

nurbs_status nurbs_surface_swung(const nurbs *trajectory, const nurbs *profile, double scale, nurbs **out) {
    return guard([&] {
        require_out(out);
        require(trajectory, "trajectory");
        require(profile, "profile");
        give(build::swung(*trajectory->spline, *profile->spline, scale), out);
    });
}
