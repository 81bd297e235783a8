// SPDX-License-Identifier: MIT
// Subdivision search on faces of pieces for the places at which the distance is critical along the face.
#pragma once

#include "closest/patch/critical/face_part.h"
#include "closest/patch/critical/minimum_votes.h"
#include "closest/patch/critical/patch_poles.h"

#include <limits>
#include <vector>

namespace nrb::closest {

class CriticalSearch {
public:
    // minima: only minima are wanted.
    CriticalSearch(const PieceGrid &pieces, const Query &query, bool minima);

    [[nodiscard]] const CriticalQuery &query() const noexcept { return query_; }
    [[nodiscard]] const CriticalPoints &points() const noexcept { return points_; }
    [[nodiscard]] const MinimumVotes &votes() const noexcept { return votes_; }
    [[nodiscard]] const CriticalGaps &gaps() const noexcept { return gaps_; }

    // Places at a larger distance are not wanted.
    void set_limit(double limit) noexcept { limit_ = limit; }
    void find_poles() { poles_.find(); }
    [[nodiscard]] bool is_pole(const PatchFace &face) const noexcept { return poles_.holds(face); }
    // Searches one face of each of the pieces.
    void search(const PatchFace &face, const std::vector<int64_t> &pieces);

private:
    // The face of one piece.
    struct Target {
        const PatchFace &face;
        const pieces::PatchSquares &squares;
        const PatchItem &whole;
    };
    void search_piece(const PatchFace &face, const pieces::PatchSquares &squares, int64_t piece);
    void examine_corner(const Target &target);
    void examine(const Target &target, FacePart &part);
    bool finished(const Target &target, const FacePart &part, int &axis);
    bool excluded(PatchSlopes &slopes, bool flat, int64_t piece);
    void split(const Target &target, FacePart &part, int axis);
    void add_all(const Target &target, const FacePart &part, const PatchSlopes &slopes);
    bool find(const Target &target, const FacePart &part, bool singular);
    [[nodiscard]] bool is_real(const Target &target, const AxisValues &at);
    void add(const Target &target, const AxisValues &at, bool isolated);

    CriticalQuery query_;
    bool minima_;
    CriticalGaps gaps_;
    CriticalPoints points_;
    PatchPoles poles_;
    MinimumVotes votes_;
    double limit_ = std::numeric_limits<double>::infinity();
    int64_t cost_ = 1, spent_ = 0, budget_ = 0; // in parts, weighted by their number of coefficients
};

} // namespace nrb::closest
