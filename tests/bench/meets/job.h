// SPDX-License-Identifier: MIT
// How a meet is timed, and what is told of its curves.
#pragma once

#include "bench/meets/pairs.h"

#include <ctime>
#include <functional>

namespace bench::meets {

inline double now() {
    timespec at{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &at);
    return 1e3 * static_cast<double>(at.tv_sec) + 1e-6 * static_cast<double>(at.tv_nsec);
}

// Milliseconds of the processor: the least of as many runs as take half a second. prepare: surfaces with nothing kept from other
// calls, which is not timed.
inline double milliseconds(const std::function<void()> &prepare, const std::function<void()> &meet) {
    double least = HUGE_VAL, sum = 0;
    for (int runs = 0; runs == 0 || (sum < 500 && runs < 1000); ++runs) {
        prepare();
        const double start = now();
        meet();
        const double ms = now() - start;
        sum += ms;
        least = std::min(least, ms);
    }
    return least;
}

// Of the curves of a meet: points at even parameters make their lengths to 1e-5, and how far they are from the true ones.
class Curves {
public:
    explicit Curves(const Pair &pair) : pair_(pair) {}

    // point_at: of a parameter from 0 to 1.
    template <class PointAt>
    void add(PointAt &&point_at) {
        constexpr int samples = 300;
        Point last{};
        for (int i = 0; i <= samples; ++i) {
            const Point at = point_at(static_cast<double>(i) / samples);
            off_ = std::max(off_, distance_from(pair_, at));
            length_ += i == 0 ? 0 : distance(at, last);
            last = at;
        }
        ++count_;
    }
    // A line for the driver; proven: a bound of how far they are off, or less than 0.
    void tell(double ms, double proven) const {
        std::printf("{\"ms\": %.6g, \"curves\": %d, \"off\": %.4g, \"length\": %.9g, \"true_curves\": %zu, "
                    "\"true_length\": %.9g, \"proven\": %.4g}\n",
                    ms, count_, off_, length_, pair_.places.size(), true_length(pair_), proven);
    }

private:
    const Pair &pair_;
    int count_ = 0;
    double off_ = 0, length_ = 0;
};

} // namespace bench::meets
