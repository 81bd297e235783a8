// SPDX-License-Identifier: MIT
#include "closest/patch/critical/patch_critical.h"

#include "base/watch.h"
#include "closest/patch/critical/critical_search.h"

namespace nrb::closest {

namespace {

int32_t status_of(const CriticalGaps &gaps) noexcept {
    return gaps.incomplete  ? closest_budget
           : gaps.connected ? closest_not_unique
           : gaps.doubtful  ? 0
                            : closest_certified;
}

} // namespace

CriticalSet critical_points(const PieceGrid &pieces, const Query &query) {
    CriticalSearch search(pieces, query, false);
    if (search.query().items().far_away() || pieces.shape().coefficients() > pieces::most_squared) {
        return {{}, closest_budget};
    }
    search.find_poles();
    for (int code = 0; code < face_count(pieces.shape()); ++code) {
        const Phase phase; // faces of higher dimension first
        const PatchFace face = face_of(pieces.shape(), code);
        if (is_boundary(pieces, query, face) && !search.is_pole(face)) {
            search.search(face, pieces_at(pieces, query, face));
        }
    }
    return {search.points().sorted(), status_of(search.gaps())};
}

// Includes the faces between pieces, since there may be minima along creases, and seams.
MinimumCandidates minimum_candidates(const PieceGrid &pieces, const Query &query,
                                     const std::vector<int64_t> &among, double limit) {
    CriticalSearch search(pieces, query, true);
    search.set_limit(limit);
    search.find_poles();
    for (int code = 0; code < face_count(pieces.shape()); ++code) {
        const Phase phase; // faces of higher dimension first
        search.search(face_of(pieces.shape(), code), among);
    }
    MinimumCandidates result{{}, search.gaps()};
    const CriticalPoints &points = search.points();
    for (size_t i = 0; i < points.size(); ++i) {
        const MinimumVotes::Result votes = search.votes().result(points.point(i));
        if (votes != MinimumVotes::Result::denied) {
            result.candidates.push_back(points.candidate(i));
            result.candidates.back().certain = votes == MinimumVotes::Result::certain;
        }
    }
    return result;
}

} // namespace nrb::closest
