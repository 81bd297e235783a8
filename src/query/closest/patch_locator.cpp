#include "query/closest/patch_locator.h"

#include "query/closest/patch_search.h"

namespace nrb {

double PatchLocator::noise(const double *point) const noexcept {
    return PatchSearch::noise(pieces_, point);
}

Foot PatchLocator::nearest(const Query &query) const {
    return PatchSearch(pieces_, tree_, query).nearest();
}

std::vector<Foot> PatchLocator::nearest_all(const Query &query) const {
    return PatchSearch(pieces_, tree_, query).all();
}

Foot PatchLocator::local(const double *point, const double *guess) const {
    const Query query{point, nullptr, 0, 0};
    return PatchSearch(pieces_, tree_, query).local(guess);
}

} // namespace nrb
