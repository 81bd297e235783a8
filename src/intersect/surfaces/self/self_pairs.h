// SPDX-License-Identifier: MIT
// What parts of a surface are to each other in its domain.
#pragma once

#include "intersect/surfaces/self/injective.h"

namespace nrb::intersect {

class SelfPairs {
public:
    explicit SelfPairs(CrossGround &ground) : ground_(ground), injective_(ground) {}

    enum class Verdict {
        one_sheet, // both are proven to have nothing in common but themselves
        touching, // not proven, and one and the same, or side by side: across knots, where the surface closes, or at a pole
        near,  // not proven, and no farther from each other than they are large
        apart, // not proven
    };
    Verdict look(const CrossCell &a, const CrossCell &b);

    // Whether all of the surface is one sheet.
    [[nodiscard]] bool is_one_sheet() const { return injective_.is_all_proven(); }

private:
    [[nodiscard]] Interval both_along(size_t axis, const Interval &a, const Interval &b) const noexcept;
    [[nodiscard]] bool are_in_one_block(const CrossCell &a, const CrossCell &b) const;

    CrossGround &ground_;
    InjectiveParts injective_;
};

} // namespace nrb::intersect
