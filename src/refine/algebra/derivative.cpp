// SPDX-License-Identifier: MIT
#include "refine/algebra/derivative.h"

#include "base/checked.h"
#include "base/representable.h"
#include "refine/knots/axis_table.h"
#include "refine/periodic/period.h"
#include "spline/axis_view.h"

#include <algorithm>

namespace nrb::refine {

namespace {

// The axis of the derivative. Layer i of the derivative is the degree times the difference of stored layers
// `below` + 1 and `below`, divided by `length`.
struct DerivedAxis {
    struct Layer {
        int64_t below;
        double length;
    };
    KnotVectorPtr axis;
    std::vector<Layer> layers;
};

// The derivative's layers and knots over a run of old knots. Derivative layer i belongs to knots i + 1, ...,
// i + p + 1 of the run; if its support is empty, it is omitted together with its last knot.
struct Run {
    std::vector<double> knots;
    std::vector<DerivedAxis::Layer> layers;
};

Run derived_run(int degree, std::span<const double> old) {
    const auto p = static_cast<size_t>(degree);
    Run run;
    run.knots.reserve(old.size());
    run.layers.reserve(old.size());
    run.knots.assign(old.begin() + 1, old.begin() + degree + 1);
    for (size_t i = 0; i + p + 2 < old.size(); ++i) {
        const double length = old[i + p + 1] - old[i + 1];
        if (length > 0) {
            run.layers.push_back({static_cast<int64_t>(i), length});
            run.knots.push_back(old[i + p + 1]);
        }
    }
    return run;
}

DerivedAxis derived_open(const KnotVector &axis) {
    Run run = derived_run(axis.degree(), axis.knots());
    return {std::make_shared<const KnotVector>(axis.degree() - 1, std::move(run.knots)),
            std::move(run.layers)};
}

// The index of the first copy of a knot, and its multiplicity.
struct KnotCopies {
    int64_t first;
    int64_t count;
};

KnotCopies copies_of(std::span<const double> knots, double knot) noexcept {
    const auto [first, last] = std::equal_range(knots.begin(), knots.end(), knot);
    return {first - knots.begin(), last - first};
}

// The period begins at the same copy of its first knot as before, or at the last copy if fewer remain.
DerivedAxis derived_periodic(const KnotVector &axis) {
    const int p = axis.degree();
    const int64_t lead = int64_t{p} + 1;
    const std::vector<double> old = extended_knots(axis, lead);
    Run run = derived_run(p, old);
    const auto [lower, upper] = axis.domain();
    const KnotCopies before = copies_of(axis.knots(), lower), start = copies_of(run.knots, lower),
                     end = copies_of(run.knots, upper);
    const int64_t copy = std::min(p - before.first, start.count - 1);
    const int64_t distinct = end.first - start.first;
    if (start.count != end.count) {
        fail(Status::periodic_knots,
             "knots: the ends of the periodic domain [%s, %s] occur %lld and %lld times", Number(lower).text,
             Number(upper).text, static_cast<long long>(start.count), static_cast<long long>(end.count));
    }
    const int64_t first = start.first + copy - (p - 1);
    const auto from = run.knots.begin() + first;
    DerivedAxis result{
        make_knot_vector(p - 1, std::vector<double>(from, from + distinct + 2 * int64_t{p} - 1), true), {}};
    for (int64_t i = 0; i < distinct + p - 1; ++i) {
        DerivedAxis::Layer layer = run.layers[static_cast<size_t>(first + i % distinct)];
        const int64_t stored = (layer.below - lead) % axis.distinct_layers();
        layer.below = stored < 0 ? stored + axis.distinct_layers() : stored;
        result.layers.push_back(layer);
    }
    return result;
}

SplinePtr derived(const SplinePtr &spline, int axis) {
    const KnotVector &old = spline->axis(axis);
    DerivedAxis made = old.periodic() ? derived_periodic(old) : derived_open(old);
    const AxisView view = axis_view(*spline, axis, spline->dim());
    std::vector<double> points;
    points.reserve(static_cast<size_t>(view.outer * view.inner) * made.layers.size());
    for (int64_t o = 0; o < view.outer; ++o) {
        for (const auto &[below, length] : made.layers) {
            const double *low = spline->points().data() + (o * view.count + below) * view.inner;
            for (int64_t i = 0; i < view.inner; ++i) {
                points.push_back(old.degree() * ((low[view.inner + i] - low[i]) / length));
            }
        }
    }
    require_representable(points, "control points of the derivative");
    return make_result(with_axis(*spline, axis, std::move(made.axis)), spline->dim(), Form::polynomial,
                       std::move(points));
}

// The zero spline: degree 0 on this axis, over the breaks of the domain.
SplinePtr zeros(const Spline &spline, int axis) {
    const KnotVector &old = spline.axis(axis);
    std::vector<double> breaks(old.spans().breaks().begin(), old.spans().breaks().end());
    Spline::Axes axes =
        with_axis(spline, axis, std::make_shared<const KnotVector>(0, std::move(breaks), old.periodic()));
    int64_t size = spline.dim();
    for (const KnotVectorPtr &knots : axes) {
        size = checked_product(size, knots->count(), "points");
    }
    return make_result(std::move(axes), spline.dim(), Form::polynomial,
                       std::vector<double>(static_cast<size_t>(size)));
}

} // namespace

SplinePtr polynomial_derivative(const SplinePtr &spline, int axis, int order) {
    if (order > spline->axis(axis).degree()) {
        return zeros(*spline, axis);
    }
    SplinePtr result = spline;
    for (int k = 0; k < order; ++k) {
        result = derived(result, axis);
    }
    return result;
}

} // namespace nrb::refine
