// SPDX-License-Identifier: MIT
#include "reduce/compatible.h"

#include "reduce/knot_clusters.h"
#include "reduce/layer_deviation.h"
#include "reduce/snap.h"
#include "refine/degree/elevate.h"
#include "refine/forms/homogeneous.h"
#include "refine/forms/parametrization.h"
#include "refine/parts/cut.h"
#include "refine/periodic/period.h"
#include "refine/periodic/periodic.h"
#include "refine/periodic/seam.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <functional>
#include <iterator>
#include <limits>
#include <map>

namespace nrb::reduce {

namespace {

// Orders axes by their contents, first by degree.
struct AxisLess {
    bool operator()(const KnotVectorPtr &a, const KnotVectorPtr &b) const noexcept {
        if (a == b) {
            return false;
        }
        if (a->degree() != b->degree() || a->periodic() != b->periodic()) {
            return a->degree() != b->degree() ? a->degree() < b->degree() : b->periodic();
        }
        return std::lexicographical_compare(a->knots().begin(), a->knots().end(), b->knots().begin(),
                                            b->knots().end());
    }
};

// The distinct axes along one direction, each with the splines that have it.
using Groups = std::map<KnotVectorPtr, std::vector<size_t>, AxisLess>;

class Set {
public:
    explicit Set(std::span<const SplinePtr> splines) : splines_(splines.begin(), splines.end()) {
        const Form form = refine::common_form(splines);
        for (SplinePtr &spline : splines_) {
            spline = refine::in_form(spline, form);
        }
    }

    [[nodiscard]] Groups groups(int k) const {
        Groups groups;
        for (size_t i = 0; i < splines_.size(); ++i) {
            groups[splines_[i]->knot_vectors()[static_cast<size_t>(k)]].push_back(i);
        }
        return groups;
    }
    // Applies one table to all splines that share an axis.
    void apply(int k, const std::vector<size_t> &members, const refine::AxisTable &made) {
        for (const size_t i : members) {
            splines_[i] = refine::with_axis(*splines_[i], k, made);
        }
    }
    [[nodiscard]] std::vector<SplinePtr> &splines() noexcept { return splines_; }

private:
    std::vector<SplinePtr> splines_;
};

void check_axis_counts(std::span<const SplinePtr> splines) {
    for (size_t i = 1; i < splines.size(); ++i) {
        if (splines[i]->axes() != splines[0]->axes()) {
            fail(Status::incompatible, "splines[%zu] has %d axes, expected %d as splines[0] has", i,
                 splines[i]->axes(), splines[0]->axes());
        }
    }
}

// Maps the domains to that of the first spline: all of them, or only those whose ends are within `tolerance`
// times its length. Returns how far the point at a parameter may have moved in the latter case.
double unify_domain(Set &set, int k, bool any, double tolerance) {
    const auto [lower, upper] = set.splines()[0]->axis(k).domain();
    const double width = tolerance * (upper - lower);
    double largest = 0;
    for (size_t i = 1; i < set.splines().size(); ++i) {
        SplinePtr &spline = set.splines()[i];
        const Interval domain = spline->axis(k).domain();
        if (domain.lower == lower && domain.upper == upper) {
            continue;
        }
        const double shift = std::max(std::abs(domain.lower - lower), std::abs(domain.upper - upper));
        const double moved = any ? 0 : shift * speed_bound(*spline, k);
        if (!any && !(shift <= width && std::isfinite(moved))) {
            fail(Status::incompatible,
                 "splines[%zu]: domain [%s, %s] on axis %d, expected [%s, %s] as in splines[0]", i,
                 Number(domain.lower).text, Number(domain.upper).text, k, Number(lower).text,
                 Number(upper).text);
        }
        spline = refine::reparametrize(spline, k, {lower, upper});
        largest = std::max(largest, moved);
    }
    return largest;
}

// Makes all axes non-periodic, unless all of them are periodic.
void unify_periodicity(Set &set, int k) {
    const auto periodic = [k](const SplinePtr &spline) { return spline->axis(k).periodic(); };
    std::vector<SplinePtr> &splines = set.splines();
    if (!std::all_of(splines.begin(), splines.end(), periodic)) {
        for (SplinePtr &spline : splines) {
            spline = refine::open_axis(spline, k);
        }
    }
}

void unify_degree(Set &set, int k) {
    const Groups groups = set.groups(k);
    const int degree = groups.rbegin()->first->degree(); // the order begins with the degree
    for (const auto &[axis, members] : groups) {
        if (axis->degree() < degree) {
            set.apply(k, members, refine::elevate_axis(*axis, degree - axis->degree()));
        }
    }
}

// Clamps an end at which the knots outside the domain differ.
void unify_ends(Set &set, int k) {
    const Groups groups = set.groups(k);
    const std::span<const double> first = groups.begin()->first->knots();
    const auto p = std::ptrdiff_t{groups.begin()->first->degree()};
    refine::AxisEnds ends{false, false};
    for (const auto &[axis, members] : groups) {
        const std::span<const double> knots = axis->knots();
        ends.lower = ends.lower || !std::equal(first.begin(), first.begin() + p, knots.begin());
        ends.upper = ends.upper || !std::equal(first.end() - p, first.end(), knots.end() - p);
    }
    for (SplinePtr &spline : set.splines()) {
        spline = refine::clamp_ends(spline, k, ends);
    }
}

// The rows of a periodic axis, from layer `shift` on.
LayerTable rotated(const LayerTable &table, int64_t shift, int64_t period) {
    LayerTable result;
    result.reserve(table.rows());
    for (int64_t i = 0; i < table.rows(); ++i) {
        const LayerTable::Row &row = table.row((i + shift) % period);
        if (row.size == 0) {
            result.add_copy(row.first);
        } else {
            result.add_row(row.first, table.coefficients(row), row.size);
        }
    }
    return result;
}

// The number of copies of the lower end after the copy that starts the domain.
int64_t copies_after(const KnotVector &axis) {
    const auto knots = axis.knots();
    return std::upper_bound(knots.begin(), knots.end(), axis.domain().lower) - knots.begin() - 1 -
           axis.degree();
}

// A periodic axis from one period of its knots: those above its lower end, which is placed at index degree,
// up to the copies of that end at the upper end.
KnotVectorPtr periodic_axis(int degree, Interval domain, std::span<const double> period, int k) {
    const auto p = static_cast<size_t>(degree);
    std::vector<double> knots(period.size() + 2 * p + 1, domain.upper);
    knots[p] = domain.lower;
    const auto inside = std::upper_bound(period.begin(), period.end(), domain.lower);
    std::copy(inside, period.end(), knots.begin() + static_cast<std::ptrdiff_t>(p) + 1);
    refine::continue_knots(knots, p, p + period.size(), period.size());
    return make_knot_vector(degree, std::move(knots), true, k);
}

// The knots in [lower, upper).
std::span<const double> one_period(const KnotVector &axis) {
    const auto [lower, upper] = axis.domain();
    const auto knots = axis.knots();
    const auto first = std::lower_bound(knots.begin(), knots.end(), lower);
    return {first, std::lower_bound(first, knots.end(), upper)};
}

// The clusters of the knots of all groups: those inside the domain, and its ends.
KnotClusters clusters_of(const Groups &groups, double tolerance) {
    std::map<double, int64_t> pool;
    const Interval domain = groups.begin()->first->domain();
    for (const auto &[axis, members] : groups) {
        for (const double knot : axis->knots()) {
            pool[knot] += std::ssize(members);
        }
    }
    constexpr int64_t most = std::numeric_limits<int>::max(); // so that the int below does not overflow
    std::vector<KnotGroup> knots;
    knots.reserve(pool.size());
    for (const auto &[knot, times] : pool) {
        knots.push_back({knot, static_cast<int>(std::min(times, most))});
    }
    return {knots, domain, tolerance * (domain.upper - domain.lower)};
}

// Merges nearly equal knots of different splines; marks the splines that changed in `moved`.
void unify_values(Set &set, int k, double tolerance, std::vector<char> &moved) {
    if (tolerance == 0) {
        return;
    }
    const Groups groups = set.groups(k);
    if (groups.size() == 1) {
        return;
    }
    const KnotClusters clusters = clusters_of(groups, tolerance);
    for (const auto &[axis, members] : groups) {
        char owner[40];
        static_cast<void>(std::snprintf(owner, sizeof owner, "splines[%zu]: ", members.front()));
        const refine::AxisTable snapped = moved_axis(axis, clusters, k, owner);
        for (const size_t i : members) {
            if (snapped.axis != axis) {
                set.splines()[i] = over_axis(*set.splines()[i], k, snapped);
                moved[i] = 1;
            }
        }
    }
}

std::vector<double> united(const Groups &groups,
                           const std::function<std::span<const double>(const KnotVector &)> &part) {
    std::vector<std::vector<double>> lists;
    for (const auto &[axis, members] : groups) {
        const std::span<const double> knots = part(*axis);
        lists.emplace_back(knots.begin(), knots.end());
    }
    while (lists.size() > 1) { // in pairs, so that each knot is copied at most log2(groups) times
        for (size_t i = 0; i < lists.size(); i += 2) {
            std::vector<double> both;
            if (i + 1 < lists.size()) {
                both.reserve(lists[i].size() + lists[i + 1].size());
                std::set_union(lists[i].begin(), lists[i].end(), lists[i + 1].begin(), lists[i + 1].end(),
                               std::back_inserter(both));
            } else {
                both = std::move(lists[i]);
            }
            lists[i / 2] = std::move(both);
        }
        lists.resize((lists.size() + 1) / 2);
    }
    return std::move(lists.front());
}

std::vector<double> missing(const std::vector<double> &all, std::span<const double> own) {
    std::vector<double> knots;
    knots.reserve(all.size());
    std::set_difference(all.begin(), all.end(), own.begin(), own.end(), std::back_inserter(knots));
    return knots;
}

void unify_plain_knots(Set &set, int k) {
    const Groups groups = set.groups(k);
    const std::vector<double> all = united(groups, [](const KnotVector &axis) { return axis.knots(); });
    KnotVectorPtr common = std::make_shared<const KnotVector>(groups.begin()->first->degree(), all);
    for (const auto &[axis, members] : groups) {
        set.apply(k, members, {common, refine::rows_over(*axis, all)});
    }
}

// As for non-periodic axes, but the same copy of the seam must start the domain on all axes. Knots outside
// the domain may differ by rounding; the effect of that is bounded and returned.
double unify_periodic_knots(Set &set, int k) {
    const Groups groups = set.groups(k);
    const KnotVector &first = *groups.begin()->first;
    const std::vector<double> all = united(groups, one_period);
    const KnotVectorPtr common = periodic_axis(first.degree(), first.domain(), all, k);
    double deviation = 0;
    for (const auto &[axis, members] : groups) {
        refine::AxisTable made = refine::refine_periodic(*axis, missing(all, one_period(*axis)));
        const int64_t shift = copies_after(*made.axis), period = std::ssize(all);
        made.table = rotated(made.table, shift, period);
        const std::span<const double> kept = made.axis->knots().subspan(static_cast<size_t>(shift));
        const bool exact = std::equal(kept.begin(), kept.end(), common->knots().begin());
        made.axis = common;
        for (const size_t i : members) {
            const SplinePtr before = set.splines()[i];
            set.splines()[i] = refine::with_axis(*before, k, made);
            deviation = exact ? deviation : std::max(deviation, deviation_bound(before, set.splines()[i]));
        }
    }
    return deviation;
}

double unify_knots(Set &set, int k) {
    const Groups groups = set.groups(k);
    if (groups.size() == 1) {
        return 0;
    }
    if (groups.begin()->first->periodic()) {
        return unify_periodic_knots(set, k);
    }
    unify_plain_knots(set, k);
    return 0;
}

} // namespace

Compatible make_compatible(std::span<const SplinePtr> splines, double tolerance, bool map_domains) {
    check_relative_tolerance(tolerance);
    check_axis_counts(splines);
    Set set(splines);
    const int axes = splines[0]->axes();
    double shifted = 0;
    for (int k = 0; k < axes; ++k) {
        shifted += unify_domain(set, k, map_domains, tolerance);
        unify_periodicity(set, k);
        unify_degree(set, k);
        if (!set.splines()[0]->axis(k).periodic()) {
            unify_ends(set, k);
        }
    }
    const std::vector<SplinePtr> exact = set.splines();
    std::vector<char> moved(splines.size(), 0);
    for (int k = 0; k < axes; ++k) {
        unify_values(set, k, tolerance, moved);
    }
    double deviation = 0, rounding = 0;
    for (size_t i = 0; i < splines.size(); ++i) {
        if (moved[i] != 0) {
            check_spline(*set.splines()[i], Values::computed);
            deviation = std::max(deviation, deviation_bound(exact[i], set.splines()[i]));
        }
    }
    for (int k = 0; k < axes; ++k) {
        rounding += unify_knots(set, k);
    }
    return {std::move(set.splines()), shifted + deviation + rounding};
}

} // namespace nrb::reduce
