// SPDX-License-Identifier: MIT
#include "intersect/projection/curve_projection.h"

#include "base/watch.h"
#include "intersect/levels/fields/piece_field.h"
#include "intersect/projection/feet_curves.h"
#include "intersect/projection/projecting_lines.h"
#include "intersect/projection/sheets.h"
#include "intersect/surfaces/surface_surface.h"

#include <utility>

namespace nrb::intersect {

Meet projected_along(const SplinePtr &curve, const Spline &surface, const Vector3 &direction,
                     double tolerance) {
    const LimitedSearch limited;
    const ProjectingLines lines = projecting_lines(curve, surface, direction);
    Meet meet = surface_intersections(surface, *lines.surface, tolerance);
    for (MeetBranch &branch : meet.branches) {
        branch.deviation += lines.rounding;
    }
    return cut_in_sheets(std::move(meet), {*lines.surface, lines.direction, surface});
}

Meet projected_normally(const SplinePtr &curve, const Spline &surface, double tolerance) {
    const int factor = surface.form() == Form::polynomial ? 2 : 3;
    check_function_degree(surface, [&](int degree) { return factor * degree; });
    const LimitedSearch limited;
    const SplinePtr lines = distance_lines(curve, surface);
    return cut_in_sheets(feet_curves(curve, surface, *lines, tolerance), {*lines, {}, surface});
}

} // namespace nrb::intersect
