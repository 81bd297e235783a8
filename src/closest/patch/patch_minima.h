// SPDX-License-Identifier: MIT
// The best place that a search has found, and the other minima that are as near.
#pragma once

#include "closest/patch/patch_query.h"

#include <vector>

namespace nrb::closest {

class PatchMinima : public PatchQuery {
protected:
    PatchMinima(const PieceGrid &pieces, const Query &query) : PatchQuery(pieces, query) {}

    // Values below are better than the best one by more than counts, or worse by no more.
    [[nodiscard]] double upper() const noexcept { return best_.value + tolerance_ + noise_; }
    // An eighth of the noise is for the rounding of the parameters.
    [[nodiscard]] double lower() const noexcept { return best_.value - tolerance_ - 0.875 * noise_; }
    // The best place as one in the item; false if it is elsewhere.
    [[nodiscard]] bool best_in(const PatchItem &item, AxisValues &at) const noexcept;
    // Takes a place of an item if it is better; false if not.
    bool improve_to(const PatchItem &item, const AxisValues &at, double distance);
    // A minimum of an item as near as the best one: whether it is one of the spline, and elsewhere.
    void consider(const PatchItem &item, const AxisValues &at, double distance, bool strict);
    // The minima that are as near as the best one to the tolerance, each once, in rising order of distances.
    [[nodiscard]] std::vector<FootCandidate> distinct_minima();

    FootCandidate best_;
    std::vector<FootCandidate> others_;
    bool all_ = false;        // the others are wanted
    bool not_unique_ = false; // points elsewhere are as near
    bool connected_ = false;  // and not isolated
    bool doubtful_ = false;   // a minimum may be none, or missing

private:
    [[nodiscard]] bool same_as_best(const FootCandidate &place) { return same_point(place, best_); }
    void keep(const FootCandidate &before, const FootCandidate &after, bool strict);
    bool is_minimum(const FootCandidate &place);
    [[nodiscard]] bool is_saddle(const FootCandidate &place) const;
};

} // namespace nrb::closest
