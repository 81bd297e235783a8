// SPDX-License-Identifier: MIT
// Near parts of a curve and a surface that are one hit.
#pragma once

#include "intersect/curve_surface/seams.h"

#include <span>
#include <vector>

namespace nrb::intersect {

// Cells, moved by periods to where they touch each other; and the box of all of them.
struct MeetGroup {
    std::vector<MeetCell> cells; // t rising
    MeetBox box{};

    // The box, of the cells that there are now.
    void fit() noexcept;
    [[nodiscard]] const MeetCell &nearest() const noexcept;
    [[nodiscard]] bool has(MeetCell::Kind kind) const noexcept;
    [[nodiscard]] bool is_still() const noexcept;
};

// Cells touch if their boxes do, across seams too, but not across jumps. In the order of t.
std::vector<MeetGroup> groups_of(std::span<const MeetCell> cells, const Seams &seams);

// Whether two cells that are not moved touch.
bool touch(const MeetCell &a, const MeetCell &b) noexcept;

} // namespace nrb::intersect
