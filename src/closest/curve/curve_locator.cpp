// SPDX-License-Identifier: MIT
#include "closest/curve/curve_locator.h"

#include "base/watch.h"
#include "closest/curve/curve_critical.h"
#include "closest/curve/curve_search.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace nrb::closest {

CurveLocator::CurveLocator(const Spline &curve)
    : curve_(curve), tree_(curve), domain_(curve.axis(0).domain()), periodic_(curve.axis(0).periodic()) {}

bool CurveLocator::at_end(double t, const Interval *range) const noexcept {
    const Interval ends = range != nullptr ? *range : domain_;
    const bool seam = periodic_ && ends.lower == domain_.lower && ends.upper == domain_.upper;
    return !seam && (t == ends.lower || t == ends.upper);
}

Foot CurveLocator::foot_of(const CurvePlace &place, const Interval *range) const noexcept {
    const Interval leaf = tree_.domain(place.leaf);
    const bool inside = place.s > 0 && place.s < 1;
    double t =
        inside ? leaf.lower + place.s * (leaf.upper - leaf.lower) : (place.s <= 0 ? leaf.lower : leaf.upper);
    t = std::clamp(t, leaf.lower, leaf.upper);
    if (range != nullptr) {
        t = std::clamp(t, range->lower, range->upper);
    }
    const bool left = t == leaf.upper && t < domain_.upper && !tree_.joined(place.leaf);
    return {{t},
            std::ldexp(std::sqrt(place.square), tree_.exponent()),
            at_end(t, range) ? closest_boundary : 0,
            0,
            left ? 1u : 0u};
}

Foot CurveLocator::nearest(const Query &query) const {
    const CurveSearchResult found = search(tree_, query);
    Foot foot = foot_of(found.place, query.range);
    foot.noise = distance_noise(tree_, query.point);
    foot.examined = found.examined;
    foot.status |= found.certified ? closest_certified : closest_budget;
    foot.status |= found.unique ? 0 : closest_not_unique;
    return foot;
}

// Moves from leaf to neighbouring leaf as long as the distance decreases; from the seam of a periodic curve to
// its other side.
Foot CurveLocator::local(const double *point, const double *guess) const {
    constexpr int most_leaves = 100;
    int64_t leaf = tree_.leaf_at(*guess);
    Interval part = tree_.domain(leaf);
    CurvePlace place = descend(tree_, point, leaf, (*guess - part.lower) / (part.upper - part.lower));
    for (int i = 0; i < most_leaves; ++i) {
        const bool up = place.s >= 1, down = place.s <= 0;
        const int64_t next = up ? tree_.after(leaf) : tree_.before(leaf);
        if (!(up || down) || !tree_.joined(up ? leaf : next)) {
            return foot_of(place, nullptr);
        }
        const CurvePlace further = descend(tree_, point, next, up ? 0 : 1);
        if (!(further.square < place.square)) {
            return foot_of(place, nullptr);
        }
        leaf = next;
        place = further;
    }
    Foot foot = foot_of(place, nullptr);
    foot.status |= closest_budget;
    return foot;
}

CriticalSet CurveLocator::critical(const Query &query, double apart, double within) const {
    const Part part = query.range == nullptr ? whole_domain(curve_) : Part{*query.range};
    return critical_points(curve_, {query.point, part, apart, query.most_pieces(), within});
}

CriticalSet CurveLocator::critical(const Query &query) const {
    const LimitedSearch search;
    CriticalSet set = critical(query, query.tolerance, std::numeric_limits<double>::infinity());
    set.revoke_infinite();
    return set;
}

CriticalSet CurveLocator::minima(const Query &query) const {
    const LimitedSearch search;
    Query exact = query;
    exact.tolerance = 0;
    const Foot best = nearest(exact);
    const double reach = best.distance + query.tolerance + 2 * best.noise;
    CriticalSet set = critical(query, -1, reach); // no merging: pieces between events may be left out
    std::erase_if(set.points, [reach](const CriticalPoint &c) {
        const bool minimum = c.kind == critical_minimum || c.kind == critical_undecided;
        return !minimum || c.foot.distance > reach;
    });
    if (set.points.empty()) { // the rounded parameters are too coarse to come within reach
        set.points.push_back({best, critical_minimum});
        set.status &= ~closest_certified;
    }
    const bool certified = (best.status & set.status & closest_certified) != 0;
    set.status &= ~closest_certified;
    set.status |= (certified ? closest_certified : 0) | (best.status & closest_budget);
    set.status |= set.points.size() > 1 ? closest_not_unique : 0;
    set.revoke_infinite();
    return set;
}

} // namespace nrb::closest
