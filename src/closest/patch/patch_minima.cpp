#include "closest/patch/patch_critical.h"
#include "closest/patch/patch_search.h"

#include <algorithm>
#include <utility>

namespace nrb::closest {

void PatchSearch::consider(const PatchItem &item, const AxisValues &at, double distance, bool strict) {
    Place place{item.piece, {}, sign_ * distance, item.moved};
    if (!(place.value <= upper()) || (several_ && !all_)) {
        return;
    }
    for (int k = 0; k < pieces_.shape().axes; ++k) {
        const auto i = static_cast<size_t>(k);
        place.at[i] = std::clamp(item.to_piece(k, at[i]), 0.0, 1.0);
    }
    if (same_point(place, best_)) {
        return;
    }
    const Place before = place;
    walk(place);
    if (place.value < best_.value - noise_) {
        improve_to(items_.whole(place.piece), place.at, sign_ * place.value);
    }
    if (same_point(place, best_)) {
        return;
    }
    if (all_) {
        connected_ = connected_ || !strict;
        const bool is_minimum = before.value - place.value <= noise_;
        if (is_minimum && others_.size() < 4096) {
            others_.push_back(before);
        }
        return;
    }
    several_ = true;
}

// Whether no descent leads on, neither into other pieces nor from a saddle. What is as near as the best point
// is one in any case.
bool PatchSearch::is_minimum(const Place &place) {
    if (place.certain || place.value <= best_.value + noise_) {
        return true;
    }
    doubtful_ = doubtful_ || tolerance_ > noise_;
    const PatchMemory::Hold hold(memory_);
    const PatchJet jet = descent_.jet(items_.whole(place.piece).values, place.at);
    for (size_t k = 0; k < static_cast<size_t>(pieces_.shape().axes); ++k) {
        const double bend = sign_ * (jet.metric[k][k] + jet.curvature[k][k]);
        if (place.at[k] > 0 && place.at[k] < 1 && bend < 0) {
            return false;
        }
    }
    Place other = place;
    const PatchItem item = items_.whole(place.piece);
    other.value = sign_ * descent_.descend(item.values, box(place.piece), sign_, floor_, other.at).distance;
    walk(other);
    return place.value - other.value <= noise_;
}

// Where the tolerance is more than rounding: among the critical points of the pieces that come so near. The
// proofs of search() leave what is worse by less than the tolerance alone.
void PatchSearch::search_minima() {
    const double tolerance = std::exchange(tolerance_, 0.0);
    search();
    tolerance_ = tolerance;
    PatchCandidates candidates(pieces_, tree_, query_, x_, tolerance_ + noise_);
    PatchCandidates::Groups groups;
    candidates.order(upper(), groups);
    std::vector<int64_t> pieces;
    for (const PatchCandidates::Group &group : groups) {
        pieces.push_back(group.piece);
    }
    Query rest = query_;
    rest.tolerance = 0;
    rest.budget = std::max<int64_t>(1, (query_.budget > 0 ? query_.budget : pieces::default_budget) - spent_);
    const PatchCritical::Spots found = PatchCritical(pieces_, rest).minima(pieces, upper());
    for (const PatchCritical::Spot &spot : found.spots) {
        others_.push_back({spot.piece, spot.at, spot.distance, 0, spot.certain});
    }
    incomplete_ = incomplete_ || found.incomplete;
    connected_ = found.connected;
    doubtful_ = found.doubtful;
}

std::vector<Foot> PatchSearch::all() {
    if (far_away()) {
        return {any_point()};
    }
    if (tolerance_ > noise_ && pieces_.shape().coefficients() <= most_squared) {
        search_minima();
    } else {
        all_ = true;
        search();
    }
    others_.push_back(best_);
    std::vector<Place> kept;
    std::sort(others_.begin(), others_.end(),
              [](const Place &a, const Place &b) { return a.value < b.value; });
    for (const Place &place : others_) {
        const auto same = [&](const Place &other) { return same_point(place, other); };
        if (place.value <= upper() && std::none_of(kept.begin(), kept.end(), same) && is_minimum(place)) {
            kept.push_back(place);
        }
    }
    std::vector<Foot> result;
    int32_t status = incomplete_ ? closest_budget : connected_ || doubtful_ ? 0 : closest_certified;
    status |= kept.size() > 1 || connected_ ? closest_not_unique : 0;
    for (const Place &place : kept) {
        result.push_back(foot(place));
        result.back().status |= status;
    }
    std::sort(result.begin(), result.end(), [](const Foot &a, const Foot &b) { return a.params < b.params; });
    return result;
}

} // namespace nrb::closest
