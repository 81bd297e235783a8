// SPDX-License-Identifier: MIT
#include "face/trims/nesting.h"

#include <algorithm>

namespace nrb::face {

Nesting::Nesting(const std::vector<LoopShape> &loops, const std::vector<PassedSums> &left)
    : loops_(loops), left_(left), outside_(loops.size(), 0) {
    bool known = false;
    for (size_t i = 0; i < loops.size(); ++i) {
        if (!loops[i].around) {
            outside_[i] = own(i) - (loops[i].area > 0 ? 1 : 0);
            odd_ = odd_ != (outside_[i] != 0);
        } else if (!known) {
            corner_ = 1 - around(i);
            known = true;
        }
    }
}

int Nesting::own(size_t i) const {
    int sum = 0;
    for (const PassedSum &passed : left_[i]) {
        sum += static_cast<size_t>(passed.loop) == i ? passed.value : 0;
    }
    return sum;
}

int Nesting::around(size_t i) const {
    int sum = 0;
    for (const PassedSum &passed : left_[i]) {
        sum += loops_[static_cast<size_t>(passed.loop)].around ? passed.value : 0;
    }
    return sum;
}

// Whether the places at loop i would be inside without that loop. A loop that the ray does not cross encloses
// them if it encloses the corner.
bool Nesting::enclosed(size_t i) const {
    bool inside = (corner_ + around(i) > 0) != odd_;
    inside = inside != (outside_[i] != 0);
    for (const PassedSum &passed : left_[i]) {
        const auto loop = static_cast<size_t>(passed.loop);
        if (loop != i && !loops_[loop].around) {
            inside = inside != ((passed.value != outside_[loop]) != (outside_[loop] != 0));
        }
    }
    return inside;
}

std::vector<bool> Nesting::loops_to_turn() const {
    std::vector<bool> turned(loops_.size(), false);
    for (size_t i = 0; i < loops_.size(); ++i) {
        turned[i] = !loops_[i].around && enclosed(i) == (loops_[i].area > 0);
    }
    return turned;
}

} // namespace nrb::face
