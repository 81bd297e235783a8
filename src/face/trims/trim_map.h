// SPDX-License-Identifier: MIT
// On which side of the loops of a face places of its domain lie.
#pragma once

#include "face/trims/loop_shape.h"
#include "face/trims/piece_columns.h"

#include <map>
#include <optional>
#include <utility>
#include <vector>

namespace nrb::face {

// Along a column of the domain, upwards from a place, each piece that is passed says by its direction from which side of its
// loop it is passed; from the end of the column the way goes along the seam of axis 1, if there is one, to the corner where both
// axes end. So the sum of what was passed, and the value at the corner, is 1 inside and 0 outside, also where loops run around a
// closed axis, and there is no first loop. Pieces are found by their columns.
class TrimMap {
public:
    // The value at the corner is that for which places are 1 or 0, but for slivers. Throws Status::orientation if there is none, as
    // far as columns through the first loops and between them tell. With `turn` loops that do not run around an axis are turned where that is needed;
    // with `astray` the value need not be 1 or 0 anywhere.
    TrimMap(FoldedPieces folded, const Covering &covering, const std::vector<LoopShape> &loops, bool turn,
            bool astray = false);

    // 1 inside, 0 on a curve to rounding, -1 outside.
    [[nodiscard]] int side(const Point2 &x) const noexcept;
    // The sum at a place: other than 1 and 0 only where loops cross or lie in each other as those of no face. None outside of the
    // domain, and on a curve to rounding.
    [[nodiscard]] std::optional<int> value(const Point2 &x) const noexcept;
    [[nodiscard]] const TrimPieces &pieces() const noexcept { return columns_.pieces(); }
    // How far, along each axis, rounding may move pieces and places.
    [[nodiscard]] const Point2 &room() const noexcept { return columns_.room(); }
    [[nodiscard]] const std::vector<SeamPassage> &passages() const noexcept { return columns_.passages(); }
    // What the value below a piece has more than the one above it: 1, or -1 for one that runs to larger x[0].
    [[nodiscard]] int passed(const TrimPiece &piece) const noexcept {
        const int own = PieceColumns::passed(piece);
        return turned_[static_cast<size_t>(piece.loop)] ? -own : own;
    }
    // The value, 1 inside and 0 outside, at the upper end of a column.
    [[nodiscard]] int value_at_top(double u) const noexcept;
    // Of each loop: whether it was turned.
    [[nodiscard]] const std::vector<bool> &turned() const noexcept { return turned_; }
    // What lies between the pieces in a column, from its upper end to its lower one, with the value there.
    struct ColumnPart {
        Interval v;
        int value;
    };
    [[nodiscard]] std::vector<ColumnPart> parts_of_column(double u) const;
    // Whether a piece comes into a box of the domain, to rounding.
    [[nodiscard]] bool cuts(const Point2 &lower, const Point2 &upper) const {
        return any_in(lower, upper,
                      [&](const TrimPiece &piece) { return pieces().meets(piece, lower, upper); });
    }
    // Calls visit(piece) for the pieces that a column meets, to the right of it where it passes an end.
    template <class Visit>
    void in_column(double u, Visit &&visit) const {
        columns_.in_column(u, std::forward<Visit>(visit));
    }
    // Calls visit(piece) for the pieces whose boxes meet a box of the domain, some of them more than once, until it is true.
    template <class Visit>
    bool any_in(const Point2 &lower, const Point2 &upper, Visit &&visit) const {
        return columns_.any_in(lower, upper, std::forward<Visit>(visit));
    }

private:
    // None outside of the domain. on: becomes true if x lies on a curve, to rounding.
    [[nodiscard]] std::optional<int> sum(const Point2 &x, bool &on) const noexcept;
    void orient(const std::vector<LoopShape> &loops, bool turn, bool astray);
    // What is passed from the left side of each loop on; none of those that lie on others. Throws Status::orientation if those are
    // more than a face can have.
    [[nodiscard]] std::vector<std::optional<PassedSums>>
    checked_sums(const std::vector<LoopShape> &loops) const;
    void turn_loops(std::vector<LoopShape> loops, const std::vector<std::optional<PassedSums>> &found);
    void set_corner(const std::vector<LoopShape> &loops, bool astray);
    [[nodiscard]] bool is_told_by_around(const std::vector<LoopShape> &loops) const;
    [[noreturn]] void fail_astray() const;
    // Columns through loops, and through the widest parts of the domain between ends of pieces.
    [[nodiscard]] std::vector<double> probe_columns() const;
    // Over how much of a column each value holds.
    using Heights = std::map<int, double>;
    void add_column(double u, Heights &heights) const;
    [[nodiscard]] bool mostly_inside(const std::vector<LoopShape> &loops) const;

    PieceColumns columns_;
    const Covering *covering_;
    std::vector<bool> turned_;
    int corner_ = 1; // the value at the corner
};

} // namespace nrb::face
