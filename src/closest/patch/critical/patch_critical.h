// SPDX-License-Identifier: MIT
// All critical points of the distance from a point to a surface or volume.
//
// The method is subdivision with exclusion and uniqueness tests. A part of a piece on which the distance
// increases or decreases throughout along some axis has no critical point. A part on which the interval
// matrix of the second derivatives is regular has at most one, which Newton's method finds. All other parts
// are halved (Sherbrooke & Patrikalakis, "Computation of the solutions of nonlinear polynomial systems", CAGD
// 10, 1993).
#pragma once

#include "closest/locator.h"
#include "closest/patch/critical/critical_points.h"

#include <vector>

namespace nrb::closest {

CriticalSet critical_points(const PieceGrid &pieces, const Query &query);

// The places in some pieces at which the distance, if it is at most a limit, may have a minimum: critical
// points in the interiors of the pieces and along their faces and edges, and corners.
struct MinimumCandidates {
    std::vector<MinimumCandidate> candidates;
    CriticalGaps gaps;
};
MinimumCandidates minimum_candidates(const PieceGrid &pieces, const Query &query,
                                     const std::vector<int64_t> &among, double limit);

} // namespace nrb::closest
