// SPDX-License-Identifier: MIT
// What the programs that read files share: how a job is timed and told.
//   PROGRAM FILE    {"faces", "area", "read", "areas"}: milliseconds of process time to read the file, and to read it and
//                   add the areas of its faces
#pragma once

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <ctime>
#include <vector>

namespace bench::files {

struct Answer {
    int64_t faces = 0;
    double area = 0; // in millimetres
};
using Job = Answer (*)(const char *path, bool areas);

inline double now() {
    timespec at{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &at);
    return 1e3 * static_cast<double>(at.tv_sec) + 1e-6 * static_cast<double>(at.tv_nsec);
}

// The median of as many runs as take half a second, but at least three: the first one is no better than others.
inline double milliseconds(Job job, const char *path, bool areas, Answer &answer) {
    std::vector<double> times;
    for (double sum = 0; times.size() < 3 || (sum < 500 && times.size() < 1001); sum += times.back()) {
        const double start = now();
        answer = job(path, areas);
        times.push_back(now() - start);
    }
    std::nth_element(times.begin(), times.begin() + static_cast<std::ptrdiff_t>(times.size() / 2),
                     times.end());
    return times[times.size() / 2];
}

inline int run(int count, char **arguments, Job job) {
    if (count != 2) {
        std::fprintf(stderr, "usage: %s FILE\n", arguments[0]);
        return 2;
    }
    Answer answer;
    const double reading = milliseconds(job, arguments[1], false, answer);
    const double areas = milliseconds(job, arguments[1], true, answer);
    std::printf("{\"faces\": %lld, \"area\": %.17g, \"read\": %.17g, \"areas\": %.17g}\n",
                static_cast<long long>(answer.faces), answer.area, reading, areas);
    return 0;
}

} // namespace bench::files
