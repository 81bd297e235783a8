// SPDX-License-Identifier: MIT
// Intervals of a sweep that hang together.
#pragma once

#include "base/watch.h"
#include "basis/knot_vector.h"

#include <algorithm>
#include <bit>
#include <cstddef>
#include <vector>

namespace nrb::intersect {

// A tree of segments between all ends. Whatever touches an interval that is looked for becomes one set with it, so that of each list
// that is met the item that is open the longest stands for the others from then on: a search takes as long as the tree is high.
class OpenIntervals {
public:
    struct Item {
        size_t number;
        double end; // until when it is open
    };

    // Those that will be added or looked for.
    explicit OpenIntervals(const std::vector<Interval> &all) {
        for (const Interval &range : all) {
            ends_.push_back(range.lower);
            ends_.push_back(range.upper);
        }
        std::ranges::sort(ends_);
        ends_.erase(std::unique(ends_.begin(), ends_.end()), ends_.end());
        size_ = std::bit_ceil(std::max(ends_.size(), size_t{1}));
        nodes_.resize(2 * size_);
    }

    void add(const Interval &range, const Item &item) {
        walk(range, [&](Node &node, bool covered) { (covered ? node.over : node.in).push_back(item); });
    }

    // Calls join(number) for items that touch a range and are open; all that do are one set with these.
    template <class Join>
    void visit(const Interval &range, double now, Join &&join) {
        walk(range, [&](Node &node, bool covered) {
            settle(node.over, now, join);
            if (covered) {
                settle(node.in, now, join);
            }
        });
    }

private:
    struct Node {
        std::vector<Item> over; // they hold all of it
        std::vector<Item> in;   // they hold a part of it
    };

    [[nodiscard]] size_t rank(double x) const noexcept {
        return static_cast<size_t>(std::ranges::lower_bound(ends_, x) - ends_.begin());
    }

    // All nodes that meet a range, but for those below one that is covered by it.
    template <class Visit>
    void walk(const Interval &range, Visit &&visit) {
        walk(1, 0, size_ - 1, rank(range.lower), rank(range.upper), visit);
    }
    template <class Visit>
    void walk(size_t node, size_t first, size_t last, size_t from, size_t to, Visit &visit) {
        count_work(20);
        const bool covered = from <= first && last <= to;
        visit(nodes_[node], covered);
        if (covered) {
            return;
        }
        const size_t middle = first + (last - first) / 2;
        if (from <= middle) {
            walk(2 * node, first, middle, from, to, visit);
        }
        if (to > middle) {
            walk(2 * node + 1, middle + 1, last, from, to, visit);
        }
    }

    template <class Join>
    static void settle(std::vector<Item> &items, double now, Join &join) {
        if (items.empty()) {
            return;
        }
        const Item longest = *std::ranges::max_element(items, {}, &Item::end);
        for (const Item &item : items) {
            if (item.end >= now) {
                join(item.number);
            }
        }
        items.clear();
        if (longest.end >= now) {
            items.push_back(longest);
        }
    }

    std::vector<double> ends_;
    size_t size_; // of the lowest level
    std::vector<Node> nodes_;
};

} // namespace nrb::intersect
