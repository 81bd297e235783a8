// SPDX-License-Identifier: MIT
// Which loops lie inside which, and how they have to run.
#pragma once

#include "face/trims/loop_shape.h"
#include "face/trims/passed.h"

#include <vector>

namespace nrb::face {

// The even-odd rule: a loop inside an even number of others encloses the inside, and one inside an odd number
// a hole. Loops that run around an axis are not turned; they say first what is inside, before others are
// counted.
class Nesting {
public:
    // left: for each loop i, the crossings of all loops by the ray from its left side to the corner
    // (TrimMap); the last entry is that of loop i itself.
    Nesting(const std::vector<LoopShape> &loops, const std::vector<PassedSums> &left);

    [[nodiscard]] std::vector<bool> loops_to_turn() const;

private:
    [[nodiscard]] int own(size_t i) const;
    [[nodiscard]] int around(size_t i) const;
    [[nodiscard]] bool enclosed(size_t i) const;

    const std::vector<LoopShape> &loops_;
    const std::vector<PassedSums> &left_;
    std::vector<int> outside_; // crossings of each loop by rays from places that it does not enclose
    int corner_ = 0;           // whether the corner is inside, by the loops around axes alone
    bool odd_ = false;         // whether an odd number of the other loops enclose the corner
};

} // namespace nrb::face
