// SPDX-License-Identifier: MIT
// Which loops lie in which, and how they have to run.
#pragma once

#include "face/trims/loop_shape.h"
#include "face/trims/passed.h"

#include <vector>

namespace nrb::face {

// Loops in an even number of others enclose what is inside, and those in an odd number what is not; where loops run around an
// axis, these say what is inside before the others.
class Nesting {
public:
    // left: what is passed of each loop from the left side of loop i on; the last entry is of loop i itself.
    Nesting(const std::vector<LoopShape> &loops, const std::vector<PassedSums> &left);

    [[nodiscard]] std::vector<bool> loops_to_turn() const;

private:
    [[nodiscard]] int own(size_t i) const;
    [[nodiscard]] int around(size_t i) const;
    [[nodiscard]] bool enclosed(size_t i) const;

    const std::vector<LoopShape> &loops_;
    const std::vector<PassedSums> &left_;
    std::vector<int> outside_; // what is passed of each loop from places that it does not go around
    int corner_ = 0;           // whether the corner is inside by the loops around axes
    bool odd_ = false;         // whether an odd number of the others go around the corner
};

} // namespace nrb::face
