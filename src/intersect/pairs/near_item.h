// SPDX-License-Identifier: MIT
// Near parts of two curves that are one hit.
#pragma once

#include "intersect/pairs/links.h"

namespace nrb::intersect {

// Cells by their places on a, moved by periods to where they touch; and the ranges of all of them.
struct NearItem {
    std::vector<NearCell> cells;
    Interval a, b;

    NearItem(const Spline &on_a, const Spline &on_b, std::span<const NearCell> all, const NearGroup &group);

    // The ranges, of the cells that there are now.
    void fit() noexcept;
    [[nodiscard]] const NearCell &nearest() const noexcept;
    [[nodiscard]] bool has(NearCell::Kind kind) const noexcept;
    // Whether one of the curves stands still in it.
    [[nodiscard]] bool is_still() const noexcept;
};

// Whether a control point of both curves is in it, at one place, and no more than `narrow` from there.
bool holds_common_point(const Spline &a, const Spline &b, const NearItem &item, double narrow);

// Whether a range reaches an end of a curve, which a periodic one has not.
bool at_end(const Spline &curve, Interval part) noexcept;

} // namespace nrb::intersect
