// SPDX-License-Identifier: MIT
// One query for critical points: its point among the pieces, and when rounding hides what happens there.
#pragma once

#include "closest/patch/patch_place.h"

#include <vector>

namespace nrb::closest {

// What has been left open so far.
struct CriticalGaps {
    bool incomplete = false; // the budget has ended, or the deepest part was reached
    bool connected = false;  // some points are not isolated
    bool doubtful = false;   // double precision does not tell whether a point is critical
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

    // What rounding may change in a distance.
    [[nodiscard]] double noise() const noexcept { return noise_; }
    // Points nearer to each other are one.
    [[nodiscard]] double near() const noexcept { return near_; }
    // A piece about the query point, as far as it is in the range.
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
