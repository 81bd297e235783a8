// SPDX-License-Identifier: MIT
// All critical points of the distance from a point on a surface or volume.
//
// A part of a piece on which the distance rises or falls throughout along some axis has no critical point. A
// part on which the matrix of the second derivatives is regular has at most one, which Newton's method finds.
// All others are halved (Sherbrooke & Patrikalakis, "Computation of the solutions of nonlinear polynomial
// systems", CAGD 10, 1993).
#pragma once

#include "closest/locator.h"
#include "closest/patch/critical/critical_points.h"

#include <vector>

namespace nrb::closest {

CriticalSet critical_points(const PieceGrid &pieces, const Query &query);

// The places in some pieces where the distance, if it is at most a limit, may have a minimum: critical points
// of the pieces, of their faces and edges, and corners.
struct MinimumCandidates {
    std::vector<MinimumCandidate> candidates;
    CriticalGaps gaps;
};
MinimumCandidates minimum_candidates(const PieceGrid &pieces, const Query &query,
                                     const std::vector<int64_t> &among, double limit);

} // namespace nrb::closest
