// SPDX-License-Identifier: MIT
// One query for critical points: its point in the frame of the pieces, and what rounding allows to decide.
#pragma once

#include "closest/patch/patch_place.h"

#include <vector>

namespace nrb::closest {

// What the search has left open so far.
struct CriticalGaps {
    bool incomplete = false; // the budget has ended, or the limit of depth was reached
    bool connected = false;  // some critical points are not isolated
    bool doubtful = false;   // double precision does not decide whether a point is critical
};

class CriticalQuery {
public:
    CriticalQuery(const PieceGrid &pieces, const Query &query);

    [[nodiscard]] const PatchShape &shape() const noexcept { return pieces_.shape(); }
    [[nodiscard]] const PieceGrid &pieces() const noexcept { return pieces_; }
    [[nodiscard]] const Query &query() const noexcept { return query_; }
    [[nodiscard]] const PatchItems &items() const noexcept { return items_; }
    [[nodiscard]] const PatchDescent &descent() const noexcept { return descent_; }
    [[nodiscard]] PatchMemory &memory() const noexcept { return memory_; }

    // A bound on the effect of rounding on a distance.
    [[nodiscard]] double noise() const noexcept { return noise_; }
    // Points at most this far apart count as one.
    [[nodiscard]] double near() const noexcept { return near_; }
    // The part of a piece that lies in the range, relative to the query point.
    [[nodiscard]] PatchItem piece_in_range(int64_t piece) const;
    [[nodiscard]] std::vector<double> point(const PatchItem &whole, const AxisValues &at) const;
    [[nodiscard]] double apart(const std::vector<double> &a, const std::vector<double> &b) const noexcept;

private:
    const PieceGrid &pieces_;
    const Query &query_;
    mutable PatchMemory memory_;
    PatchItems items_;
    PatchDescent descent_;
    double noise_ = 0, near_ = 0;
};

} // namespace nrb::closest
