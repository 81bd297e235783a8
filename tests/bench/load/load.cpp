// SPDX-License-Identifier: MIT
// What loading the library costs a program that has the standard C++ library already.
//   load LIBRARY [TIMES]: the median, in milliseconds, of processes that load it once each
#include <algorithm>
#include <chrono>
#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <dlfcn.h>
#include <iostream>
#include <sys/wait.h>
#include <unistd.h>
#include <vector>

namespace {

// Milliseconds; negative if it cannot be loaded.
double time_of_loading(const char *library) {
    const auto start = std::chrono::steady_clock::now();
    void *const handle = dlopen(library, RTLD_NOW | RTLD_LOCAL);
    const std::chrono::duration<double, std::milli> time = std::chrono::steady_clock::now() - start;
    return handle == nullptr ? -1 : time.count();
}

double in_a_process(const char *library) {
    int ends[2];
    double time = -1;
    if (pipe(ends) != 0) {
        return time;
    }
    const pid_t child = fork();
    if (child == 0) {
        time = time_of_loading(library);
        _exit(write(ends[1], &time, sizeof time) == sizeof time ? 0 : 2);
    }
    close(ends[1]);
    if (read(ends[0], &time, sizeof time) != sizeof time) {
        time = -1;
    }
    close(ends[0]);
    waitpid(child, nullptr, 0);
    return time;
}

} // namespace

int main(int count, char **arguments) {
    if (count < 2) {
        std::cerr << "usage: load LIBRARY [TIMES]\n";
        return 2;
    }
    std::vector<double> times(count > 2 ? std::strtoul(arguments[2], nullptr, 10) : 101);
    std::generate(times.begin(), times.end(), [&] { return in_a_process(arguments[1]); });
    std::sort(times.begin(), times.end());
    std::printf("loading: %.3f ms of 0.5 (least %.3f, most %.3f)\n", times[times.size() / 2], times.front(),
                times.back());
    return times.front() >= 0 ? 0 : 1;
}
