// SPDX-License-Identifier: MIT
// The border of a face as curves, for those that come near it.
#pragma once

#include "face/face.h"

#include <array>
#include <map>
#include <set>
#include <utility>
#include <vector>

namespace nrb::face {

// On a curve of a loop of a face.
struct BorderPlace {
    int32_t loop = 0, index = 0;
    double param = 0;
};

// Pieces of the border as curves, moved by periods of the domain; each is made once.
class BorderPieces {
public:
    explicit BorderPieces(const Face &face) : face_(face) {}

    // How near to the pieces is on them, in the domain: curves on faces are no more exact than that.
    [[nodiscard]] double room() const noexcept;
    // Calls visit(curve, piece) for the pieces, as curves over [0, 1] that are moved to where they are near a curve in the plane
    // that covers the domain.
    template <class Visit>
    void visit_near(const Spline &curve, Visit &&visit) {
        for (const auto &[piece, turns] : near(curve)) {
            visit(*moved_piece(piece, turns), *piece);
        }
    }
    // Of a place on a piece, in the loops of the face.
    [[nodiscard]] BorderPlace place_of(const TrimPiece &piece, double at) const;
    // Which part, from 0 to 1, a piece is of the segment behind a curve, which is cut where it passes into
    // another copy of the domain. Precondition: a piece of the face.
    [[nodiscard]] Interval part_behind(const TrimPiece &piece) const;
    // Whether the loop runs against the piece.
    [[nodiscard]] bool is_turned(const TrimPiece &piece) const;
    // The nearest place of those no farther off than curves may leave the domain.
    [[nodiscard]] std::vector<BorderPlace> nearest_to(const Point2 &x) const;

private:
    using Turns = std::array<int, 2>;
    using Key = std::pair<const TrimPiece *, Turns>;

    [[nodiscard]] double place_near(const TrimPiece &piece, const Point2 &x) const;
    [[nodiscard]] std::set<Key> near(const Spline &curve) const;
    void add_in(const Point2 &lower, const Point2 &upper, std::set<Key> &found) const;
    [[nodiscard]] std::array<int, 2> turns_of(int k, double lower, double upper) const noexcept;
    const SplinePtr &moved_piece(const TrimPiece *piece, const Turns &turns);

    const Face &face_;
    std::map<Key, SplinePtr> curves_;
};

} // namespace nrb::face
