#include "refine/elevate.h"

#include "refine/elevation_table.h"

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

AxisTable elevated(const KnotVector &axis, int64_t times) {
    ElevatedAxis step = elevated_axis(axis);
    AxisTable made{raised(axis, std::move(step.knots)), std::move(step.rows)};
    for (int64_t i = 1; i < times; ++i) {
        step = elevated_axis(*made.axis);
        made.axis = raised(*made.axis, std::move(step.knots));
        made.table = composed(step.rows, made.table, axis.distinct_layers());
    }
    if (axis.periodic()) {
        made.table = wrapped_rows(made.table, made.axis->degree(), axis.distinct_layers());
    }
    return made;
}

SplinePtr elevate(const SplinePtr &spline, int axis, int64_t times) {
    const KnotVector &old = spline->axis(axis);
    check_times(old.degree(), axis, times);
    return times == 0 ? spline : with_axis(*spline, axis, elevated(old, times));
}

} // namespace nrb
