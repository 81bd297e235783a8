// SPDX-License-Identifier: MIT
// The pieces of a surface and of a curve in groups, with what tells that they have no feet of each other.
#pragma once

#include "intersect/projection/feet/feet_cell.h"

#include <deque>
#include <vector>

namespace nrb::intersect {

using RangesInSpace = std::array<Interval, 3>;

// Pieces with indices [first, last) along both axes, of a curve along axis 0.
struct FeetGroup {
    std::array<int64_t, 2> first{}, last{};
    RangesInSpace points{};                  // infinite: weights of a piece have no certain sign
    std::array<RangesInSpace, 2> tangents{}; // T_k of a surface
    std::array<double, 2> speeds{};          // the largest derivatives of points, by parameters
    std::array<int64_t, 2> halves{-1, -1};
    FeetCell *cell = nullptr; // of a group of one piece, when it was asked for

    [[nodiscard]] bool is_piece() const noexcept { return halves[0] < 0; }
    [[nodiscard]] int64_t pieces() const noexcept { return (last[0] - first[0]) * (last[1] - first[1]); }
};

// Halves of halves, from all pieces down to each.
class FeetGroups {
public:
    // A surface.
    explicit FeetGroups(CrossGround &ground);
    // A curve, with the ground of lines through its points.
    FeetGroups(CrossGround &lines, const Spline &curve, const pieces::Frame &frame);

    [[nodiscard]] FeetGroup &root() noexcept { return groups_.back(); }
    [[nodiscard]] FeetGroup &half(const FeetGroup &of, size_t end) noexcept {
        return groups_[static_cast<size_t>(of.halves[end])];
    }
    // All of the piece of a group of one; null: nothing is known of it.
    FeetCell *cell(FeetGroup &group);
    [[nodiscard]] std::deque<FeetCell> &cells() noexcept { return cells_; }
    [[nodiscard]] const pieces::PieceGrid &grid() const noexcept { return ground_.grid; }

private:
    int64_t add(const std::array<int64_t, 2> &first, const std::array<int64_t, 2> &last);
    void set_piece(FeetGroup &group);
    [[nodiscard]] const pieces::BezierPiece *numbers_of(const FeetGroup &group);

    CrossGround &ground_;
    bool of_curve_;
    std::vector<pieces::BezierPiece> curve_; // its pieces
    std::vector<FeetGroup> groups_;
    std::deque<FeetNet> nets_;
    std::deque<FeetCell> cells_;
};

// Whether F_0 or F_1 is nowhere 0 for points and tangents in these boxes.
bool have_no_feet(const FeetGroup &surface, const FeetGroup &curve);

} // namespace nrb::intersect
