// SPDX-License-Identifier: MIT
// On which side of the loops of a face the places of its domain lie.
#pragma once

#include "face/trims/loop_shape.h"
#include "face/trims/piece_columns.h"

#include <map>
#include <optional>
#include <utility>
#include <vector>

namespace nrb::face {

// The winding number of the loops around places of the domain, by ray crossings. The ray of a place leads up
// along its column, the vertical line through it, to the upper end of axis 1, and along that end to the
// corner at which both axes end. If axis 1 is closed, its upper end is a seam, which loops may cross, too.
// Each piece that the ray crosses adds 1 or -1, depending on its direction. The value at a place is the value
// at the corner plus this sum: 1 inside, 0 outside. This also holds for loops that run around a closed axis,
// and no loop has to be known as the outer one. Pieces are found by their columns.
class TrimMap {
public:
    // Finds the value at the corner with which all values are 1 or 0, except in slivers. Throws
    // Status::orientation if there is none, as far as a set of sample columns shows, and for loops that
    // enclose nothing or lie on others. With `turn`, loops that do not run around an axis are turned where
    // that is needed; with `astray`, other values than 1 and 0 are accepted.
    TrimMap(FoldedPieces folded, const Covering &covering, const std::vector<LoopShape> &loops, bool turn,
            bool astray = false);

    // 1 inside, 0 on a curve to rounding, -1 outside.
    [[nodiscard]] int side(const Point2 &x) const noexcept;
    // The value at a place. It differs from 1 and 0 only where loops cross, or contain each other as those of
    // no face do. None outside of the domain, and on a curve to rounding.
    [[nodiscard]] std::optional<int> value(const Point2 &x) const noexcept;
    [[nodiscard]] const TrimPieces &pieces() const noexcept { return columns_.pieces(); }
    // How far, along each axis, rounding may move pieces and places.
    [[nodiscard]] const Point2 &room() const noexcept { return columns_.room(); }
    [[nodiscard]] const std::vector<SeamPassage> &passages() const noexcept { return columns_.passages(); }
    // What a ray adds that crosses a piece upwards: the value below the piece less the value above it. It is
    // 1, or -1 for a piece that runs to larger x[0], in the direction that its loop has after turning.
    [[nodiscard]] int passed(const TrimPiece &piece) const noexcept {
        const int own = PieceColumns::passed(piece);
        return turned_[static_cast<size_t>(piece.loop)] ? -own : own;
    }
    // The value, 1 inside and 0 outside, at the upper end of a column.
    [[nodiscard]] int value_at_top(double u) const noexcept;
    // Of each loop: whether it was turned.
    [[nodiscard]] const std::vector<bool> &turned() const noexcept { return turned_; }
    // The intervals between the pieces in a column, from its upper end to its lower end, each with its value.
    struct ColumnPart {
        Interval v;
        int value;
    };
    [[nodiscard]] std::vector<ColumnPart> parts_of_column(double u) const;
    // Whether a piece enters a box of the domain, to rounding.
    [[nodiscard]] bool cuts(const Point2 &lower, const Point2 &upper) const {
        return any_in(lower, upper,
                      [&](const TrimPiece &piece) { return pieces().meets(piece, lower, upper); });
    }
    // Calls visit(piece) for the pieces in a column; where pieces end in the column, for those to its right.
    template <class Visit>
    void in_column(double u, Visit &&visit) const {
        columns_.in_column(u, std::forward<Visit>(visit));
    }
    // Calls visit(piece) for the pieces whose boxes meet a box of the domain, until it returns true. Some
    // pieces are visited more than once.
    template <class Visit>
    bool any_in(const Point2 &lower, const Point2 &upper, Visit &&visit) const {
        return columns_.any_in(lower, upper, std::forward<Visit>(visit));
    }

private:
    // The value at x; none outside of the domain. on: set to true if x lies on a curve, to rounding.
    [[nodiscard]] std::optional<int> sum(const Point2 &x, bool &on) const noexcept;
    void orient(const std::vector<LoopShape> &loops, bool turn, bool astray);
    // For each loop, the crossings of the ray from its left side; none for a loop that lies on others. Throws
    // Status::orientation if more loops lie on others than a face can have.
    [[nodiscard]] std::vector<std::optional<PassedSums>>
    checked_sums(const std::vector<LoopShape> &loops) const;
    void turn_loops(std::vector<LoopShape> loops, const std::vector<std::optional<PassedSums>> &found);
    void set_corner(const std::vector<LoopShape> &loops, bool astray);
    [[nodiscard]] bool is_told_by_around(const std::vector<LoopShape> &loops) const;
    [[noreturn]] void fail_astray() const;
    // Columns through loops, and through the widest intervals of axis 0 in which no piece begins or ends.
    [[nodiscard]] std::vector<double> probe_columns() const;
    // For each value, over how much of the columns it holds.
    using Heights = std::map<int, double>;
    void add_column(double u, Heights &heights) const;
    [[nodiscard]] bool mostly_inside(const std::vector<LoopShape> &loops) const;

    PieceColumns columns_;
    const Covering *covering_;
    std::vector<bool> turned_;
    int corner_ = 1; // the value at the corner
};

} // namespace nrb::face
