// SPDX-License-Identifier: MIT
// Intervals that others are compared with.
#pragma once

#include "base/watch.h"
#include "basis/knot_vector.h"

#include <cmath>
#include <cstddef>
#include <iterator>
#include <map>

namespace nrb::intersect {

// By their lengths, to within a factor of 2, so that a few long ones do not make a search among many short ones longer.
class OpenIntervals {
public:
    struct Item {
        Interval range;
        double end; // until when they are open
        size_t number;
    };

    void add(const Item &item) {
        const double length = item.range.upper - item.range.lower;
        by_length_[std::ilogb(length)].emplace(item.range.lower, item);
    }

    // Calls visit(item) for all that touch a range; true closes it.
    template <class Visit>
    void visit(const Interval &range, Visit &&visit) {
        for (auto &[exponent, items] : by_length_) {
            count_work(40);
            const double longest = std::ldexp(2.0, exponent);
            const auto last = items.upper_bound(range.upper);
            for (auto i = items.lower_bound(range.lower - longest); i != last;) {
                count_work(20);
                const bool closes = i->second.range.upper >= range.lower && visit(i->second);
                i = closes ? items.erase(i) : std::next(i);
            }
        }
    }

private:
    std::map<int, std::multimap<double, Item>> by_length_;
};

} // namespace nrb::intersect
