// SPDX-License-Identifier: MIT
// Reflections, and parallel and central projections, in and to a plane.
#include "checks.h"
#include "guard.h"

#include "refine/forms/projections.h"

#include <cmath>

using namespace nrb;
using namespace nrb::capi;

namespace {

void check_vector(const double *x, int dim, const char *name, Status status) {
    require(x, name);
    for (int c = 0; c < dim; ++c) {
        if (!std::isfinite(x[c])) {
            fail(status, "%s[%d] = %s is not finite", name, c, Number(x[c]).text);
        }
    }
}

void check_plane(const Spline &spline, const double *point, const double *normal) {
    check_vector(point, spline.dim(), "point", Status::point_not_finite);
    check_vector(normal, spline.dim(), "normal", Status::direction);
}

} // namespace

nurbs_status nurbs_mirror(const nurbs *g, const double *point, const double *normal, nurbs **out) {
    return guard([&] {
        require_out(out);
        const Spline &spline = spline_of(g);
        check_plane(spline, point, normal);
        give(refine::mirror(spline, point, normal), out);
    });
}

nurbs_status nurbs_project_to_plane(const nurbs *g, const double *point, const double *normal,
                                    const double *direction, nurbs **out) {
    return guard([&] {
        require_out(out);
        const Spline &spline = spline_of(g);
        check_plane(spline, point, normal);
        if (direction != nullptr) {
            check_vector(direction, spline.dim(), "direction", Status::direction);
        }
        give(refine::project_to_plane(spline, point, normal, direction), out);
    });
}

nurbs_status nurbs_project_from(const nurbs *g, const double *eye, const double *point, const double *normal,
                                nurbs **out) {
    return guard([&] {
        require_out(out);
        const Spline &spline = spline_of(g);
        check_vector(eye, spline.dim(), "eye", Status::point_not_finite);
        check_plane(spline, point, normal);
        give(refine::project_from(spline, eye, point, normal), out);
    });
}
