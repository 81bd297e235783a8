// SPDX-License-Identifier: MIT
// Brings pieces in the plane that covers a domain back into the domain.
#pragma once

#include "face/trims/trim_piece.h"

#include <vector>

namespace nrb::face {

// A crossing of a loop with the seam of axis 1, the upper end of its domain.
struct SeamPassage {
    double at;   // on axis 0
    int upwards; // 1, or -1 for a curve that comes back down
    int32_t loop;
};

struct FoldedPieces {
    TrimPieces pieces;
    std::vector<SeamPassage> passages; // of loops on surfaces whose axis 1 is closed
};

// On closed axes, cuts pieces where they run from one copy of the domain into the next one. Precondition: the
// pieces of a loop are consecutive.
FoldedPieces fold(const TrimPieces &plane, const Covering &covering);
// The same for chains, which need not come back to where they began.
FoldedPieces fold_chains(const TrimPieces &plane, const Covering &covering);

} // namespace nrb::face
