// SPDX-License-Identifier: MIT
// The best place of a search and its rivals.
#pragma once

#include "closest/curve/curve_tree.h"

#include <array>
#include <limits>

namespace nrb::closest {

// A place on a leaf, and the square of its distance in the units of the tree.
struct CurvePlace {
    int64_t leaf = -1;
    double s = 0; // of the leaf's interval
    double square = 0;
};

class BestPlaces {
public:
    // sign: 1 for the nearest place, -1 for the farthest one. margin: by how much others may be better.
    BestPlaces(const CurveTree &tree, double sign, double margin) noexcept
        : tree_(tree), sign_(sign), margin_(margin) {}

    [[nodiscard]] bool found() const noexcept { return best_.leaf >= 0; }
    [[nodiscard]] const CurvePlace &best() const noexcept { return best_; }
    // The distance with the sign; infinite if there is none yet.
    [[nodiscard]] double key() const noexcept { return key_; }
    // The square of the distance below which (for the farthest place: above which) the proof must show that
    // no point lies.
    [[nodiscard]] double goal() const noexcept { return goal_; }

    void note(const CurvePlace &place) noexcept;
    // Whether no rival is both as good as the best place, to the margin, and a different point.
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
