/* SPDX-License-Identifier: MIT */
// One call of the table with random arguments, and what it took.
#ifndef NURBS_TESTS_CAPI_RANDOM_CALLER_H
#define NURBS_TESTS_CAPI_RANDOM_CALLER_H

#include "calls/calls.h"
#include "random/held.h"
#include "random/source.h"

#include <ctime>
#include <span>

namespace random_calls {

inline double processor_seconds() {
    timespec now{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

struct Clock {
    double seconds = 0;
    int64_t peak = 0, left = 0; // bytes held beyond what was there: at most, and after the call

    template <class Body>
    nurbs_status time(Body &&body) {
        const int64_t before = held::now;
        held::peak = before;
        const double start = processor_seconds();
        const nurbs_status status = body();
        seconds = processor_seconds() - start;
        peak = held::peak - before;
        left = held::now - before;
        return status;
    }
};

struct RandomCall {
    const char *function;
    const char *name;
    nurbs_status (*run)(Source &source, const calls::Inputs &in, Clock &clock);
};
std::span<const RandomCall> random_calls();

} // namespace random_calls

#endif
