// SPDX-License-Identifier: MIT
// Clusters of tiny cells between stretches along which two curves run side by side.
#pragma once

#include "intersect/pairs/links.h"

#include <span>
#include <utility>
#include <vector>

namespace nrb::intersect {

// How far some cells extend on both curves, and whether a stretch turns back in one of them.
struct JointRange {
    Interval a{0, 0}, b{0, 0};
    bool turns_back = false;
    bool empty = true;

    void add(const JointRange &other) noexcept;
};

// All cells of one group, moved to where their turns bring them. There may be many cells, and many stretches
// that end at them, so the extents beyond each place are accumulated once.
class Joint {
public:
    // both_ways: stretches of both directions end here.
    Joint(std::span<const NearCell> cells, const NearGroup &group, double period_a, double period_b,
          bool both_ways);

    // For the cells that begin at a place on the first curve or later, or that end there or earlier.
    [[nodiscard]] JointRange from(double a) const noexcept;
    [[nodiscard]] JointRange until(double a) const noexcept;

private:
    using Sums = std::vector<std::pair<double, JointRange>>;
    Sums by_lower_; // each with all after it
    Sums by_upper_; // each with all before it
};

} // namespace nrb::intersect
