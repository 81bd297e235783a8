// SPDX-License-Identifier: MIT
// The best of what is left first, within a budget: the order of most searches with proof.
#pragma once

#include "base/watch.h"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

namespace nrb::pieces {

// Pieces looked at for an answer where the caller sets no limit.
inline constexpr int64_t default_budget = 20000;

// Items with an upper bound of what may be found in them, for the largest value; searches for the smallest
// one negate lower bounds. What is left out leaves its bound, so that bound() holds of everything at any
// time.
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
    // Of all that is left, and was left out.
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

    // Calls look(Entry) while there is something left that counts(const Entry &), at most `budget` times, of
    // which look() may take more itself, and as long as the limit of work is not reached.
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
