#include "refine/insert.h"

#include "refine/boehm.h"
#include "refine/periodic.h"

#include <algorithm>
#include <cmath>

namespace nrb {

namespace {

void check_insertion(const KnotVector &axis, int k, double knot, int64_t times) {
    if (!std::isfinite(knot)) {
        fail(NURBS_ERROR_PARAMETER_NOT_FINITE, "knot = %s is not finite", Number(knot).text);
    }
    const auto [lower, upper] = axis.domain();
    if (knot < lower || knot > upper) {
        fail(NURBS_ERROR_OUTSIDE_DOMAIN, "knot = %s outside [%s, %s], the domain of axis %d",
             Number(knot).text, Number(lower).text, Number(upper).text, k);
    }
    if (times < 0) {
        fail(NURBS_ERROR_TIMES, "times = %lld, expected >= 0", static_cast<long long>(times));
    }
}

void check_multiplicity(const KnotVector &axis, int k, double knot, int64_t times) {
    const int present = multiplicity(axis.knots(), knot);
    if (times > axis.degree() + 1 - present) {
        fail(NURBS_ERROR_MULTIPLICITY,
             "knot = %s occurs %d times on axis %d; times = %lld would exceed the limit of degree + 1 = %d",
             Number(knot).text, present, k, static_cast<long long>(times), axis.degree() + 1);
    }
}

Spline::Axes with_axis(const Spline &spline, int k, KnotVectorPtr axis) {
    Spline::Axes axes = spline.knot_vectors();
    axes[static_cast<size_t>(k)] = std::move(axis);
    return axes;
}

SplinePtr insert_plain(const Spline &spline, int k, double knot, int times) {
    const KnotVector &axis = spline.axis(k);
    LayerTable table;
    std::vector<double> knots = insert_into_knots(axis.knots(), knot, times);
    append_insertion_rows(axis.degree(), axis.knots(), knot, times, table);
    auto refined = std::make_shared<const KnotVector>(axis.degree(), std::move(knots), axis.periodic());
    Net net = apply_along(spline, k, table);
    return make_spline(with_axis(spline, k, std::move(refined)), spline.dim(), spline.form(),
                       std::move(net.points), std::move(net.weights));
}

// The same spline with an axis that is no longer declared periodic, which allows to cut it.
SplinePtr open_axis(const SplinePtr &spline, int k) {
    const KnotVector &axis = spline->axis(k);
    if (!axis.periodic()) {
        return spline;
    }
    const std::span<const double> knots = axis.knots();
    auto open =
        std::make_shared<const KnotVector>(axis.degree(), std::vector<double>(knots.begin(), knots.end()));
    return std::make_shared<const Spline>(
        with_axis(*spline, k, std::move(open)), spline->dim(), spline->form(),
        std::vector<double>(spline->points().begin(), spline->points().end()),
        std::vector<double>(spline->weights().begin(), spline->weights().end()));
}

// Raises the multiplicity of a knot to the degree, where the curve meets its control point.
SplinePtr saturate(const SplinePtr &spline, int k, double knot) {
    const KnotVector &axis = spline->axis(k);
    return insert_knot(spline, k, knot, std::max(0, axis.degree() - multiplicity(axis.knots(), knot)));
}

// Layers [first, end) of an axis over the given knots.
SplinePtr slice(const Spline &spline, int k, int64_t first, int64_t end, std::vector<double> knots) {
    LayerTable table;
    table.reserve(end - first);
    for (int64_t layer = first; layer < end; ++layer) {
        table.add_copy(layer);
    }
    Net net = apply_along(spline, k, table);
    return make_spline(with_axis(spline, k, make_knot_vector(spline.axis(k).degree(), std::move(knots))),
                       spline.dim(), spline.form(), std::move(net.points), std::move(net.weights));
}

} // namespace

SplinePtr insert_knot(const SplinePtr &spline, int axis, double knot, int64_t times) {
    const KnotVector &knots = spline->axis(axis);
    check_insertion(knots, axis, knot, times);
    if (knots.periodic() && knot == knots.domain().upper) {
        knot = knots.domain().lower;
    }
    check_multiplicity(knots, axis, knot, times);
    if (times == 0) {
        return spline;
    }
    return knots.periodic() ? insert_periodic(*spline, axis, knot, static_cast<int>(times))
                            : insert_plain(*spline, axis, knot, static_cast<int>(times));
}

SplinePtr restrict_axis(const SplinePtr &spline, int axis, double lower, double upper) {
    const Interval domain = spline->axis(axis).domain();
    if (lower == domain.lower && upper == domain.upper) {
        return spline;
    }
    const SplinePtr cut = saturate(saturate(open_axis(spline, axis), axis, lower), axis, upper);
    const std::span<const double> knots = cut->axis(axis).knots();
    const int p = cut->axis(axis).degree();
    std::vector<double> kept;
    int64_t first = 0;
    int64_t end = cut->axis(axis).count();
    auto from = knots.begin();
    auto to = knots.end();
    if (lower != domain.lower) {
        const auto last_copy = std::upper_bound(knots.begin(), knots.end(), lower) - 1;
        first = last_copy - knots.begin() - p;
        from = last_copy - p + 1;
        kept.push_back(lower);
    }
    if (upper != domain.upper) {
        const auto first_copy = std::lower_bound(knots.begin(), knots.end(), upper);
        end = first_copy - knots.begin();
        to = first_copy + p;
    }
    kept.insert(kept.end(), from, to);
    if (upper != domain.upper) {
        kept.push_back(upper);
    }
    return slice(*cut, axis, first, end, std::move(kept));
}

} // namespace nrb
