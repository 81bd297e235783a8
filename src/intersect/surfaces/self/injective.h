// SPDX-License-Identifier: MIT
// Rectangles of the domain of a surface on which it is proven to take no point twice.
#pragma once

#include "intersect/surfaces/self/cones.h"

#include <map>

namespace nrb::intersect {

// Places along both axes: the index of a piece plus the place in it, which run on beyond the ends of the domain where the surface
// closes.
using PieceRect = std::array<Interval, 2>;

// Rectangles are proven by the cones of derivatives in them (cones.h); knots, and edges less than folded flat, may be inside. Of
// surfaces that close, or end in one point, to rounding only, all holds but for places that rounding makes one.
class InjectiveParts {
public:
    explicit InjectiveParts(CrossGround &ground);

    // Whether it is proven; of rectangles that reach over many pieces it is not.
    [[nodiscard]] bool is_proven(const PieceRect &rect);
    // Whether the surface jumps nowhere in a rectangle of a few pieces.
    [[nodiscard]] bool is_continuous(const PieceRect &rect) const;
    // Blocks of whole pieces that were proven first: which one a piece is in; -1: none.
    [[nodiscard]] int64_t block_of(const pieces::PieceGrid::Index &index) const;
    // Whether all of the surface is one.
    [[nodiscard]] bool is_all_proven() const;

private:
    // What of a piece a rectangle holds along an axis.
    struct Part {
        int64_t index;
        Interval places;
    };
    struct Pole {
        size_t axis, end; // of the side that is one point
    };
    bool is_proven(const PieceRect &rect, size_t most_parts);
    [[nodiscard]] bool is_injective(const PieceRect &rect, size_t most_parts) const;
    [[nodiscard]] bool is_injective_at_pole(const PieceRect &rect, const Pole &pole, size_t most_parts) const;
    bool set_columns(const std::array<std::vector<Part>, 2> &parts, size_t axis, int sectors,
                     std::vector<std::vector<Tangents>> &columns) const;
    [[nodiscard]] std::vector<Pole> poles_of(const PieceRect &rect) const;
    [[nodiscard]] bool cut(const PieceRect &rect, size_t most_parts,
                           std::array<std::vector<Part>, 2> &parts) const;
    [[nodiscard]] bool is_whole(const std::array<std::vector<Part>, 2> &parts) const;
    // Whether both sides of a break at which the surface may jump are one, as far as a rectangle goes.
    [[nodiscard]] bool is_closed_at(size_t axis, int64_t above, const std::vector<Part> &along) const;
    bool add(const Part &along_u, const Part &along_v, std::vector<Tangents> &parts) const;
    void set_blocks();
    [[nodiscard]] double count(size_t axis) const noexcept {
        return static_cast<double>(ground_.grid.count(static_cast<int>(axis)));
    }

    CrossGround &ground_;
    std::map<std::array<double, 4>, bool> known_;
    std::vector<int64_t> block_; // of pieces
    bool jumps_ = false;         // whether it may do so anywhere
};

} // namespace nrb::intersect
