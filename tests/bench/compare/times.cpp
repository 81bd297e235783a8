// The times of two builds of the library, in one process, in turns: for each row the median of the ratios of
// neighbouring turns, since a disturbance of the machine meets both.
#include "bench/compare/module.h"

#include <algorithm>
#include <cstdio>
#include <ctime>
#include <regex>

namespace {

using bench::Module;

constexpr double least_seconds = 0.01; // of a turn, far above what the clock resolves
constexpr int turns = 21;

double cpu_seconds() {
    timespec now{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

double seconds(const Module &module, int64_t times) {
    const double start = cpu_seconds();
    module.run(times);
    return cpu_seconds() - start;
}

int64_t repetitions(const Module &module) {
    int64_t times = 1;
    while (seconds(module, times) < least_seconds) {
        times *= 2;
    }
    return times;
}

double median(std::vector<double> values) {
    const auto middle = values.begin() + std::ssize(values) / 2;
    std::ranges::nth_element(values, middle);
    return *middle;
}

// Which of the two begins changes from turn to turn.
double ratio(const Module &before, const Module &after) {
    const int64_t times = repetitions(before);
    after.run(1);
    std::vector<double> ratios;
    for (int turn = 0; turn < turns; ++turn) {
        const bool swapped = turn % 2 == 1;
        const double first = seconds(swapped ? after : before, times);
        const double second = seconds(swapped ? before : after, times);
        ratios.push_back(swapped ? first / second : second / first);
    }
    return median(ratios);
}

void compare(const std::string &family, char **argv, const std::regex &wanted) {
    const Module before(bench::module_path(argv[1], family), true);
    const Module after(bench::module_path(argv[2], family), true);
    const int64_t rows = before.open(argv[3]);
    after.open(argv[3]);
    for (int64_t row = 0; row < rows; ++row) {
        if (std::regex_search(before.name(row), wanted)) {
            before.prepare(row);
            after.prepare(row);
            std::printf("%-20s %8.3f\n", before.name(row).c_str(), ratio(before, after));
            std::fflush(stdout);
        }
    }
}

} // namespace

int main(int argc, char **argv) {
    if (argc != 5) {
        std::fprintf(stderr, "usage: %s FOLDER_BEFORE FOLDER_AFTER DATA_FOLDER REGEX\n", argv[0]);
        return 2;
    }
    for (const std::string &family : bench::families()) {
        compare(family, argv, std::regex(argv[4]));
    }
}
