// SPDX-License-Identifier: MIT
// Rectangles of the domain on which a surface is proven to be injective.
#pragma once

#include "intersect/surfaces/self/cones.h"

#include <map>

namespace nrb::intersect {

// A rectangle of the domain, in units of pieces: the index of a piece plus the place in [0, 1] in it. It may
// reach beyond the ends of the domain where the surface closes.
using PieceRect = std::array<Interval, 2>;

// Rectangles are proven by the cones of their derivatives (cones.h). They may contain knots, and creases that
// are not folded flat. Where a surface closes, or has a pole, only to rounding, it is injective except
// for places whose points coincide to rounding.
class InjectiveParts {
public:
    explicit InjectiveParts(CrossGround &ground);

    // Whether the surface is proven injective on a rectangle. False for rectangles over many pieces.
    [[nodiscard]] bool is_proven(const PieceRect &rect);
    // Whether the surface is continuous on a rectangle. False if it has jumps somewhere and the rectangle
    // many pieces.
    [[nodiscard]] bool is_continuous(const PieceRect &rect) const;
    // Blocks are rectangles of whole pieces that the constructor proves. The number of that of a piece; -1:
    // none.
    [[nodiscard]] int64_t block_of(const pieces::PieceGrid::Index &index) const;
    // Whether the whole surface is one block.
    [[nodiscard]] bool is_all_proven() const;

private:
    // The interval of a piece that is in a rectangle, along one axis.
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
    // Whether the surface is continuous, to rounding, over a knot at which it may jump, between the pieces
    // with indices above - 1 and above, along the parts `along`.
    [[nodiscard]] bool is_closed_at(size_t axis, int64_t above, const std::vector<Part> &along) const;
    bool add(const Part &along_u, const Part &along_v, std::vector<Tangents> &parts) const;
    void set_blocks();
    [[nodiscard]] double count(size_t axis) const noexcept {
        return static_cast<double>(ground_.grid.count(static_cast<int>(axis)));
    }

    CrossGround &ground_;
    std::map<std::array<double, 4>, bool> known_;
    std::vector<int64_t> block_; // of each piece
    bool jumps_ = false;         // whether the surface may jump anywhere
};

} // namespace nrb::intersect
