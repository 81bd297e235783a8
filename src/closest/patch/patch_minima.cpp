// SPDX-License-Identifier: MIT
#include "closest/patch/patch_minima.h"

#include "base/numbers.h"
#include "closest/near_points.h"

#include <algorithm>

namespace nrb::closest {

namespace {

constexpr size_t most_others = 4096;

} // namespace

bool PatchMinima::best_in(const PatchItem &item, AxisValues &at) const noexcept {
    bool inside = best_.piece == item.piece;
    for (size_t k = 0; inside && k < static_cast<size_t>(pieces_.shape().axes); ++k) {
        at[k] = (best_.at[k] - item.lower[k]) / item.length[k];
        inside = at[k] >= 0 && at[k] <= 1;
    }
    return inside;
}

bool PatchMinima::improve_to(const PatchItem &item, const AxisValues &at, double distance) {
    const double value = sign_ * distance;
    if (!(value < best_.value - 1e-2 * noise_) && !(best_.value == infinity && std::isfinite(value))) {
        return false;
    }
    if (all_ && best_.value < infinity) {
        others_.push_back(best_);
    }
    best_.piece = item.piece;
    best_.value = value;
    best_.error = item.moved + pieces_.value_error() * item.reach;
    for (int k = 0; k < pieces_.shape().axes; ++k) {
        const auto i = static_cast<size_t>(k);
        best_.at[i] = std::clamp(item.to_piece(k, at[i]), 0.0, 1.0);
    }
    return true;
}

void PatchMinima::consider(const PatchItem &item, const AxisValues &at, double distance, bool strict) {
    FootCandidate place{item.piece, {}, sign_ * distance, item.moved};
    if (!(place.value <= upper()) || ((not_unique_ || query_.alone) && !all_)) {
        return;
    }
    for (int k = 0; k < pieces_.shape().axes; ++k) {
        const auto i = static_cast<size_t>(k);
        place.at[i] = std::clamp(item.to_piece(k, at[i]), 0.0, 1.0);
    }
    if (same_as_best(place)) {
        return;
    }
    const FootCandidate before = place;
    walk(place);
    if (place.value < best_.value - noise_) {
        improve_to(items_.whole(place.piece), place.at, sign_ * place.value);
    }
    if (!same_as_best(place)) {
        keep(before, place, strict);
    }
}

// `before`: a place from which a descent led to `after`, which is not the best place.
void PatchMinima::keep(const FootCandidate &before, const FootCandidate &after, bool strict) {
    if (!all_) {
        not_unique_ = true;
        return;
    }
    connected_ = connected_ || !strict;
    const bool is_minimum = before.value - after.value <= noise_;
    if (is_minimum && others_.size() < most_others) {
        others_.push_back(before);
    }
}

// Whether no descent leads on from a place, neither into other pieces nor down from a saddle. A place as near
// as the best one is always a minimum.
bool PatchMinima::is_minimum(const FootCandidate &place) {
    if (place.certain || place.value <= best_.value + noise_) {
        return true;
    }
    doubtful_ = doubtful_ || tolerance_ > noise_;
    const PatchMemory::Hold hold(memory_);
    if (is_saddle(place)) {
        return false;
    }
    FootCandidate other = place;
    const double *values = items_.values(place.piece);
    other.value = sign_ * descent_.descend(values, box(place.piece), sign_, floor_, other.at).distance;
    walk(other);
    return place.value - other.value <= noise_;
}

// Whether the second derivative of the distance along some axis is negative in the interior of the piece.
bool PatchMinima::is_saddle(const FootCandidate &place) const {
    const PatchJet jet = descent_.jet(items_.values(place.piece), place.at);
    for (size_t k = 0; k < static_cast<size_t>(pieces_.shape().axes); ++k) {
        const double bend = sign_ * (jet.metric[k][k] + jet.curvature[k][k]);
        if (place.at[k] > 0 && place.at[k] < 1 && bend < 0) {
            return true;
        }
    }
    return false;
}

std::vector<PatchQuery::FootCandidate> PatchMinima::distinct_minima() {
    others_.push_back(best_);
    std::sort(others_.begin(), others_.end(),
              [](const FootCandidate &a, const FootCandidate &b) { return a.value < b.value; });
    std::vector<FootCandidate> kept;
    const auto value_of = [](const FootCandidate &place) { return std::abs(place.value); };
    const FootCandidate &farthest = *std::ranges::max_element(others_, {}, value_of);
    NearPoints points(pieces_.shape().dim, least_apart(farthest.value));
    for (const FootCandidate &place : others_) {
        if (!(place.value <= upper())) {
            continue;
        }
        const std::vector<double> point = point_of(place);
        const auto same = [&](int64_t number) {
            return same_point(place, kept[static_cast<size_t>(number)]);
        };
        if (!points.any_near(point.data(), same) && (query_.sheets || is_minimum(place))) {
            kept.push_back(place);
            points.add(point.data());
        }
    }
    return kept;
}

} // namespace nrb::closest
