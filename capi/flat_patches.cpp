// SPDX-License-Identifier: MIT
// Patches and volumes of degree 1 on each axis, from their corners.
#include "checks.h"
#include "guard.h"
#include "spline_data.h"

#include "build/surfaces/multilinear.h"

using namespace nrb;
using namespace nrb::capi;

nurbs_status nurbs_surface_plane(int32_t dim, const double *origin, const double *u, const double *v,
                                 nurbs **out) {
    return guard([&] {
        require_out(out);
        check_dimension(dim);
        if (dim < 2) {
            fail(Status::dimension, "dim = %d, expected at least 2", dim);
        }
        require(u, "u");
        require(v, "v");
        give(build::parallelogram(dim, origin, u, v), out);
    });
}

nurbs_status nurbs_surface_bilinear(int32_t dim, const double *corners, int64_t corner_stride,
                                    int64_t corner_component_stride, nurbs **out) {
    return guard([&] {
        require_out(out);
        check_dimension(dim);
        give(build::multilinear(2, input("corners", corners, 4, dim, corner_stride, corner_component_stride)),
             out);
    });
}

nurbs_status nurbs_volume_trilinear(int32_t dim, const double *corners, int64_t corner_stride,
                                    int64_t corner_component_stride, nurbs **out) {
    return guard([&] {
        require_out(out);
        check_dimension(dim);
        give(build::multilinear(3, input("corners", corners, 8, dim, corner_stride, corner_component_stride)),
             out);
    });
}
