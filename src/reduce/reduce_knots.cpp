// SPDX-License-Identifier: MIT
#include "reduce/reduce_knots.h"

#include "base/tolerance.h"
#include "base/watch.h"
#include "reduce/knot_removal_greedy.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace nrb::reduce {

namespace {

constexpr int max_rounds = 12;
constexpr int max_attempts = 5;

// Upper bounds of the distance from another spline: errors[i] in [breaks[i], breaks[i + 1]) along an axis.
struct SpanErrors {
    std::vector<double> breaks, errors;

    [[nodiscard]] double largest() const { return *std::max_element(errors.begin(), errors.end()); }
};

// For each span, the largest bound of all its pieces.
SpanErrors span_errors(const bounds::DeviationPieces &pieces, const std::vector<double> &uppers, int axes,
                       int axis) {
    size_t inner = 1;
    for (int k = axis + 1; k < axes; ++k) {
        inner *= pieces.breaks()[static_cast<size_t>(k)].size() - 1;
    }
    const std::vector<double> &breaks = pieces.breaks()[static_cast<size_t>(axis)];
    std::vector<double> errors(breaks.size() - 1, 0.0);
    for (size_t i = 0; i < uppers.size(); ++i) {
        double &error = errors[i / inner % errors.size()];
        error = std::max(error, uppers[i]);
    }
    return {breaks, std::move(errors)};
}

// Adds, for each span, the largest error of the other list, whose breaks are finer.
void add_largest(SpanErrors &sum, const SpanErrors &finer) {
    size_t i = 0;
    for (size_t span = 0; span < sum.errors.size(); ++span) {
        double largest = 0;
        for (; i < finer.errors.size() && finer.breaks[i] < sum.breaks[span + 1]; ++i) {
            largest = std::max(largest, finer.errors[i]);
        }
        sum.errors[span] += largest;
    }
}

struct Certified {
    SplinePtr spline;
    std::optional<bounds::DeviationPieces> pieces;
    std::vector<double> uppers;
};

// One round of removals. Their estimated errors add up, though most of them cancel. Where many knots are gone
// already, the errors are measured against the last result, whose own errors are known. This costs little,
// and admits more removals before the whole is compared with the original again.
class Round {
public:
    Round(GreedyKnotRemoval &removal, int axis, double aim) : removal_(removal), axis_(axis), aim_(aim) {}

    // Whether anything was removed from the last result.
    bool run(const Spline &last, const std::optional<SpanErrors> &known) {
        const bool removed = removal_.run(aim_) > 0;
        bool more = removed && known.has_value() && 2 * last.point_count() < std::ssize(known->errors);
        while (more) {
            const Phase phase;
            more = measure(last, *known) && removal_.run(aim_) > 0;
        }
        return removed;
    }

private:
    bool measure(const Spline &last, const SpanErrors &known) {
        const bounds::DeviationPieces pieces(last, *removal_.result());
        SpanErrors sum = span_errors(pieces, pieces.uppers(), last.axes(), axis_);
        add_largest(sum, known);
        const bool within = sum.largest() <= aim_;
        if (within) {
            removal_.set_errors(sum.breaks, sum.errors);
        }
        return within;
    }

    GreedyKnotRemoval &removal_;
    int axis_;
    double aim_;
};

// Rounds of removal until a round removes nothing, or exceeds the tolerance because of rounding or because
// weights changed; returns the last result within the tolerance. The removal itself aims at `aim`.
Certified thin(const SplinePtr &spline, int axis, double tolerance, double aim, bool forgive_rounding) {
    Certified best{spline, {}, {}};
    bounds::DeviationsFrom deviations(*spline);
    std::optional<SpanErrors> known;
    GreedyKnotRemoval removal(*spline, axis, forgive_rounding);
    for (int round = 0; round < max_rounds; ++round) {
        const Phase phase;
        if (!Round(removal, axis, aim).run(*best.spline, known)) {
            break;
        }
        const SplinePtr next = removal.result();
        bounds::DeviationPieces pieces = deviations.to(*next);
        std::vector<double> uppers = pieces.uppers();
        known = span_errors(pieces, uppers, spline->axes(), axis);
        if (!(known->largest() <= tolerance) || !std::isfinite(known->largest())) {
            break;
        }
        removal.set_errors(known->breaks, known->errors);
        best = {next, std::move(pieces), std::move(uppers)};
    }
    return best;
}

// Where weights differ much, the rounding in the computed gaps looks larger than it is anywhere, so it is
// forgiven at first. If the certificate fails, it is no longer forgiven, and then half the tolerance and less
// is tried.
Reduced reduce_axis(const SplinePtr &spline, int axis, double tolerance) {
    double aim = tolerance;
    bool forgive = spline->rational();
    for (int attempt = 0; attempt < max_attempts; ++attempt, aim /= forgive ? 1 : 2, forgive = false) {
        const Phase phase;
        const Certified found = thin(spline, axis, tolerance, aim, forgive);
        if (found.pieces.has_value()) {
            return {found.spline, std::min(tolerance, found.pieces->enclosure(found.uppers).upper)};
        }
    }
    return {spline, 0};
}

} // namespace

Reduced reduce_knots(const SplinePtr &spline, int axis, double tolerance) {
    check_tolerance(tolerance);
    if (axis >= 0) {
        return reduce_axis(spline, axis, tolerance);
    }
    Reduced result{spline, 0};
    double sum = 0;
    Steps steps(spline->axes());
    for (int k = 0; k < spline->axes(); ++k, steps.next()) {
        const double share = (tolerance - result.bound) / (spline->axes() - k);
        const Reduced next = reduce_axis(result.spline, k, std::max(share, 0.0));
        if (next.spline == result.spline) {
            continue;
        }
        sum += next.bound;
        result = {next.spline,
                  k == 0 ? next.bound : std::min(sum, bounds::deviation(*spline, *next.spline).upper)};
    }
    return result;
}

} // namespace nrb::reduce
