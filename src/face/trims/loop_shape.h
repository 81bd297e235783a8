// SPDX-License-Identifier: MIT
// The signed area of loops in the plane that covers a domain.
#pragma once

#include "face/trims/trim_piece.h"

#include <vector>

namespace nrb::face {

struct LoopShape {
    bool around = false; // it ends in another copy of the domain than it began in, and encloses nothing
    double area = 0;     // signed: positive if the loop runs counterclockwise
    double noise = 0;    // an estimate of the error of the area, by quadrature and rounding
};

// Adds the contribution of a piece to the area of its loop, by the integral of (u - origin) dv. direction:
// whether the loop runs along the piece (1) or against it (-1). All pieces of a loop need the same origin.
void add_area(const TrimPieces &pieces, const TrimPiece &piece, int direction, const Point2 &origin,
              LoopShape &shape);

// The shapes of all loops; a loop whose curves stay at one place has no pieces, and the area 0. Cost: linear
// in the number of pieces.
std::vector<LoopShape> loop_shapes(const TrimPieces &plane, size_t loops, const Covering &covering);

} // namespace nrb::face
