// SPDX-License-Identifier: MIT
// The best place that a search has found, and the other minima that are as near.
#pragma once

#include "closest/patch/patch_query.h"

#include <vector>

namespace nrb::closest {

class PatchMinima : public PatchQuery {
protected:
    PatchMinima(const PieceGrid &pieces, const Query &query) : PatchQuery(pieces, query) {}

    // A value above this is worse than the best one by more than counts.
    [[nodiscard]] double upper() const noexcept { return best_.value + tolerance_ + noise_; }
    // A value below this is better than the best one by more than counts. An eighth of the noise is reserved
    // for the rounding of the parameters.
    [[nodiscard]] double lower() const noexcept { return best_.value - tolerance_ - 0.875 * noise_; }
    // The best place in the coordinates of the item; false if it is not in the item.
    [[nodiscard]] bool best_in(const PatchItem &item, AxisValues &at) const noexcept;
    // Makes a place of an item the best one if it is better; otherwise returns false.
    bool improve_to(const PatchItem &item, const AxisValues &at, double distance);
    // Considers a minimum of an item that is as near as the best one: records it if it is a minimum of the
    // whole spline and is another point than the best one.
    void consider(const PatchItem &item, const AxisValues &at, double distance, bool strict);
    // The minima that are as near as the best one to the tolerance, each once, in increasing order of
    // distance.
    [[nodiscard]] std::vector<FootCandidate> distinct_minima();

    FootCandidate best_;
    std::vector<FootCandidate> others_;
    bool all_ = false;        // all minima are wanted, not only the best one
    bool not_unique_ = false; // other points are as near
    bool connected_ = false;  // the points that are as near are not isolated
    bool doubtful_ = false;   // a recorded minimum may be none, or one may be missing

private:
    [[nodiscard]] bool same_as_best(const FootCandidate &place) { return same_point(place, best_); }
    void keep(const FootCandidate &before, const FootCandidate &after, bool strict);
    bool is_minimum(const FootCandidate &place);
    [[nodiscard]] bool is_saddle(const FootCandidate &place) const;
};

} // namespace nrb::closest
