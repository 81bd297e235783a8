// SPDX-License-Identifier: MIT
#include "model/placing.h"

#include "model/cycles.h"

namespace nrb::model {

std::vector<size_t> drop_cycles(size_t parts, std::vector<Use> &uses) {
    const std::vector<bool> in_cycle = uses_in_cycles(parts, uses);
    std::vector<size_t> dropped;
    size_t kept = 0;
    for (size_t i = 0; i < in_cycle.size(); ++i) {
        if (in_cycle[i]) {
            dropped.push_back(i);
        } else {
            uses[kept++] = uses[i];
        }
    }
    uses.resize(kept);
    return dropped;
}

void place_the_rest(size_t parts, std::vector<Use> &uses) {
    std::vector<bool> placed(parts, false);
    for (const Use &use : uses) {
        placed[static_cast<size_t>(use.part)] = true;
    }
    for (size_t i = 0; i < parts; ++i) {
        if (!placed[i]) {
            Use use;
            use.part = static_cast<int64_t>(i);
            uses.push_back(use);
        }
    }
}

} // namespace nrb::model
