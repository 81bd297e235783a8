// SPDX-License-Identifier: MIT
// The pieces that lie in the columns of a domain, and how rays upwards cross them.
#pragma once

#include "face/trims/fold.h"
#include "face/trims/passed.h"

#include <limits>
#include <optional>
#include <vector>

namespace nrb::face {

// Finds pieces by their columns, the vertical lines of the domain, and sums up the crossings of rays. A ray
// that crosses a piece upwards adds 1 or -1, depending on the direction of the piece: the value below a piece
// that runs to larger x[0] is 1 less than the value above it.
class PieceColumns {
public:
    static constexpr size_t none = std::numeric_limits<size_t>::max();

    PieceColumns(FoldedPieces folded, const Covering &covering);

    [[nodiscard]] const TrimPieces &pieces() const noexcept { return pieces_; }
    [[nodiscard]] const std::vector<SeamPassage> &passages() const noexcept { return passages_; }
    // How far, along each axis, rounding may move pieces and places.
    [[nodiscard]] const Point2 &room() const noexcept { return room_; }
    static int passed(const TrimPiece &piece) noexcept { return piece.start[0] < piece.end[0] ? -1 : 1; }

    // Calls visit(piece) for the pieces whose boxes meet a box of the domain, until it returns true. Some
    // pieces are visited more than once.
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
    // Calls visit(piece) for the pieces in a column; where pieces end in the column, for those to its right.
    template <class Visit>
    void in_column(double u, Visit &&visit) const {
        const size_t b = bucket(u);
        for (size_t i = starts_[b]; i < starts_[b + 1]; ++i) {
            if (items_[i].lower[0] <= u && u < items_[i].upper[0]) {
                visit(pieces_.all()[items_[i].piece]);
            }
        }
    }
    // Follows the ray from x up and on to the corner at which both axes end, and calls add(loop, passed) for
    // each crossing. Returns whether x lies on a piece, to rounding. except: a piece that is left out. A
    // piece lies in the columns from its left end, included, to its right end, excluded: where a piece
    // continues another one, a column through their common end crosses only one of the two.
    template <class Add>
    bool walk(const Point2 &x, size_t except, Add &&add) const {
        bool on = false;
        const size_t b = bucket(x[0]);
        for (size_t i = starts_[b]; i < starts_[b + 1]; ++i) {
            const Item &item = items_[i];
            if (x[1] > item.upper[1] || x[0] < item.lower[0] || x[0] > item.upper[0] ||
                item.piece == except) {
                continue;
            }
            const TrimPiece &piece = pieces_.all()[item.piece];
            int side = 1;
            if (x[1] >= item.lower[1]) {
                side = pieces_.side(piece, x);
                on = on || side == 0;
            }
            if (side > 0 && x[0] < item.upper[0]) {
                add(piece.loop, item.passed);
            }
        }
        for (const SeamPassage &passage : passages_) {
            if (passage.at > x[0]) {
                add(passage.loop, passage.upwards);
            }
        }
        return on;
    }
    // The crossings of the ray from the left side of a loop, at some place of the loop; none if all places
    // that are tried lie on other loops.
    [[nodiscard]] std::optional<PassedSums> sums_left_of(int32_t loop) const;

private:
    struct Item {
        Point2 lower, upper;
        uint32_t piece;
        int32_t passed; // what crossing it upwards adds: -1 for a piece that runs to larger x[0]
    };

    void fill_buckets();
    void set_room() noexcept;
    [[nodiscard]] size_t bucket(double u) const noexcept;
    [[nodiscard]] std::optional<PassedSums> sums(const Point2 &x, size_t except) const;
    [[nodiscard]] std::optional<PassedSums> sums_away_from_others(const Point2 &x, size_t except,
                                                                  size_t k) const;
    [[nodiscard]] std::optional<PassedSums> sums_left_of(size_t i, size_t k, double share) const;
    // The pieces of a loop that are vertical (k = 1) or not (k = 0), the longest along axis k first.
    [[nodiscard]] std::vector<size_t> longest_pieces(int32_t loop, size_t k) const;

    TrimPieces pieces_;
    std::vector<SeamPassage> passages_;
    const Covering *covering_;
    std::vector<Item> items_;
    std::vector<size_t> starts_;
    double columns_ = 0;
    Point2 room_{0, 0};
};

} // namespace nrb::face
