// SPDX-License-Identifier: MIT
// Arcs of a curve that stay near a place, for certain.
#pragma once

#include "pieces/tree/framed_pieces.h"

#include <span>

namespace nrb::intersect {

class NearArcs {
public:
    explicit NearArcs(const Spline &curve);

    // Whether the control points of its parts prove that the arc between two parameters, which on a periodic
    // curve may lie in any period, stays within a distance of a point. Precondition: arc.lower <= arc.upper.
    [[nodiscard]] bool hold(Interval arc, std::span<const double> point, double distance) const;

private:
    // In the frame of the pieces.
    struct Ball {
        std::vector<double> centre;
        double radius;
    };
    // The control points come nearer to the curve by a factor of 4 with each.
    static constexpr int most_halvings = 20;

    [[nodiscard]] bool holds_part(Interval part, const Ball &ball) const;
    static bool holds_piece(pieces::BezierPiece piece, const Ball &ball, int halvings);

    const Spline &curve_;
    const pieces::PieceTree &tree_;
    pieces::FramedPieces pieces_;
};

} // namespace nrb::intersect
