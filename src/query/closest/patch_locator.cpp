#include "query/closest/patch_locator.h"

#include "query/closest/patch_critical.h"
#include "query/closest/patch_search.h"

namespace nrb {

Foot PatchLocator::nearest(const Query &query) const {
    Foot foot = PatchSearch(pieces_, tree_, query).nearest();
    foot.noise = PatchSearch::noise(pieces_, query.point);
    return foot;
}

CriticalSet PatchLocator::minima(const Query &query) const {
    CriticalSet set;
    for (const Foot &foot : PatchSearch(pieces_, tree_, query).all()) {
        set.points.push_back({foot, NURBS_CRITICAL_MINIMUM});
        set.status |= foot.status;
    }
    return set;
}

CriticalSet PatchLocator::critical(const Query &query) const {
    return PatchCritical(pieces_, query).run();
}

Foot PatchLocator::local(const double *point, const double *guess) const {
    const Query query{point, nullptr, 0, 0};
    return PatchQuery(pieces_, query).local(guess);
}

} // namespace nrb
