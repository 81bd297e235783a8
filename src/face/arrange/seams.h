// SPDX-License-Identifier: MIT
// Seams: lines along which a domain that closes up is cut open, so that it becomes a rectangle of the plane.
#pragma once

#include "face/trims/fold.h"

#include <vector>

namespace nrb::face {

// Where the domain should begin along its closed axes: in the widest gap between the ends of all pieces. A
// piece that reaches such a seam crosses it from one side of the gap to the other, and meets no other piece
// in the gap. Where both axes are closed, the corner is also away from all pieces. rounding: by how much
// rounding moves places along each axis; throws Status::not_converged if a gap, or the distance of the corner
// from a piece, is less than a multiple of that.
Point2 seams_for(const TrimPieces &plane, const Covering &covering, const Point2 &rounding);

struct SeamContact {
    int32_t chain; // the `loop` of its pieces
    double at;     // the place along the seam
    bool forward;  // to larger parameters on the axis that closes there
};

// Where chains cross the seam of axis k, sorted by `at`. Throws Status::not_converged where two of them are
// so near each other that rounding hides which comes first.
std::vector<SeamContact> seam_contacts(const FoldedPieces &folded, const Covering &covering, int k,
                                       double rounding);

} // namespace nrb::face
