// SPDX-License-Identifier: MIT
// Classifies pairs of parts of one surface by where they are in its domain, for self-intersection.
#pragma once

#include "intersect/surfaces/self/injective.h"

namespace nrb::intersect {

class SelfPairs {
public:
    explicit SelfPairs(CrossGround &ground) : ground_(ground), injective_(ground) {}

    enum class Verdict {
        one_sheet, // the surface is proven injective on a rectangle with both: no self-intersection
        // Not proven; the parts overlap in the domain, or are adjacent, also across knots and where the
        // surface closes, or they have a pole in common.
        touching,
        near,  // not proven and not adjacent; along each axis both fit into three lengths of the longer one
        apart, // not proven, and neither of these, or the surface may jump between them
    };
    Verdict look(const CrossCell &a, const CrossCell &b);

    // Whether the whole surface is proven injective.
    [[nodiscard]] bool is_one_sheet() const { return injective_.is_all_proven(); }

private:
    [[nodiscard]] Interval both_along(size_t axis, const Interval &a, const Interval &b) const noexcept;
    [[nodiscard]] bool are_in_one_block(const CrossCell &a, const CrossCell &b) const;

    CrossGround &ground_;
    InjectiveParts injective_;
};

} // namespace nrb::intersect
