// SPDX-License-Identifier: MIT
// Lines along which a domain that closes up is cut open, so that what lies in it is in a plane.
#pragma once

#include "face/trims/fold.h"

#include <vector>

namespace nrb::face {

// Where the domain should begin along its closed axes: in the widest gaps between all ends of pieces, so that each piece that comes to
// a seam passes it from one side of the gap to the other, and meets no other one in it. Where both axes are closed the corner is away
// from all pieces. Throws Status::not_converged if gaps are no wider than so many times what rounding moves places by.
Point2 seams_for(const TrimPieces &plane, const Covering &covering, const Point2 &rounding);

struct SeamContact {
    int32_t chain; // the number of its pieces
    double at;     // along the seam
    bool forward;  // to larger parameters on the axis that closes there
};

// Where chains pass the seam of axis k, by `at`. Throws Status::not_converged where rounding hides which comes first.
std::vector<SeamContact> seam_contacts(const FoldedPieces &folded, const Covering &covering, int k,
                                       double rounding);

} // namespace nrb::face
