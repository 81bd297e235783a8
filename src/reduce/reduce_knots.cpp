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

// A bound for each span of an axis: the largest of all pieces there.
std::vector<double> span_errors(const bounds::DeviationPieces &pieces, const std::vector<double> &uppers,
                                int axes, int axis) {
    size_t inner = 1;
    for (int k = axis + 1; k < axes; ++k) {
        inner *= pieces.breaks()[static_cast<size_t>(k)].size() - 1;
    }
    std::vector<double> errors(pieces.breaks()[static_cast<size_t>(axis)].size() - 1, 0.0);
    for (size_t i = 0; i < uppers.size(); ++i) {
        double &error = errors[i / inner % errors.size()];
        error = std::max(error, uppers[i]);
    }
    return errors;
}

struct Certified {
    SplinePtr spline;
    std::optional<bounds::DeviationPieces> pieces;
    std::vector<double> uppers;
};

// Rounds of removal until one removes nothing, or does not keep the tolerance because of rounding or because
// weights moved; returns the last result that kept it. The removal itself keeps to `aim`.
Certified thin(const SplinePtr &spline, int axis, double tolerance, double aim, bool forgive_rounding) {
    Certified best{spline, {}, {}};
    GreedyKnotRemoval removal(*spline, axis, forgive_rounding);
    for (int round = 0; round < max_rounds; ++round) {
        const Phase phase;
        if (removal.run(aim) == 0) {
            break;
        }
        const SplinePtr next = removal.result();
        bounds::DeviationPieces pieces(*spline, *next);
        std::vector<double> uppers = pieces.uppers();
        const double largest = *std::max_element(uppers.begin(), uppers.end());
        if (!(largest <= tolerance) || !std::isfinite(largest)) {
            break;
        }
        removal.set_errors(pieces.breaks()[static_cast<size_t>(axis)],
                           span_errors(pieces, uppers, spline->axes(), axis));
        best = {next, std::move(pieces), std::move(uppers)};
    }
    return best;
}

// Weights that differ much make the computed rounding larger than it is anywhere, so it is ignored at first.
// If certificates fail, half the tolerance and less is tried.
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
