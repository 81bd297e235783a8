// SPDX-License-Identifier: MIT
#include "intersect/levels/level_meet.h"

#include <algorithm>
#include <iterator>
#include <numeric>
#include <span>
#include <utility>

namespace nrb::intersect {

void Meet::append(Meet other) {
    const int64_t first = std::ssize(nodes);
    int64_t loops = 0;
    for (const MeetBranch &branch : branches) {
        loops = std::max(loops, branch.loop + 1);
    }
    for (MeetNode &node : other.nodes) {
        node.next += node.next < 0 ? 0 : first;
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
    limited = limited || other.limited;
}

void Meet::tidy_nodes() {
    std::vector<bool> stays(nodes.size(), false);
    for (size_t i = 0; i < nodes.size(); ++i) {
        stays[i] = nodes[i].kind == NodeKind::touch || nodes[i].kind == NodeKind::undecided ||
                   nodes[i].kind == NodeKind::overlap;
    }
    for (const MeetBranch &branch : branches) {
        for (const int64_t node : branch.nodes) {
            if (node >= 0) {
                stays[static_cast<size_t>(node)] = true;
            }
        }
    }
    std::vector<size_t> order;
    for (size_t i = 0; i < stays.size(); ++i) {
        if (stays[i]) {
            order.push_back(i);
        }
    }
    std::ranges::sort(order, {}, [&](size_t i) { return std::pair(nodes[i].level, i); });
    std::vector<int64_t> place(nodes.size(), -1);
    std::vector<MeetNode> kept;
    for (const size_t i : order) {
        place[i] = std::ssize(kept);
        kept.push_back(nodes[i]);
    }
    const auto renumber = [&](int64_t &node) { node = node < 0 ? node : place[static_cast<size_t>(node)]; };
    for (MeetNode &node : kept) {
        renumber(node.next);
        complete = complete && node.kind != NodeKind::undecided;
    }
    for (MeetBranch &branch : branches) {
        std::ranges::for_each(branch.nodes, renumber);
    }
    nodes = std::move(kept);
}

namespace {

// Chains branches into ways.
class Ways {
public:
    explicit Ways(Meet meet) : meet_(std::move(meet)), taken_(meet_.branches.size(), false) {
        begun_at_.assign(meet_.nodes.size(), none);
        for (size_t i = 0; i < meet_.branches.size(); ++i) {
            if (const int64_t node = meet_.branches[i].nodes[0]; node >= 0) {
                begun_at_[static_cast<size_t>(node)] = i;
            }
        }
        before_.assign(meet_.branches.size(), none);
        for (size_t i = 0; i < before_.size(); ++i) {
            if (const size_t after = next(i); after != none) {
                before_[after] = i;
            }
        }
    }

    Meet run() {
        meet_.ways.clear();
        std::vector<size_t> order(meet_.branches.size());
        std::iota(order.begin(), order.end(), size_t{0});
        std::ranges::sort(order, {}, [&](size_t i) { return std::pair(meet_.branches[i].level, i); });
        for (size_t begin = 0, end = 0; begin < order.size(); begin = end) {
            const int64_t level = meet_.branches[order[begin]].level;
            while (end < order.size() && meet_.branches[order[end]].level == level) {
                ++end;
            }
            add_level(std::span(order).subspan(begin, end - begin));
        }
        meet_.branches = std::move(branches_);
        return std::move(meet_);
    }

private:
    static constexpr size_t none = static_cast<size_t>(-1);

    // The branch that continues where this one ends: the one that begins at the next node.
    [[nodiscard]] size_t next(size_t branch) const noexcept {
        const int64_t end = meet_.branches[branch].nodes[1];
        const int64_t node = end < 0 ? -1 : meet_.nodes[static_cast<size_t>(end)].next;
        return node < 0 ? none : begun_at_[static_cast<size_t>(node)];
    }

    void add_level(std::span<const size_t> branches) {
        for (const size_t i : branches) {
            if (!taken_[i]) {
                add_way(first_of(i));
            }
        }
    }
    // The first branch of a way that is not closed; otherwise the branch itself.
    [[nodiscard]] size_t first_of(size_t branch) const noexcept {
        size_t at = branch;
        while (before_[at] != none && before_[at] != branch) {
            at = before_[at];
        }
        return before_[at] == branch ? branch : at;
    }
    void add_way(size_t first) {
        MeetWay way{meet_.branches[first].level, std::ssize(branches_), 0, meet_.branches[first].nodes[0] < 0,
                    0};
        for (size_t i = first; i != none && !taken_[i]; i = next(i)) {
            taken_[i] = true;
            if (const int64_t end = meet_.branches[i].nodes[1]; next(i) != none) {
                way.gap = std::max(way.gap, meet_.nodes[static_cast<size_t>(end)].gap);
                way.closed = way.closed || next(i) == first;
            }
            ++way.count;
            branches_.push_back(std::move(meet_.branches[i]));
        }
        meet_.ways.push_back(way);
    }

    Meet meet_;
    std::vector<bool> taken_;
    std::vector<size_t> begun_at_, before_; // indexed by node, and by branch
    std::vector<MeetBranch> branches_;
};

} // namespace

Meet arranged(Meet meet) {
    return Ways(std::move(meet)).run();
}

Meet with_loops(Meet meet) {
    int64_t loops = 0;
    for (const MeetWay &way : meet.ways) {
        for (int64_t i = 0; way.closed && i < way.count; ++i) {
            meet.branches[static_cast<size_t>(way.first + i)].loop = loops;
        }
        loops += way.closed ? 1 : 0;
    }
    return meet;
}

} // namespace nrb::intersect
