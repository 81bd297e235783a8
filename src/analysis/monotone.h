// SPDX-License-Identifier: MIT
// Divides a curve into pieces that are monotone along a direction.
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
    bool complete = true; // no change of sign is hidden by rounding
};

// The pieces between zeros of direction . D, where C' = D / w^2. A jump begins a new piece. Throws
// Status::not_representable. Precondition: a finite direction.
MonotonePieces monotone_pieces(const Spline &curve, const double *direction);

} // namespace nrb::analysis
