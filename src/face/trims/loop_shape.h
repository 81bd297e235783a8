// SPDX-License-Identifier: MIT
// What a loop encloses in the plane that covers a domain.
#pragma once

#include "face/trims/trim_piece.h"

#include <vector>

namespace nrb::face {

struct LoopShape {
    bool around = false; // it ends in another copy of the domain than it began in, and encloses nothing
    double area = 0;     // to the left: positive if it runs counterclockwise
    double noise = 0;    // of the area, by the rounding of its terms and of the pieces
};

// Adds what a piece, run over forwards (1) or backwards (-1), contributes to the area of its loop, seen from one place for all
// of the pieces.
void add_area(const TrimPieces &pieces, const TrimPiece &piece, int direction, const Point2 &origin,
              LoopShape &shape);

// Of all loops; those that stand still at one place have no area. Cost: linear in the number of pieces.
std::vector<LoopShape> loop_shapes(const TrimPieces &plane, size_t loops, const Covering &covering);

} // namespace nrb::face
