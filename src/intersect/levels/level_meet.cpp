// SPDX-License-Identifier: MIT
#include "intersect/levels/level_meet.h"

#include <algorithm>
#include <iterator>

namespace nrb::intersect {

void Meet::append(Meet other) {
    const int64_t first = std::ssize(nodes);
    int64_t loops = 0;
    for (const MeetBranch &branch : branches) {
        loops = std::max(loops, branch.loop + 1);
    }
    for (MeetBranch &branch : other.branches) {
        for (int64_t &node : branch.nodes) {
            node += node < 0 ? 0 : first;
        }
        branch.loop += branch.loop < 0 ? 0 : loops;
        branches.push_back(std::move(branch));
    }
    std::ranges::move(other.nodes, std::back_inserter(nodes));
    complete = complete && other.complete;
}

} // namespace nrb::intersect
