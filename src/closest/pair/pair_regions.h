// SPDX-License-Identifier: MIT
// Excludes pairs of pieces that cannot hold the nearest points of two regions.
#pragma once

#include "closest/pair/pair_cells.h"
#include "closest/pair/region.h"
#include "pieces/slopes.h"

#include <vector>

namespace nrb::closest {

// A pair is excluded if one of the pieces lies outside its region. Unless points on boundaries count, it is
// also excluded if along some axis the distance decreases all the way to an end of a piece beyond which the
// spline goes on smoothly: the nearest points then are not inside both regions within this pair.
class PairRegions {
public:
    PairRegions(const Spline &a, const Spline &b, const Regions &regions) noexcept
        : splines_{&a, &b}, regions_{regions.a, regions.b}, boundaries_(regions.boundaries) {}

    [[nodiscard]] bool none() const noexcept { return regions_[0] == nullptr && regions_[1] == nullptr; }
    // Whether both places are in their regions.
    [[nodiscard]] bool hold(const pieces::LocalParam &a, const pieces::LocalParam &b) const;
    // Whether a pair does not count. Cells that are groups of pieces are never excluded.
    [[nodiscard]] bool exclude(PairCell &a, PairCell &b);

private:
    // What is known of a cell; cell.mark - 1 is its index.
    struct Known {
        int side;
        std::array<std::optional<pieces::Slopes>, max_axes> along{};
    };
    [[nodiscard]] Known &known(size_t which, PairCell &cell);
    [[nodiscard]] int side(size_t which, const pieces::BezierPiece &piece) const;
    [[nodiscard]] bool falls_away(size_t which, PairCell &cell, const PairCell &other);

    std::array<const Spline *, 2> splines_;
    std::array<const Region *, 2> regions_;
    bool boundaries_;
    std::vector<Known> known_;
};

} // namespace nrb::closest
