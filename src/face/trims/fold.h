// SPDX-License-Identifier: MIT
// Pieces in the plane that covers a domain, brought back into the domain.
#pragma once

#include "face/trims/trim_piece.h"

#include <vector>

namespace nrb::face {

// Where loops pass the seam of axis 1, the upper end of its domain.
struct SeamPassage {
    double at;   // on axis 0
    int upwards; // 1, or -1 for a curve that comes back
    int32_t loop;
};

struct FoldedPieces {
    TrimPieces pieces;
    std::vector<SeamPassage> passages; // of loops on surfaces whose axis 1 is closed
};

// On closed axes pieces are cut where they pass from one copy of the domain to the next. The pieces of a loop have to follow one
// another.
FoldedPieces fold(const TrimPieces &plane, const Covering &covering);
// The same of chains, which need not come back to where they began.
FoldedPieces fold_chains(const TrimPieces &plane, const Covering &covering);

} // namespace nrb::face
