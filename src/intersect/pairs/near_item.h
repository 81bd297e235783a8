// SPDX-License-Identifier: MIT
// Connected near parts of two curves that make one hit.
#pragma once

#include "intersect/pairs/links.h"

namespace nrb::intersect {

// Cells in the order of a, moved by periods to where they touch each other; and the ranges of all of them.
struct NearItem {
    std::vector<NearCell> cells;
    Interval a, b;

    NearItem(const Spline &on_a, const Spline &on_b, std::span<const NearCell> all, const NearGroup &group);

    // Sets the ranges to those of the present cells.
    void fit() noexcept;
    [[nodiscard]] const NearCell &nearest() const noexcept;
    [[nodiscard]] bool has(NearCell::Kind kind) const noexcept;
    // Whether one of the curves stays at a point in all cells.
    [[nodiscard]] bool is_still() const noexcept;
};

// Whether a control point of both curves is in the item, at the same point, and the ends of the item are no
// more than `narrow` from it.
bool holds_common_point(const Spline &a, const Spline &b, const NearItem &item, double narrow);

// Whether a range reaches an end of a curve. A periodic curve has none.
bool at_end(const Spline &curve, Interval part) noexcept;

} // namespace nrb::intersect
