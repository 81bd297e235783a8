// SPDX-License-Identifier: MIT
// Best-first search within a budget: the order of most certified searches.
#pragma once

#include "base/watch.h"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

namespace nrb::pieces {

// Number of pieces examined for an answer where the caller sets no limit.
inline constexpr int64_t default_budget = 20000;

// A priority queue of items, each with an upper bound of the values that may be found in it, for the largest
// value; searches for the smallest value negate lower bounds. An item that is discarded leaves its bound
// behind, so that bound() holds for all items at any time.
template <class Item>
class BestFirst {
public:
    struct Entry {
        double bound;
        Item item;

        [[nodiscard]] bool operator<(const Entry &other) const noexcept { return bound < other.bound; }
    };

    BestFirst() = default;
    explicit BestFirst(std::vector<Entry> entries) : entries_(std::move(entries)) {
        std::make_heap(entries_.begin(), entries_.end());
    }

    [[nodiscard]] bool empty() const noexcept { return entries_.empty(); }
    [[nodiscard]] size_t size() const noexcept { return entries_.size(); }
    [[nodiscard]] const Entry &best() const noexcept { return entries_.front(); }
    // The upper bound over all items that are left or were discarded.
    [[nodiscard]] double bound() const noexcept {
        return entries_.empty() ? left_out_ : std::max(left_out_, entries_.front().bound);
    }

    void push(double bound, Item item) {
        entries_.push_back({bound, std::move(item)});
        std::push_heap(entries_.begin(), entries_.end());
    }
    Entry pop() {
        std::pop_heap(entries_.begin(), entries_.end());
        Entry entry = std::move(entries_.back());
        entries_.pop_back();
        return entry;
    }
    void leave_out(double bound) noexcept { left_out_ = std::max(left_out_, bound); }

    // Calls look(Entry) for the best item while counts(const Entry &) holds for it. At most `budget` calls
    // are made, of which look() may use up further ones itself; none once the work limit is reached.
    template <class Counts, class Look>
    void run(int64_t &budget, Counts &&counts, Look &&look) {
        SearchSteps steps;
        while (!empty() && counts(best()) && budget-- > 0 && !work_ended()) {
            look(pop());
            steps.next(size());
        }
    }

private:
    std::vector<Entry> entries_;
    double left_out_ = -std::numeric_limits<double>::infinity();
};

} // namespace nrb::pieces
