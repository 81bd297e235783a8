// SPDX-License-Identifier: MIT
// On which side of the loops of a face places of its domain lie.
#pragma once

#include "face/trims/fold.h"
#include "face/trims/loop_shape.h"
#include "face/trims/passed.h"

#include <map>
#include <optional>
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
    [[nodiscard]] const TrimPieces &pieces() const noexcept { return pieces_; }
    // How far, along each axis, rounding may move pieces and places.
    [[nodiscard]] const Point2 &room() const noexcept { return room_; }
    [[nodiscard]] const std::vector<SeamPassage> &passages() const noexcept { return passages_; }
    // What the value below a piece has more than the one above it: 1, or -1 for one that runs to larger x[0].
    [[nodiscard]] int passed(const TrimPiece &piece) const noexcept {
        return (piece.start[0] < piece.end[0]) == turned_[static_cast<size_t>(piece.loop)] ? 1 : -1;
    }
    // The value, 1 inside and 0 outside, at the upper end of a column.
    [[nodiscard]] int value_at_top(double u) const noexcept;
    // Of each loop: whether it was turned.
    [[nodiscard]] const std::vector<bool> &turned() const noexcept { return turned_; }
    // Whether a piece comes into a box of the domain, to rounding.
    [[nodiscard]] bool cuts(const Point2 &lower, const Point2 &upper) const {
        return any_in(lower, upper,
                      [&](const TrimPiece &piece) { return pieces_.meets(piece, lower, upper); });
    }
    // Calls visit(piece) for the pieces whose boxes meet a box of the domain, some of them more than once, until it is true.
    template <class Visit>
    bool any_in(const Point2 &lower, const Point2 &upper, Visit &&visit) const {
        for (size_t b = bucket(lower[0]); b <= bucket(upper[0]); ++b) {
            for (size_t i = starts_[b]; i < starts_[b + 1]; ++i) {
                const Item &item = items_[i];
                const bool apart = item.lower[0] > upper[0] || item.upper[0] < lower[0] ||
                                   item.lower[1] > upper[1] || item.upper[1] < lower[1];
                if (!apart && visit(pieces_.all()[item.piece])) {
                    return true;
                }
            }
        }
        return false;
    }

private:
    struct Item {
        Point2 lower, upper;
        uint32_t piece;
        int32_t passed; // what passing it upwards adds: -1 for a piece that runs to larger x[0]
    };

    void fill_buckets();
    void set_room() noexcept;
    [[nodiscard]] size_t bucket(double u) const noexcept;
    template <class Add>
    bool walk(const Point2 &x, size_t except, Add &&add) const;
    // None outside of the domain. on: becomes true if x lies on a curve, to rounding.
    [[nodiscard]] std::optional<int> sum(const Point2 &x, bool &on) const noexcept;
    [[nodiscard]] std::optional<PassedSums> sums(const Point2 &x, size_t except) const;
    [[nodiscard]] std::optional<PassedSums> sums_away_from_others(const Point2 &x, size_t except,
                                                                  size_t k) const;
    // What is passed from the left side of a loop on, at some place of it; none if it lies on others everywhere.
    [[nodiscard]] std::optional<PassedSums> sums_left_of(int32_t loop) const;
    [[nodiscard]] std::optional<PassedSums> sums_left_of(size_t i, size_t k, double share) const;
    // Of a loop, those that are upright (k = 1) or not (k = 0), the longest along axis k first.
    [[nodiscard]] std::vector<size_t> longest_pieces(int32_t loop, size_t k) const;
    void orient(const std::vector<LoopShape> &loops, bool turn, bool astray);
    // What is passed from the left side of each loop on; none of those that lie on others. Throws Status::orientation if those are
    // more than a face can have.
    [[nodiscard]] std::vector<std::optional<PassedSums>>
    checked_sums(const std::vector<LoopShape> &loops) const;
    void turn_loops(std::vector<LoopShape> loops, const std::vector<std::optional<PassedSums>> &found);
    void set_corner(const std::vector<LoopShape> &loops, bool astray);
    [[noreturn]] void fail_astray() const;
    // Columns through loops, and through the widest parts of the domain between ends of pieces.
    [[nodiscard]] std::vector<double> probe_columns() const;
    // Over how much of a column each value holds.
    using Heights = std::map<int, double>;
    void add_column(double u, Heights &heights) const;
    [[nodiscard]] bool mostly_inside(const std::vector<LoopShape> &loops) const;

    TrimPieces pieces_;
    std::vector<SeamPassage> passages_;
    const Covering *covering_;
    std::vector<Item> items_;
    std::vector<size_t> starts_;
    double columns_ = 0;
    Point2 room_{0, 0};
    std::vector<bool> turned_;
    int corner_ = 1; // the value at the corner
};

} // namespace nrb::face
