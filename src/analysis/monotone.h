// SPDX-License-Identifier: MIT
// The pieces of a curve on which it runs one way along a direction.
#pragma once

#include "spline/spline.h"

#include <vector>

namespace nrb::analysis {

struct MonotonePieces {
    struct Piece {
        double start;
        int sign; // of the derivative of direction . C; 0: it vanishes to rounding
    };
    std::vector<Piece> pieces;
    bool complete = true; // no change of direction is hidden by rounding
};

// By the zeros of direction . D, C' = D / w^2; a jump begins a piece of its own. Throws
// Status::not_representable. Precondition: a finite direction.
MonotonePieces monotone_pieces(const Spline &curve, const double *direction);

} // namespace nrb::analysis
