// SPDX-License-Identifier: MIT
// Connected near parts of a curve and a surface that make one hit.
#pragma once

#include "intersect/curve_surface/seams.h"

#include <span>
#include <vector>

namespace nrb::intersect {

// Cells, moved by periods to where they touch each other, and the box of all of them.
struct MeetGroup {
    std::vector<MeetCell> cells; // ascending in t
    MeetBox box{};

    // Sets the box to that of the present cells.
    void fit() noexcept;
    [[nodiscard]] const MeetCell &nearest() const noexcept;
    [[nodiscard]] bool has(MeetCell::Kind kind) const noexcept;
    [[nodiscard]] bool is_still() const noexcept;
};

// The connected components of cells. Cells touch if their boxes do, also across seams, but not across jumps.
// The cells of a group are in the order of t.
std::vector<MeetGroup> groups_of(std::span<const MeetCell> cells, const Seams &seams);

// Whether two cells touch where they are, without periods.
bool touch(const MeetCell &a, const MeetCell &b) noexcept;

} // namespace nrb::intersect
