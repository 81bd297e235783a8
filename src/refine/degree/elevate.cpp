// SPDX-License-Identifier: MIT
#include "refine/degree/elevate.h"

#include "base/limits.h"
#include "refine/degree/elevation_table.h"
#include "refine/periodic/period_rows.h"

namespace nrb::refine {

namespace {

void check_times(int degree, int axis, int64_t times) {
    if (times < 0) {
        fail(Status::times, "times = %lld, expected >= 0", static_cast<long long>(times));
    }
    if (times > max_degree - degree) {
        fail(Status::degree, "degree %d of axis %d, raised by times = %lld, would exceed the limit of %d",
             degree, axis, static_cast<long long>(times), max_degree);
    }
}

KnotVectorPtr raised(const KnotVector &axis, std::vector<double> knots) {
    return std::make_shared<const KnotVector>(axis.degree() + 1, std::move(knots), axis.periodic());
}

} // namespace

AxisTable elevate_axis(const KnotVector &axis, int64_t times) {
    const Elevation first(axis);
    KnotVectorPtr knots = raised(axis, first.knots());
    LayerTable table = first.rows(0, first.rows());
    for (int64_t i = 1; i < times; ++i) {
        const KnotVectorPtr below = std::move(knots);
        const Elevation next(*below);
        knots = raised(*below, next.knots());
        table = composed(next.rows(0, next.rows()), table, axis.distinct_layers());
    }
    if (axis.periodic()) {
        table = wrapped_rows(table, 0, knots->degree(), axis.distinct_layers());
    }
    return {std::move(knots), std::move(table)};
}

SplinePtr elevate(const SplinePtr &spline, int axis, int64_t times) {
    const KnotVector &old = spline->axis(axis);
    check_times(old.degree(), axis, times);
    if (times == 0) {
        return spline;
    }
    if (times > 1 || old.periodic()) {
        return with_axis(*spline, axis, elevate_axis(old, times));
    }
    const Elevation elevation(old);
    return with_axis(*spline, axis, raised(old, elevation.knots()), 1,
                     [&](int64_t first, int64_t end) { return elevation.rows(first, end); });
}

} // namespace nrb::refine
