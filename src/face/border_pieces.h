// SPDX-License-Identifier: MIT
// The border of a face as curves, to be intersected with other curves in its domain.
#pragma once

#include "face/face.h"

#include <array>
#include <map>
#include <set>
#include <utility>
#include <vector>

namespace nrb::face {

// A place on the border of a face: a parameter of a curve of a loop.
struct BorderPlace {
    int32_t loop = 0, index = 0;
    double param = 0;
};

// The pieces of the border as curves, moved by periods of the domain. Each curve is made once.
class BorderPieces {
public:
    explicit BorderPieces(const Face &face) : face_(face) {}

    // Curves in the domain, in Covering::units(), that are within this distance of a piece count as being on it:
    // curves on faces are no more exact than that.
    [[nodiscard]] double room() const noexcept;
    // Calls visit(own, curve, piece) for the pieces that come near a curve in the plane that covers the domain,
    // with the curve and the piece in Covering::units(), the piece over [0, 1] and moved by periods to the curve.
    template <class Visit>
    void visit_near(const Spline &curve, Visit &&visit) {
        const SplinePtr own = scaled_copy(curve, face_.covering().units(), {0, 0});
        for (const auto &[piece, turns] : near(curve)) {
            visit(*own, *moved_piece(piece, turns), *piece);
        }
    }
    // The place in the loops of the face at a place of a piece.
    [[nodiscard]] BorderPlace place_of(const TrimPiece &piece, double at) const;
    // Which part, from 0 to 1, a piece is of the segment behind a curve, which is cut where it passes into
    // another copy of the domain. Precondition: a piece of the face.
    [[nodiscard]] Interval part_behind(const TrimPiece &piece) const;
    // Whether the loop was turned, so that it now runs against the piece.
    [[nodiscard]] bool is_turned(const TrimPiece &piece) const;
    // The place on the border near x, if there is one within a few times the distance by which curves may
    // leave the domain; else empty.
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
