// SPDX-License-Identifier: MIT
#include "refine/periodic/seam.h"

#include <algorithm>
#include <cmath>

namespace nrb::refine {

namespace {

// The knots of the endless sequence from `from` to from + distinct + 2 degree. Those beyond the stored ones
// are rounded once.
std::vector<double> moved_knots(const KnotVector &axis, int64_t from) {
    const int64_t distinct = axis.distinct_layers();
    const int p = axis.degree();
    const double period = axis.domain().upper - axis.domain().lower;
    std::vector<double> knots;
    for (int64_t i = from; i < from + distinct + 2 * int64_t{p} + 1; ++i) {
        const int64_t last = axis.count() + p; // stored knots are kept as they are
        const int64_t periods = i <= last ? 0 : (i - last + distinct - 1) / distinct;
        const double knot = axis[i - periods * distinct];
        knots.push_back(periods == 0 ? knot : knot + static_cast<double>(periods) * period);
    }
    return knots;
}

// Checks that knots moved by a period are equal if and only if their originals are.
void check_moved(const KnotVector &axis, int64_t from, const std::vector<double> &knots) {
    if (!std::isfinite(knots.back() - knots.front())) {
        fail(Status::not_representable, "seam: knots overflow when they are moved by a period");
    }
    const int64_t distinct = axis.distinct_layers();
    for (int64_t i = 0; i + 1 < std::ssize(knots); ++i) {
        const int64_t old = (from + i) % distinct;
        const bool equal = axis[old] == axis[old + 1];
        const double here = knots[static_cast<size_t>(i)], next = knots[static_cast<size_t>(i) + 1];
        if (equal ? here != next : !(here < next)) {
            fail(Status::periodic_knots, "seam: moved by a period, knots %s and %s would round to %s and %s",
                 Number(axis[old]).text, Number(axis[old + 1]).text, Number(here).text, Number(next).text);
        }
    }
}

} // namespace

SplinePtr open_axis(const SplinePtr &spline, int axis) {
    const KnotVector &old = spline->axis(axis);
    if (!old.periodic()) {
        return spline;
    }
    auto open = std::make_shared<const KnotVector>(
        old.degree(), std::vector<double>(old.knots().begin(), old.knots().end()));
    return std::make_shared<const Spline>(
        with_axis(*spline, axis, std::move(open)), spline->dim(), spline->form(),
        std::vector<double>(spline->points().begin(), spline->points().end()),
        std::vector<double>(spline->weights().begin(), spline->weights().end()));
}

SplinePtr move_seam(const SplinePtr &spline, int axis, double seam) {
    const auto [lower, upper] = spline->axis(axis).domain();
    if (seam == lower || seam == upper) {
        return spline;
    }
    SplinePtr cut = spline;
    if (multiplicity(spline->axis(axis).knots(), seam) == 0) {
        const double knot[] = {seam};
        cut = with_axis(*spline, axis, refine_axis(spline->axis(axis), knot));
    }
    const KnotVector &old = cut->axis(axis);
    const int p = old.degree();
    const auto last = std::upper_bound(old.knots().begin(), old.knots().end(), seam) - 1;
    const int64_t from = (last - old.knots().begin()) - p;
    std::vector<double> knots = moved_knots(old, from);
    check_moved(old, from, knots);
    AxisTable moved{make_knot_vector(p, std::move(knots), true, axis), {}};
    for (int64_t i = 0; i < moved.axis->count(); ++i) {
        moved.table.add_copy((from + i) % old.distinct_layers());
    }
    return with_axis(*cut, axis, moved);
}

} // namespace nrb::refine
