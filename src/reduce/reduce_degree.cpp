// SPDX-License-Identifier: MIT
#include "reduce/reduce_degree.h"

#include "base/checked.h"
#include "base/finite.h"
#include "base/watch.h"
#include "numeric/solvers/banded_least_squares.h"
#include "reduce/layers.h"
#include "refine/degree/elevate.h"
#include "refine/forms/homogeneous.h"
#include "refine/parts/cut.h"
#include "refine/periodic/period.h"

#include <algorithm>
#include <cmath>

namespace nrb::reduce {

namespace {

void check_times(int degree, int axis, int64_t times) {
    if (times < 0) {
        fail(Status::times, "times = %lld, expected >= 0", static_cast<long long>(times));
    }
    if (times > degree) {
        fail(Status::degree, "degree %d of axis %d, lowered by times = %lld, would be less than 0", degree,
             axis, static_cast<long long>(times));
    }
}

int lowered(int multiplicity, int times) noexcept {
    return std::max(1, multiplicity - times);
}

// Precondition: both ends are clamped.
KnotVectorPtr lowered_open_axis(const KnotVector &axis, int times) {
    std::vector<double> knots;
    for (const auto &[knot, multiplicity] : distinct_knots(axis.knots())) {
        count_work(8);
        knots.insert(knots.end(), static_cast<size_t>(lowered(multiplicity, times)), knot);
    }
    return std::make_shared<const KnotVector>(axis.degree() - times, std::move(knots));
}

// The number of copies of the seam up to and including the one that starts the domain.
int64_t seam_copies_before(const KnotVector &axis) noexcept {
    const auto first = std::lower_bound(axis.knots().begin(), axis.knots().end(), axis.domain().lower);
    return axis.degree() + 1 - (first - axis.knots().begin());
}

// nurbs_elevate() puts new copies of the seam after the one that starts the domain; these are removed first.
KnotVectorPtr lowered_periodic_axis(const KnotVector &axis, int times) {
    const auto [lower, upper] = axis.domain();
    const auto q = static_cast<size_t>(axis.degree() - times);
    std::vector<double> knots(q);
    int64_t ahead = 0;
    for (const auto &[knot, multiplicity] : distinct_knots(axis.knots())) {
        count_work(8);
        if (knot < lower || knot >= upper) {
            continue;
        }
        int64_t copies = lowered(multiplicity, times);
        if (knot == lower) {
            const int64_t after = multiplicity - seam_copies_before(axis);
            const int64_t kept = std::clamp<int64_t>(after - times, 0, copies - 1);
            ahead = copies - 1 - kept;
            copies = kept + 1;
        }
        knots.insert(knots.end(), static_cast<size_t>(copies), knot);
    }
    knots.insert(knots.end(), static_cast<size_t>(ahead + 1), upper);
    const size_t last = knots.size() - 1;
    knots.resize(knots.size() + q);
    refine::continue_knots(knots, q, last, last - q);
    check_periodic_knots(axis.degree() - times, knots, -1, 0);
    return std::make_shared<const KnotVector>(axis.degree() - times, std::move(knots), true);
}

// The knots of `fine` in the half-open domain (in its interior, if not periodic) that `coarse` has with lower
// multiplicity.
std::vector<double> missing_knots(const KnotVector &fine, const KnotVector &coarse) {
    const auto [lower, upper] = fine.domain();
    std::vector<double> missing;
    const std::vector<KnotGroup> groups = distinct_knots(coarse.knots());
    auto group = groups.begin();
    for (const auto &[knot, copies] : distinct_knots(fine.knots())) {
        count_work(8);
        if (knot >= upper || knot < lower || (knot == lower && !fine.periodic())) {
            continue;
        }
        group = std::find_if(group, groups.end(), [k = knot](const KnotGroup &g) { return g.knot >= k; });
        const int there = group != groups.end() && group->knot == knot ? group->multiplicity : 0;
        missing.insert(missing.end(), static_cast<size_t>(std::max(copies - there, 0)), knot);
    }
    return missing;
}

// The refined records of a spline as those of a polynomial spline, layer by layer along the axis.
std::vector<double> refined_layers(const Spline &spline, int axis, const refine::AxisTable &made) {
    AxisView view = axis_view(spline, axis, spline.width());
    view.count = made.axis->count();
    if (!spline.rational()) {
        return by_layers(apply_along(spline, axis, made.table).points, view);
    }
    const Spline records(spline.knot_vectors(), spline.width(), Form::polynomial,
                         refine::homogeneous_points(spline), {});
    return by_layers(apply_along(records, axis, made.table).points, view);
}

// The least-squares system: each elevated layer (of one period) is a row over the unknown layers of lower
// degree.
class ReductionSystem {
public:
    // `fixed`: the first and the last unknown layer are known.
    ReductionSystem(const refine::AxisTable &raised, int64_t unknowns, int64_t length, bool fixed)
        : table_(raised.table), rows_(raised.axis->distinct_layers()), unknowns_(unknowns), length_(length),
          lead_(fixed ? 1 : 0), columns_(unknowns - 2 * lead_) {
        int widest = 1;
        for (int64_t r = 0; r < rows_; ++r) {
            widest = std::max(widest, table_.row(r).size);
        }
        border_ = raised.axis->periodic() ? std::min<int64_t>(columns_, widest) : 0;
        bandwidth_ = widest;
    }

    // Layer r of the right-hand side is targets[(r + shift) mod rows]; x already holds the fixed layers.
    bool solve(const std::vector<double> &targets, int64_t shift, double *x) {
        BandedLeastSquares system(columns_, bandwidth_, static_cast<int>(border_), length_);
        std::vector<double> right(static_cast<size_t>(length_));
        Steps steps(rows_);
        for (int64_t r = 0; r < rows_; ++r, steps.next()) {
            const int64_t target = ((r + shift) % rows_ + rows_) % rows_;
            std::copy_n(targets.data() + target * length_, length_, right.data());
            add(system, r, right, x);
        }
        return system.solve(x + lead_ * length_);
    }

private:
    void add(BandedLeastSquares &system, int64_t r, std::vector<double> &right, const double *x) {
        static constexpr double copied = 1;
        const LayerTable::Row &row = table_.row(r);
        const double *entries = row.size == 0 ? &copied : table_.coefficients(row);
        for (int i = 0; i < std::max(row.size, 1); ++i) {
            const int64_t layer = (row.first + i) % unknowns_, column = layer - lead_;
            if (column < 0 || column >= columns_) {
                const double *known = x + layer * length_;
                std::transform(right.begin(), right.end(), known, right.begin(),
                               [f = entries[i]](double a, double b) { return a - f * b; });
            } else {
                system.enter(column, entries[i]);
            }
        }
        system.add_entered(right.data());
    }

    const LayerTable &table_;
    int64_t rows_;
    int64_t unknowns_;
    int64_t length_;
    int64_t lead_;
    int64_t columns_;
    int64_t border_ = 0;
    int bandwidth_ = 1;
};

// The largest weight and the largest coordinate at one place of layers [first, end).
RecordRounding largest_around(const std::vector<double> &layers, int64_t length, int64_t at, int dim,
                              int64_t first, int64_t end) noexcept {
    RecordRounding largest{0, 0};
    for (int64_t layer = first; layer < end; ++layer) {
        const double *record = layers.data() + layer * length + at;
        largest.weight = std::max(largest.weight, std::abs(record[dim]));
        largest.coordinate =
            std::max(largest.coordinate, largest_magnitude({record, static_cast<size_t>(dim)}));
    }
    return largest;
}

// The state of the weights of new layers.
struct LayerWeights {
    bool infinite = false; // a point at infinity remains
    double negative = 0;   // the first weight that is not allowed; 0: none
};

// Sets to 0 the weights of Form::rational that are 0 up to the rounding of the solution, 32 (degree + 1) eps
// of the weights nearby.
LayerWeights clear_rounded_weights(const Spline &spline, int degree, int64_t length,
                                   std::vector<double> &layers) {
    const double rounding = rounding_of_zero * (degree + 1);
    const int64_t count = std::ssize(layers) / length;
    LayerWeights found;
    for (int64_t i = 0; spline.form() == Form::rational && i < count * length; i += spline.width()) {
        count_work(2 * int64_t{degree + 2} * spline.width());
        const int64_t layer = i / length;
        const RecordRounding around =
            largest_around(layers, length, i % length, spline.dim(), std::max<int64_t>(layer - degree - 1, 0),
                           std::min(layer + degree + 2, count));
        double *record = layers.data() + i;
        const double weight = record[spline.dim()];
        const Weight kind =
            clear_rounding(record, spline.dim(), {rounding * around.weight, rounding * around.coordinate});
        found.infinite = found.infinite || kind == Weight::infinite;
        if (kind == Weight::negative) {
            found.negative = weight;
            break;
        }
    }
    return found;
}

// The layers of lower degree that are closest to those of the source.
struct Lowered {
    SplinePtr source; // with clamped ends, unless it is periodic
    KnotVectorPtr knots;
    std::vector<double> layers; // of one period
    bool fixed;                 // the first and the last layer are those of the source
    LayerWeights weights;
};

Lowered lowered_layers(const SplinePtr &spline, int axis, int times) {
    const Phase phase;
    const bool periodic = spline->axis(axis).periodic();
    const SplinePtr source = periodic ? spline : refine::clamp_ends(spline, axis);
    const KnotVector &old = source->axis(axis);
    const KnotVectorPtr knots = periodic ? lowered_periodic_axis(old, times) : lowered_open_axis(old, times);
    const refine::AxisTable raised = refine::elevate_axis(*knots, times);
    const refine::AxisTable refined = refine::refine_axis(old, missing_knots(*raised.axis, old));
    const int64_t length = layer_length(*source, axis), count = knots->distinct_layers();
    const bool fixed = !periodic && knots->degree() > 0;
    std::vector<double> layers;
    grow_watched(layers, static_cast<size_t>(checked_product(count, length, "points")));
    const std::vector<double> targets = refined_layers(*source, axis, refined);
    if (fixed) {
        std::copy_n(targets.begin(), length, layers.begin());
        std::copy_n(targets.end() - length, length, layers.end() - length);
    }
    const int64_t shift = periodic ? seam_copies_before(*raised.axis) - seam_copies_before(*refined.axis) : 0;
    if (!ReductionSystem(raised, count, length, fixed).solve(targets, shift, layers.data())) {
        fail(Status::not_representable, "the knots of axis %d lie too close for its degree", axis);
    }
    const LayerWeights weights = clear_rounded_weights(*source, knots->degree(), length, layers);
    return {source, knots, std::move(layers), fixed, weights};
}

std::vector<LayerSource> layer_sources(const Lowered &lowered, int axis) {
    const int64_t length = layer_length(*lowered.source, axis), distinct = lowered.knots->distinct_layers();
    std::vector<LayerSource> sources;
    sources.reserve(static_cast<size_t>(lowered.knots->count()));
    for (int64_t i = 0; i < lowered.knots->count(); ++i) {
        count_work(2);
        sources.push_back({-1, lowered.layers.data() + i % distinct * length});
    }
    if (lowered.fixed) {
        sources.front().stored = 0;
        sources.back().stored = lowered.source->count(axis) - 1;
    }
    return sources;
}

// The source, in a form that admits points at infinity if there are any.
SplinePtr form_of_result(const Lowered &lowered) {
    return lowered.weights.infinite ? refine::in_form(lowered.source, Form::homogeneous) : lowered.source;
}

SplinePtr lower_degree(const SplinePtr &spline, int axis, int times) {
    const Lowered lowered = lowered_layers(spline, axis, times);
    if (lowered.weights.negative < 0) {
        fail(Status::weight_sign, "weight %s of the result, expected >= 0",
             Number(lowered.weights.negative).text);
    }
    return spline_of_layers(*form_of_result(lowered), axis, lowered.knots, layer_sources(lowered, axis));
}

} // namespace

SplinePtr lower_degree_if_valid(const SplinePtr &spline, int axis, int times) {
    const Lowered lowered = lowered_layers(spline, axis, times);
    return lowered.weights.negative < 0
               ? nullptr
               : spline_of_layers_if_valid(*form_of_result(lowered), axis, lowered.knots,
                                           layer_sources(lowered, axis));
}

Reduced reduce_degree(const SplinePtr &spline, int axis, int64_t times) {
    check_times(spline->axis(axis).degree(), axis, times);
    if (times == 0) {
        return {spline, 0};
    }
    const SplinePtr result = lower_degree(spline, axis, static_cast<int>(times));
    return {result, bounds::deviation(*spline, *result).upper};
}

} // namespace nrb::reduce
