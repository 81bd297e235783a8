// SPDX-License-Identifier: MIT
// What the programs that fit share: data of fits.py, and how a job is timed and told.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <fstream>
#include <functional>
#include <string>
#include <vector>

namespace bench::fits {

// The numbers of a file of FOLDER.
inline std::vector<double> read(const std::string &folder, const std::string &name) {
    std::ifstream file(folder + "/" + name + ".f64", std::ios::binary | std::ios::ate);
    if (!file) {
        std::fprintf(stderr, "no data %s\n", name.c_str());
        std::exit(2);
    }
    std::vector<double> values(static_cast<size_t>(file.tellg()) / sizeof(double));
    file.seekg(0);
    file.read(reinterpret_cast<char *>(values.data()),
              static_cast<std::streamsize>(values.size() * sizeof(double)));
    return values;
}

// Milliseconds of process time: the median of as many runs as take a quarter of a second, but at least one.
inline double milliseconds(const std::function<void()> &work) {
    const auto now = [] {
        timespec at{};
        clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &at);
        return 1e3 * static_cast<double>(at.tv_sec) + 1e-6 * static_cast<double>(at.tv_nsec);
    };
    std::vector<double> times;
    for (double sum = 0; sum < 250 && times.size() < 1001; sum += times.back()) {
        const double start = now();
        work();
        times.push_back(now() - start);
    }
    std::nth_element(times.begin(), times.begin() + static_cast<int64_t>(times.size() / 2), times.end());
    return times[times.size() / 2];
}

// One line for the driver: {"ms": ..., "count": control points, "error": largest distance from a datum}; -1: not told.
inline void tell(double ms, int64_t count = -1, double error = -1) {
    std::printf("{\"ms\": %.6g, \"count\": %lld, \"error\": %.4g}\n", ms, static_cast<long long>(count),
                error);
}

// Distances of data (n, 3) at n parameters from what a function writes for a parameter.
template <class Eval>
double largest_distance(const std::vector<double> &params, const std::vector<double> &points, Eval &&eval) {
    double largest = 0;
    for (size_t i = 0; i < params.size(); ++i) {
        double at[3], sum = 0;
        eval(params[i], at);
        for (size_t c = 0; c < 3; ++c) {
            sum += (at[c] - points[3 * i + c]) * (at[c] - points[3 * i + c]);
        }
        largest = std::max(largest, sum);
    }
    return std::sqrt(largest);
}

} // namespace bench::fits
