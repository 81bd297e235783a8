// SPDX-License-Identifier: MIT
#include "refine/knots/insert.h"

#include "base/checked.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace nrb::refine {

namespace {

// How messages refer to a knot: "knot", or "knots[index]" in a list.
struct KnotName {
    explicit KnotName(int64_t index) noexcept : text{} {
        if (index < 0) {
            static_cast<void>(std::snprintf(text, sizeof text, "knot"));
        } else {
            static_cast<void>(std::snprintf(text, sizeof text, "knots[%lld]", static_cast<long long>(index)));
        }
    }
    char text[32];
};

} // namespace

void check_knot(const KnotVector &axis, int k, double knot, int64_t index) {
    if (!std::isfinite(knot)) {
        fail(Status::parameter_not_finite, "%s = %s is not finite", KnotName(index).text, Number(knot).text);
    }
    const auto [lower, upper] = axis.domain();
    if (knot < lower || knot > upper) {
        fail(Status::outside_domain, "%s = %s outside [%s, %s], the domain of axis %d", KnotName(index).text,
             Number(knot).text, Number(lower).text, Number(upper).text, k);
    }
}

namespace {

// The end of a periodic domain is replaced by its start, which is the same knot.
double first_copy(const KnotVector &axis, double knot) noexcept {
    return axis.periodic() && knot == axis.domain().upper ? axis.domain().lower : knot;
}

void check_multiplicity(const KnotVector &axis, int k, double knot, int64_t times) {
    const int present = multiplicity(axis.knots(), knot);
    if (times > axis.degree() + 1 - present) {
        fail(Status::multiplicity,
             "knot = %s occurs %d times on axis %d; times = %lld would exceed the limit of degree + 1 = %d",
             Number(knot).text, present, k, static_cast<long long>(times), axis.degree() + 1);
    }
}

// Fails with the first entry of the caller's list that makes the knot occur too often.
[[noreturn]] void fail_multiplicity(const KnotVector &axis, int k, std::span<const double> knots, double knot,
                                    int64_t present) {
    int64_t room = axis.degree() + 1 - present;
    size_t i = 0;
    while (first_copy(axis, knots[i]) != knot || room-- > 0) {
        ++i;
    }
    fail(Status::multiplicity,
         "knots[%zu] = %s: with the entries before, and %lld on axis %d already, it would occur %d times; "
         "degree %d allows %d",
         i, Number(knots[i]).text, static_cast<long long>(present), k, axis.degree() + 2, axis.degree(),
         axis.degree() + 1);
}

// Whether the knots are strictly increasing inside the open domain, and no knot there has multiplicity degree
// + 1. Then no knot becomes too frequent.
bool rising_inside(const KnotVector &axis, std::span<const double> knots) noexcept {
    const auto [lower, upper] = axis.domain();
    if (knots.empty() || !(lower < knots.front() && knots.back() < upper) || axis.degree() == 0) {
        return false;
    }
    bool rising = true;
    for (size_t i = 1; i < knots.size(); ++i) {
        rising = rising & (knots[i - 1] < knots[i]);
    }
    const int64_t p = axis.degree();
    for (int64_t i = p + 1; i + p < axis.count(); ++i) {
        rising = rising & (axis[i] != axis[i + p]);
    }
    return rising;
}

void check_multiplicities(const KnotVector &axis, int k, std::span<const double> knots,
                          const std::vector<double> &sorted) {
    const std::span<const double> old = axis.knots();
    size_t at = 0; // the first old knot >= knot
    for (size_t group = 0, after = 0; group < sorted.size(); group = after) {
        const double knot = sorted[group];
        while (after < sorted.size() && sorted[after] == knot) {
            ++after;
        }
        while (at < old.size() && old[at] < knot) {
            ++at;
        }
        size_t last = at;
        while (last < old.size() && old[last] == knot) {
            ++last;
        }
        if (after - group + (last - at) > static_cast<size_t>(axis.degree()) + 1) {
            fail_multiplicity(axis, k, knots, knot, static_cast<int64_t>(last - at));
        }
    }
}

// Division point i of a span, computed from the nearer end so that the division is symmetric.
double division(double lower, double upper, int64_t i, int64_t parts) noexcept {
    const auto n = static_cast<double>(parts);
    return 2 * i <= parts ? lower + (upper - lower) * (static_cast<double>(i) / n)
                          : upper - (upper - lower) * (static_cast<double>(parts - i) / n);
}

} // namespace

SplinePtr insert_knot(const SplinePtr &spline, int axis, double knot, int64_t times) {
    const KnotVector &knots = spline->axis(axis);
    check_knot(knots, axis, knot, -1);
    if (times < 0) {
        fail(Status::times, "times = %lld, expected >= 0", static_cast<long long>(times));
    }
    knot = first_copy(knots, knot);
    check_multiplicity(knots, axis, knot, times);
    return refine(spline, axis, std::vector<double>(static_cast<size_t>(times), knot));
}

std::vector<double> checked_new_knots(const KnotVector &axis, int k, std::span<const double> knots) {
    std::vector<double> sorted(knots.begin(), knots.end());
    if (rising_inside(axis, knots)) { // which most lists are
        return sorted;
    }
    const auto [lower, upper] = axis.domain();
    for (size_t i = 0; i < sorted.size(); ++i) {
        if (!(lower <= sorted[i] && sorted[i] < upper)) {
            check_knot(axis, k, sorted[i], static_cast<int64_t>(i));
            sorted[i] = first_copy(axis, sorted[i]);
        }
    }
    if (!std::is_sorted(sorted.begin(), sorted.end())) {
        std::sort(sorted.begin(), sorted.end());
    }
    check_multiplicities(axis, k, knots, sorted);
    return sorted;
}

std::vector<double> uniform_new_knots(const KnotVector &axis, int k, int64_t parts) {
    if (parts < 1) {
        fail(Status::count, "parts = %lld, expected at least 1", static_cast<long long>(parts));
    }
    std::vector<double> knots;
    knots.reserve(static_cast<size_t>(checked_product(axis.spans().size(), parts - 1, "knots")));
    for (const int64_t span : axis.spans().indices()) {
        double last = axis[span];
        for (int64_t i = 1; i <= parts; ++i) {
            const double knot = i == parts ? axis[span + 1] : division(axis[span], axis[span + 1], i, parts);
            if (!(knot > last)) {
                fail(Status::not_representable,
                     "parts = %lld: [%s, %s] on axis %d has too few doubles to be divided so",
                     static_cast<long long>(parts), Number(axis[span]).text, Number(axis[span + 1]).text, k);
            }
            last = knot;
            if (i < parts) {
                knots.push_back(knot);
            }
        }
    }
    return knots;
}

SplinePtr refine(const SplinePtr &spline, int axis, std::span<const double> sorted_knots) {
    const KnotVector &old = spline->axis(axis);
    if (sorted_knots.empty()) {
        return spline;
    }
    if (old.periodic()) {
        return with_axis(*spline, axis, refine_axis(old, sorted_knots));
    }
    auto fine = std::make_shared<const KnotVector>(old.degree(), merged(old.knots(), sorted_knots));
    const Refinement refinement(old.degree(), old.knots(), fine->knots());
    return with_axis(*spline, axis, std::move(fine), 1,
                     [&](int64_t first, int64_t end) { return rows_of(refinement, first, end); });
}

} // namespace nrb::refine
