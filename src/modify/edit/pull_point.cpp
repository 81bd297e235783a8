// SPDX-License-Identifier: MIT
#include "modify/edit/pull_point.h"

#include "modify/edit/influence.h"
#include "modify/edit/net_editor.h"
#include "numeric/direction.h"

#include <cmath>

namespace nrb::modify {

PointEdit pull_point(const Spline &spline, int64_t original, const double *param, const double *direction,
                     double distance) {
    const Contribution sums = contribution_of(spline, {&original, 1}, param);
    const double moved = distance / sums.influence();
    NetEditor editor(spline);
    editor.move(original, unit_vector(direction, spline.dim()).data(), moved);
    return {moved, editor.finish()};
}

} // namespace nrb::modify
