#include "refine/elevate.h"

#include "refine/elevation_table.h"
#include "refine/period_rows.h"

namespace nrb {

namespace {

void check_times(int degree, int axis, int64_t times) {
    if (times < 0) {
        fail(NURBS_ERROR_TIMES, "times = %lld, expected >= 0", static_cast<long long>(times));
    }
    if (times > NURBS_MAX_DEGREE - degree) {
        fail(NURBS_ERROR_DEGREE, "degree %d of axis %d, raised by times = %lld, would exceed the limit of %d",
             degree, axis, static_cast<long long>(times), NURBS_MAX_DEGREE);
    }
}

KnotVectorPtr raised(const KnotVector &axis, std::vector<double> knots) {
    return std::make_shared<const KnotVector>(axis.degree() + 1, std::move(knots), axis.periodic());
}

} // namespace

AxisTable elevate_axis(const KnotVector &axis, int64_t times) {
    ElevatedAxis step = elevated_axis(axis);
    KnotVectorPtr knots = raised(axis, std::move(step.knots));
    LayerTable table = std::move(step.rows);
    for (int64_t i = 1; i < times; ++i) {
        step = elevated_axis(*knots);
        knots = raised(*knots, std::move(step.knots));
        table = composed(step.rows, table, axis.distinct_layers());
    }
    if (axis.periodic()) {
        table = wrapped_rows(table, 0, knots->degree(), axis.distinct_layers());
    }
    return {std::move(knots), std::move(table)};
}

SplinePtr elevate(const SplinePtr &spline, int axis, int64_t times) {
    check_times(spline->axis(axis).degree(), axis, times);
    return times == 0 ? spline : with_axis(*spline, axis, elevate_axis(spline->axis(axis), times));
}

} // namespace nrb
