// SPDX-License-Identifier: MIT
#include "closest/patch/patch_locator.h"

#include "base/watch.h"
#include "closest/patch/critical/patch_critical.h"
#include "closest/patch/patch_search.h"

#include <algorithm>
#include <limits>

namespace nrb::closest {

Foot PatchLocator::nearest(const Query &query) const {
    Foot foot = PatchSearch(pieces_, tree(), query).nearest();
    foot.noise = PatchSearch::noise(pieces_, query.point);
    return foot;
}

CriticalSet PatchLocator::minima(const Query &query) const {
    const LimitedSearch search;
    CriticalSet set;
    for (const Foot &foot : PatchSearch(pieces_, tree(), query).all()) {
        set.points.push_back({foot, critical_minimum});
        set.status |= foot.status;
    }
    set.revoke_infinite();
    return set;
}

// The nearest and the farthest point are critical points, except at creases. If they are not among the points
// found, vanishing tangents or rounding have hidden some, and the set is not certified.
CriticalSet PatchLocator::critical(const Query &query) const {
    const LimitedSearch search;
    CriticalSet set = critical_points(pieces_, query);
    double least = std::numeric_limits<double>::infinity(), most = 0;
    for (const CriticalPoint &found : set.points) {
        least = std::min(least, found.foot.distance);
        most = std::max(most, found.foot.distance);
    }
    Query other = query;
    other.tolerance = 0;
    const Foot near = nearest(other);
    other.farthest = true;
    const Foot far = nearest(other);
    const double slack = query.tolerance + 2 * near.noise;
    if (!(least <= near.distance + slack && most >= far.distance - slack)) {
        set.status &= ~closest_certified;
    }
    set.revoke_infinite();
    return set;
}

Foot PatchLocator::local(const double *point, const double *guess) const {
    const Query query{point, nullptr, 0, 0};
    return PatchQuery(pieces_, query).local(guess);
}

} // namespace nrb::closest
