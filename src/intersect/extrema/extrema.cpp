// SPDX-License-Identifier: MIT
#include "intersect/extrema/extrema.h"

#include "base/watch.h"
#include "intersect/extrema/curve_extrema.h"
#include "intersect/extrema/fields/field_extrema.h"

namespace nrb::intersect {

namespace {

constexpr int64_t work_of_a_point = 20000; // times axes^2, for the strata of its pieces

} // namespace

Extrema extrema_of(const SplinePtr &spline) {
    const int64_t axes = spline->axes();
    const UsualLimit usual(usual_work(spline->point_count(), work_of_a_point * axes * axes));
    const LimitedSearch limited;
    return spline->axes() == 1 ? curve_extrema(spline) : field_extrema(*spline);
}

} // namespace nrb::intersect
