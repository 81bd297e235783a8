// SPDX-License-Identifier: MIT
// A bounding volume hierarchy over the pieces of a surface or of a curve, which excludes pairs of groups of
// pieces that have no feet.
#pragma once

#include "intersect/projection/feet/feet_cell.h"

#include <deque>
#include <vector>

namespace nrb::intersect {

using RangesInSpace = std::array<Interval, 3>;

// The pieces with indices [first, last) along both axes; a curve has axis 0 alone.
struct FeetGroup {
    std::array<int64_t, 2> first{}, last{};
    RangesInSpace points{};                  // infinite if weights of a piece may not be positive
    std::array<RangesInSpace, 2> tangents{}; // of the T_k of a surface (FeetNet); infinite: not known
    // Bounds of the derivatives of points by parameters, over the pieces whose weights are certainly
    // positive.
    std::array<double, 2> speeds{};
    std::array<int64_t, 2> halves{-1, -1};
    FeetCell *cell = nullptr; // of a group of one piece; made on demand

    [[nodiscard]] bool is_piece() const noexcept { return halves[0] < 0; }
    [[nodiscard]] int64_t pieces() const noexcept { return (last[0] - first[0]) * (last[1] - first[1]); }
};

// A binary tree of groups, from all pieces at the root to single pieces at the leaves.
class FeetGroups {
public:
    // Of a surface.
    explicit FeetGroups(CrossGround &ground);
    // Of a curve. lines: the ground of distance_lines() of the curve.
    FeetGroups(CrossGround &lines, const Spline &curve, const pieces::Frame &frame);

    [[nodiscard]] FeetGroup &root() noexcept { return groups_.back(); }
    [[nodiscard]] FeetGroup &half(const FeetGroup &of, size_t end) noexcept {
        return groups_[static_cast<size_t>(of.halves[end])];
    }
    // The cell that covers the piece of a group of one piece; null if its weights are not certainly positive,
    // or a tangent T_k vanishes identically.
    FeetCell *cell(FeetGroup &group);
    [[nodiscard]] std::deque<FeetCell> &cells() noexcept { return cells_; }
    [[nodiscard]] const pieces::PieceGrid &grid() const noexcept { return ground_.grid; }

private:
    int64_t add(const std::array<int64_t, 2> &first, const std::array<int64_t, 2> &last);
    void set_piece(FeetGroup &group);
    [[nodiscard]] const pieces::BezierPiece *numbers_of(const FeetGroup &group);

    CrossGround &ground_;
    bool of_curve_;
    std::vector<pieces::BezierPiece> curve_; // the pieces of the curve, if it is one
    std::vector<FeetGroup> groups_;
    std::deque<FeetNet> nets_;
    std::deque<FeetCell> cells_;
};

// Whether F_0 or F_1 (FeetNet) has no zero for points and tangents in the boxes of the groups.
bool have_no_feet(const FeetGroup &surface, const FeetGroup &curve);

} // namespace nrb::intersect
