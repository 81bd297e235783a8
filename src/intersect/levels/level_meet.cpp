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

void Meet::keep(const std::function<bool(const MeetBranch &)> &wanted) {
    std::erase_if(branches, [&](const MeetBranch &branch) { return !wanted(branch); });
    std::vector<int64_t> new_node(nodes.size(), -1);
    for (size_t i = 0; i < nodes.size(); ++i) {
        const bool more = nodes[i].kind == NodeKind::touch || nodes[i].kind == NodeKind::undecided;
        new_node[i] = more ? 0 : -1;
    }
    for (const MeetBranch &branch : branches) {
        for (const int64_t node : branch.nodes) {
            if (node >= 0) {
                new_node[static_cast<size_t>(node)] = 0;
            }
        }
    }
    std::vector<MeetNode> kept;
    for (size_t i = 0; i < nodes.size(); ++i) {
        if (new_node[i] == 0) {
            new_node[i] = std::ssize(kept);
            kept.push_back(nodes[i]);
        }
    }
    nodes = std::move(kept);
    int64_t last = -1, loops = -1;
    for (MeetBranch &branch : branches) {
        for (int64_t &node : branch.nodes) {
            node = node < 0 ? node : new_node[static_cast<size_t>(node)];
        }
        if (branch.loop >= 0) {
            loops += branch.loop != last ? 1 : 0;
            last = branch.loop;
            branch.loop = loops;
        }
    }
}

} // namespace nrb::intersect
