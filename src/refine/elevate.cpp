#include "refine/elevate.h"

#include "refine/elevation_table.h"
#include "spline/layer_table.h"

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

SplinePtr elevate(const SplinePtr &spline, int axis, int64_t times) {
    const KnotVector &old = spline->axis(axis);
    check_times(old.degree(), axis, times);
    if (times == 0) {
        return spline;
    }
    ElevatedAxis step = elevated_axis(old);
    KnotVectorPtr knots = raised(old, std::move(step.knots));
    LayerTable table = std::move(step.rows);
    for (int64_t i = 1; i < times; ++i) {
        step = elevated_axis(*knots);
        knots = raised(*knots, std::move(step.knots));
        table = composed(step.rows, table, old.distinct_layers());
    }
    if (old.periodic()) {
        table = wrapped_rows(table, knots->degree(), old.distinct_layers());
    }
    Net net = apply_along(*spline, axis, table);
    Spline::Axes axes = spline->knot_vectors();
    axes[static_cast<size_t>(axis)] = std::move(knots);
    return make_spline(std::move(axes), spline->dim(), spline->form(), std::move(net.points),
                       std::move(net.weights));
}

} // namespace nrb
