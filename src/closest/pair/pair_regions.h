// SPDX-License-Identifier: MIT
// Which pairs of pieces may hold the nearest points of regions.
#pragma once

#include "closest/pair/pair_cells.h"
#include "closest/pair/region.h"
#include "pieces/slopes.h"

#include <vector>

namespace nrb::closest {

// No piece lies outside; and, unless boundaries count, along no axis the distance falls all the way to an end beyond which the
// spline goes on smoothly, so that points inside of both regions can be nearest to each other.
class PairRegions {
public:
    PairRegions(const Spline &a, const Spline &b, const Regions &regions) noexcept
        : splines_{&a, &b}, regions_{regions.a, regions.b}, boundaries_(regions.boundaries) {}

    [[nodiscard]] bool none() const noexcept { return regions_[0] == nullptr && regions_[1] == nullptr; }
    // Whether the places are in their regions.
    [[nodiscard]] bool hold(const pieces::LocalParam &a, const pieces::LocalParam &b) const;
    // Whether a pair does not count. Groups of pieces do.
    [[nodiscard]] bool exclude(PairCell &a, PairCell &b);

private:
    // What is known of a cell, by its mark.
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
