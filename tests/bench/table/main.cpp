// SPDX-License-Identifier: MIT
// Jobs that were slow once, beside Eigen, SISL and textbook code in the same process.
//     bench_table [WORD [SECONDS]]      the jobs whose name contains the word; seconds for each, 0 checks results only
#include "bench/table/rows.h"

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <cstdio>
#include <cstdlib>

namespace bench {

namespace {

double seconds_of(const std::function<void()> &work, int64_t runs) {
    const auto start = std::chrono::steady_clock::now();
    for (int64_t i = 0; i < runs; ++i) {
        work();
    }
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

// As many as take so long.
int64_t runs_for(const std::function<void()> &work, double seconds) {
    int64_t runs = 1;
    while (runs < (int64_t{1} << 30) && seconds_of(work, runs) < seconds) {
        runs *= 2;
    }
    return runs;
}

double median(std::vector<double> values) {
    std::nth_element(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2),
                     values.end());
    return values[values.size() / 2];
}

struct Times {
    double ours, theirs, ratio; // medians
};

Times compare(const Row &row, double seconds) {
    constexpr int turns = 15;
    const int64_t our_runs = runs_for(row.ours, seconds / 2 / turns),
                  their_runs = runs_for(row.theirs, seconds / 2 / turns);
    std::vector<double> ours, theirs, ratios;
    for (int i = 0; i < turns; ++i) {
        ours.push_back(seconds_of(row.ours, our_runs) / static_cast<double>(our_runs) / row.work);
        theirs.push_back(seconds_of(row.theirs, their_runs) / static_cast<double>(their_runs) / row.work);
        ratios.push_back(ours.back() / theirs.back());
    }
    return {median(ours), median(theirs), median(ratios)};
}

} // namespace

bool Rows::measure(const std::string &word, double seconds) const {
    bool right = true;
    std::printf("| nanoseconds | libnurbs | other | which | libnurbs / other |\n");
    std::printf("| --- | ---: | ---: | --- | ---: |\n");
    for (const Row &row : rows_) {
        if (row.job.find(word) == std::string::npos) {
            continue;
        }
        const double difference = row.difference ? row.difference() : 0;
        if (!(difference <= 1e-9)) {
            std::printf("%s: results differ by %g\n", row.job.c_str(), difference);
            right = false;
        }
        if (seconds > 0) {
            const Times times = compare(row, seconds);
            std::printf("| %s | %.4g | %.4g | %s | %.2g |\n", row.job.c_str(), 1e9 * times.ours,
                        1e9 * times.theirs, row.peer.c_str(), times.ratio);
            std::fflush(stdout);
        }
    }
    return right;
}

} // namespace bench

int main(int argc, char **argv) {
    bench::Rows rows;
    bench::add_points(rows);
    bench::add_first_calls(rows);
    bench::add_forms(rows);
    bench::add_operations(rows);
    bench::add_fits(rows);
    bench::add_faces(rows);
    bench::add_meets(rows);
    return rows.measure(argc > 1 ? argv[1] : "", argc > 2 ? std::atof(argv[2]) : 0.6) ? 0 : 1;
}
