#include "support/cases.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <gtest/gtest.h>

namespace support {

int64_t of_whole_run(int64_t n) {
    return scale() < 1 ? -1 : n;
}

void for_each_case(uint64_t base, int count, const std::function<void(Random &, uint64_t)> &body) {
    const int64_t cases = scaled(count);
    std::printf("seeds %llu to %llu\n", static_cast<unsigned long long>(base),
                static_cast<unsigned long long>(base) + static_cast<unsigned long long>(cases) - 1);
    for (uint64_t seed = base; seed < base + static_cast<uint64_t>(cases); ++seed) {
        Random random(seed);
        try {
            body(random, seed);
        } catch (const std::exception &error) {
            ADD_FAILURE() << "seed " << seed << ": " << error.what();
        }
        if (testing::Test::HasFailure()) {
            return;
        }
    }
}

std::string where(uint64_t seed, const SplineData &data) {
    return "\nseed " + std::to_string(seed) + describe(data);
}

void WorstErrors::add(int degree, long double over_bound, long double over_unit) {
    Pair &pair = worst_[degree];
    pair.over_bound = std::max(pair.over_bound, over_bound);
    pair.over_unit = std::max(pair.over_unit, over_unit);
}

WorstErrors::~WorstErrors() {
    std::printf("%s\n  degree  error/bound  error/unit\n", title_.c_str());
    for (const auto &[degree, pair] : worst_) {
        std::printf("  %6d  %11.4Lf  %10.4Lf\n", degree, pair.over_bound, pair.over_unit);
    }
}

} // namespace support
