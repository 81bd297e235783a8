// SPDX-License-Identifier: MIT
// The best place that a search has found so far, and its rivals: other places that are as good to the margin.
#pragma once

#include "closest/curve/curve_tree.h"

#include <array>
#include <limits>

namespace nrb::closest {

// A place on a leaf, and the square of its distance from the query point in the units of the tree.
struct CurvePlace {
    int64_t leaf = -1;
    double s = 0; // relative to the leaf's interval, in [0, 1]
    double square = 0;
};

class BestPlaces {
public:
    // sign: 1 for the nearest place, -1 for the farthest one. margin: other places may be better by this
    // much.
    BestPlaces(const CurveTree &tree, double sign, double margin) noexcept
        : tree_(tree), sign_(sign), margin_(margin) {}

    [[nodiscard]] bool found() const noexcept { return best_.leaf >= 0; }
    [[nodiscard]] const CurvePlace &best() const noexcept { return best_; }
    // The distance times the sign; infinite if no place has been found.
    [[nodiscard]] double key() const noexcept { return key_; }
    // A threshold for squared distances: the proof has to show that no point lies below it (for the farthest
    // place: above it).
    [[nodiscard]] double goal() const noexcept { return goal_; }

    void note(const CurvePlace &place) noexcept;
    // False if a rival is as good as the best place, to the margin, and is a different point.
    [[nodiscard]] bool unique() const;

private:
    static constexpr int most_rivals = 16;

    void add_rival(const CurvePlace &place) noexcept {
        rivals_[static_cast<size_t>(rival_count_++ % most_rivals)] = place;
    }

    const CurveTree &tree_;
    double sign_;
    double margin_;
    CurvePlace best_;
    double key_ = std::numeric_limits<double>::infinity();
    double goal_ = 0;
    int rival_count_ = 0;
    std::array<CurvePlace, most_rivals> rivals_;
};

} // namespace nrb::closest
