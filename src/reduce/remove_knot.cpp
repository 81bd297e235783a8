// SPDX-License-Identifier: MIT
#include "reduce/remove_knot.h"

#include "base/tolerance.h"
#include "reduce/layers.h"
#include "reduce/removal_step.h"
#include "refine/knots/insert.h"
#include "refine/periodic/period.h"
#include "spline/axis_view.h"

#include <algorithm>
#include <cmath>

namespace nrb::reduce {

namespace {

// The new layers as rows over the window of old layers.
struct WindowRows {
    int size;  // of a row
    int count; // number of rows
    double entries[max_basis][max_basis + 2];
};

// Applies the removal to unit vectors, which gives the rows.
WindowRows window_rows(const double *last, int degree, int multiplicity) noexcept {
    if (multiplicity > degree) { // the layers on both sides of the jump are replaced by their mean
        return {2, 1, {{0.5, 0.5}}};
    }
    const RemovalStep step = removal_step(last, degree, multiplicity);
    WindowRows units{step.rows + 2, step.rows - 1, {}};
    double layers[max_basis + 2][max_basis + 2] = {};
    double *window[max_basis + 2];
    double gap[max_basis + 2];
    for (int i = 0; i < units.size; ++i) {
        layers[i][i] = 1;
        window[i] = layers[i];
    }
    removal_gap(step, window, units.size, gap);
    remove_layer(step, window, units.size, gap);
    for (int row = 0; row < units.count; ++row) {
        std::copy_n(layers[row < step.skipped ? row + 1 : row + 2], units.size, units.entries[row]);
    }
    return units;
}

// Index of the last copy of a knot.
int64_t last_copy(const KnotVector &axis, double knot) noexcept {
    return std::upper_bound(axis.knots().begin(), axis.knots().end(), knot) - axis.knots().begin() - 1;
}

refine::AxisTable without_open_knot(const KnotVector &axis, double knot) {
    const int64_t last = last_copy(axis, knot);
    const WindowRows rows =
        window_rows(axis.knots().data() + last, axis.degree(), multiplicity(axis.knots(), knot));
    const int64_t first = last - axis.degree() - 1; // first layer of the window
    refine::AxisTable made;
    made.table.reserve(axis.count() - 1);
    const int64_t kept_before = rows.size == 2 && rows.count == 1 ? first : first + 1;
    for (int64_t i = 0; i < kept_before; ++i) {
        made.table.add_copy(i);
    }
    for (int row = 0; row < rows.count; ++row) {
        made.table.add_row(first, rows.entries[row], rows.size);
    }
    for (int64_t i = kept_before + rows.count + 1; i < axis.count(); ++i) {
        made.table.add_copy(i);
    }
    std::vector<double> knots(axis.knots().begin(), axis.knots().end());
    knots.erase(knots.begin() + last);
    made.axis = std::make_shared<const KnotVector>(axis.degree(), std::move(knots));
    return made;
}

int64_t modulo(int64_t i, int64_t period) noexcept {
    return (i % period + period) % period;
}

// Removes one copy of a knot of a periodic axis, with its copies a period away. Indices are those of the
// infinite periodic sequence, whose stored part begins at 0.
class PeriodicRemoval {
public:
    PeriodicRemoval(const KnotVector &axis, double knot)
        : axis_(axis), period_(axis.distinct_layers()), lead_(4 * int64_t{axis.degree()} + 4),
          last_(last_copy(axis, knot)), multiplicity_(multiplicity(axis.knots(), knot)),
          extended_(refine::extended_knots(axis, lead_)) {}

    [[nodiscard]] bool possible() const noexcept {
        return period_ > std::max(1, axis_.degree() - multiplicity_ + 1);
    }

    refine::AxisTable make() {
        const int p = axis_.degree();
        collect_kept();
        const int64_t lower = place(last_ == p ? p - 1 : p); // the copy that will start the domain
        const auto first = kept_.begin() + lower - p;
        std::vector<double> knots(first, first + period_ + 2 * int64_t{p});
        check_domain(knots);
        refine::AxisTable made{std::make_shared<const KnotVector>(p, std::move(knots), true), {}};
        const std::vector<Row> rows = layers_of_one_period();
        const int64_t base = place(last_ - 1) - p + (multiplicity_ > p ? 0 : 1);
        for (int64_t i = 0; i < period_ - 1 + p; ++i) {
            add(rows[static_cast<size_t>(modulo(lower - p + i - base, period_ - 1))], made.table);
        }
        return made;
    }

private:
    struct Row {
        int64_t first; // old layer
        int size;      // 0: a copy
        const double *entries;
    };

    void collect_kept() {
        for (int64_t i = 0; i < std::ssize(extended_); ++i) {
            if (modulo(i - lead_ - last_, period_) != 0) {
                kept_.push_back(extended_[static_cast<size_t>(i)]);
            }
        }
    }
    // The position in kept_ of a knot that stays.
    [[nodiscard]] int64_t place(int64_t i) const noexcept {
        const int64_t at = i + lead_, removed = modulo(last_ + lead_, period_);
        return at - (at > removed ? (at - removed + period_ - 1) / period_ : 0);
    }

    void check_domain(const std::vector<double> &knots) const {
        const int p = axis_.degree();
        const auto [lower, upper] = axis_.domain();
        if (knots[static_cast<size_t>(p)] != lower ||
            knots[knots.size() - 1 - static_cast<size_t>(p)] != upper) {
            fail(
                Status::periodic_knots,
                "knots: the ends of the periodic domain [%s, %s] have other multiplicities than their copies",
                Number(lower).text, Number(upper).text);
        }
        check_periodic_knots(p, knots, -1, 0);
    }

    // The new layers of the window, and the others unchanged.
    std::vector<Row> layers_of_one_period() {
        const int p = axis_.degree();
        window_ = window_rows(extended_.data() + lead_ + last_, p, multiplicity_);
        std::vector<Row> rows;
        rows.reserve(static_cast<size_t>(period_));
        for (int row = 0; row < window_.count; ++row) {
            rows.push_back({last_ - p - 1, window_.size, window_.entries[row]});
        }
        for (int64_t layer = last_ - multiplicity_ + (multiplicity_ > p ? 2 : 1);
             std::ssize(rows) < period_ - 1; ++layer) {
            rows.push_back({layer, 0, nullptr});
        }
        return rows;
    }

    // A band that extends beyond the stored layers wraps around to their start.
    void add(const Row &row, LayerTable &table) const {
        const int64_t first = modulo(row.first, period_);
        if (row.size == 0) {
            table.add_copy(first);
        } else if (first + row.size <= axis_.count()) {
            table.add_row(first, row.entries, row.size);
        } else {
            std::vector<double> whole(static_cast<size_t>(period_));
            for (int i = 0; i < row.size; ++i) {
                whole[static_cast<size_t>(modulo(first + i, period_))] += row.entries[i];
            }
            table.add_row(0, whole.data(), static_cast<int>(period_));
        }
    }

    const KnotVector &axis_;
    int64_t period_;
    int64_t lead_;
    int64_t last_;
    int multiplicity_;
    std::vector<double> extended_;
    std::vector<double> kept_;
    WindowRows window_{};
};

void check_removable(const KnotVector &axis, int k, double knot) {
    refine::check_knot(axis, k, knot);
    const auto [lower, upper] = axis.domain();
    if (multiplicity(axis.knots(), knot) == 0) {
        fail(Status::not_a_knot, "knot = %s is not a knot of axis %d", Number(knot).text, k);
    }
    if ((knot == lower || knot == upper) &&
        (!axis.periodic() || multiplicity(axis.knots(), axis.domain().lower) == 1)) {
        fail(Status::end_knot, "knot = %s is an end of [%s, %s], the domain of axis %d%s", Number(knot).text,
             Number(lower).text, Number(upper).text, k,
             axis.periodic() ? ": a seam that occurs once can be moved, not removed" : "");
    }
}

// How many copies of a knot can be removed.
int64_t removable_copies(const KnotVector &axis, double knot) {
    return multiplicity(axis.knots(), knot) - (knot == axis.domain().lower ? 1 : 0);
}

// Where removing copies of a knot moves the spline. The extra index on either side covers the case of a jump.
Interval affected(const KnotVector &axis, double knot, int64_t copies) {
    const int64_t p = axis.degree(), last = last_copy(axis, knot);
    const int64_t first = last - copies - p;
    const int64_t end = last - multiplicity(axis.knots(), knot) + p + copies + 1;
    return {std::max(axis.domain().lower, axis[std::max<int64_t>(first, 0)]),
            std::min(axis.domain().upper, axis[std::min<int64_t>(end, axis.count() + p)])};
}

pieces::Enclosure deviation_around(const SplinePtr &before, const SplinePtr &after, int k, double knot,
                                   int64_t copies) {
    const KnotVector &axis = before->axis(k);
    return axis.periodic() ? bounds::deviation(*before, *after)
                           : bounds::deviation(*before, *after, k, affected(axis, knot, copies));
}

} // namespace

refine::AxisTable without_knot(const KnotVector &axis, double knot) {
    if (!axis.periodic()) {
        return without_open_knot(axis, knot);
    }
    PeriodicRemoval removal(axis, knot);
    return removal.possible() ? removal.make() : refine::AxisTable{};
}

namespace {

// Weights below 0 by no more than the rounding of their sums become 0, with their points at the origin.
void clear_rounded_negatives(const Spline &spline, int k, const LayerTable &table, Net &net) {
    const AxisView view = axis_view(spline, k, 1);
    const auto dim = static_cast<size_t>(spline.dim());
    for (size_t i = 0; i < net.weights.size(); ++i) {
        if (net.weights[i] < 0) {
            const auto place = static_cast<int64_t>(i);
            const int64_t inner = place % view.inner, outer = place / view.inner / table.rows();
            const LayerTable::Row &row = table.row(place / view.inner % table.rows());
            double sum = 0;
            for (int j = 0; j < row.size; ++j) {
                const int64_t from = (outer * view.count + row.first + j) * view.inner + inner;
                sum += std::abs(table.coefficients(row)[j] * spline.weight(from));
            }
            if (-net.weights[i] <= rounding_of_zero * sum) {
                net.weights[i] = 0;
                std::fill_n(net.points.begin() + static_cast<std::ptrdiff_t>(i * dim), dim, 0.0);
            }
        }
    }
}

} // namespace

SplinePtr with_axis_if_valid(const Spline &spline, int k, const refine::AxisTable &made) {
    Net net = apply_along(spline, k, made.table);
    clear_rounded_negatives(spline, k, made.table, net);
    return make_result_if_valid(refine::with_axis(spline, k, made.axis), spline.dim(), spline.form(),
                                std::move(net.points), std::move(net.weights));
}

KnotRemoval remove_knot(const SplinePtr &spline, int axis, double knot, int64_t times, double tolerance) {
    const KnotVector &old = spline->axis(axis);
    check_removable(old, axis, knot);
    if (times < 0) {
        fail(Status::times, "times = %lld, expected >= 0", static_cast<long long>(times));
    }
    check_tolerance(tolerance);
    knot = old.periodic() && knot == old.domain().upper ? old.domain().lower : knot;
    KnotRemoval result{spline, 0, 0};
    for (const int64_t most = std::min(times, removable_copies(old, knot)); result.removed < most;) {
        const refine::AxisTable made = without_knot(result.spline->axis(axis), knot);
        const SplinePtr next =
            made.axis == nullptr ? nullptr : with_axis_if_valid(*result.spline, axis, made);
        if (next == nullptr) {
            break;
        }
        const double bound = deviation_around(spline, next, axis, knot, result.removed + 1).upper;
        if (!std::isfinite(bound) || bound > tolerance) {
            break;
        }
        result = {next, result.removed + 1, bound};
    }
    return result;
}

} // namespace nrb::reduce
