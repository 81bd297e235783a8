// SPDX-License-Identifier: MIT
// How a mesh is timed, and how much memory it takes.
#pragma once

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <ctime>
#include <fstream>
#include <functional>
#include <malloc.h>
#include <string>

namespace bench::meshes {

struct Work {
    std::function<void()> prepare; // a shape without a mesh, as it is right after it was made; not timed
    std::function<void()> make;    // its mesh
    std::function<void()> see;     // once
    std::function<void()> release; // frees the mesh and nothing else
};
struct Cost {
    double ms = 0;             // of the processor: the least of as many runs as take half a second
    double peak = 0, held = 0; // bytes of the process beyond those before the first run, and of the mesh
};

inline double now() {
    timespec at{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &at);
    return 1e3 * static_cast<double>(at.tv_sec) + 1e-6 * static_cast<double>(at.tv_nsec);
}

// The most memory that this process has had. getrusage() would count what its parent had.
inline double most_memory() {
    std::ifstream file("/proc/self/status");
    std::string word;
    double kilobytes = 0;
    while (file >> word && word != "VmHWM:") {
    }
    file >> kilobytes;
    return 1024 * kilobytes;
}

inline double memory_in_use() {
    const struct mallinfo2 all = mallinfo2();
    return static_cast<double>(all.uordblks) + static_cast<double>(all.hblkhd);
}

inline double milliseconds(const std::function<void()> &work) {
    const double start = now();
    work();
    return now() - start;
}

inline Cost cost_of(const Work &work) {
    work.prepare();
    Cost cost;
    const double base = most_memory();
    cost.ms = milliseconds(work.make);
    cost.peak = most_memory() - base;
    work.see();
    const double with = memory_in_use();
    work.release();
    cost.held = with - memory_in_use();
    double sum = cost.ms;
    for (int runs = 1; sum < 500 && runs < 1000; ++runs) {
        work.prepare();
        const double ms = milliseconds(work.make);
        work.release();
        sum += ms;
        cost.ms = std::min(cost.ms, ms);
    }
    return cost;
}

// The beginning of a line for the driver; the rest is `more`, from a comma on.
inline void tell(const Cost &cost, int64_t triangles, const std::string &more) {
    std::printf("{\"ms\": %.6g, \"peak\": %.6g, \"held\": %.6g, \"triangles\": %lld%s}\n", cost.ms, cost.peak,
                cost.held, static_cast<long long>(triangles), more.c_str());
}

} // namespace bench::meshes
