// Running a law over many seeded cases, and keeping the worst error seen.
#pragma once

#include "support/generators.h"
#include "support/scale.h"

#include <cstdint>
#include <functional>
#include <map>
#include <string>

namespace support {

// Calls body(random, seed) for seeds base, base + 1, ..., scaled(count) times. Prints the seeds; stops at the first case that fails, which is enough to repeat
// it. An exception counts as a failure.
void for_each_case(uint64_t base, int count, const std::function<void(Random &, uint64_t)> &body);

// `n` if all cases are run, else -1: how many of a kind a law has to have met, so that it is not one about
// nothing. A shorter run may miss what is rare.
int64_t of_whole_run(int64_t n);

// What a failure message ends with: the seed and the spline in hexadecimal.
std::string where(uint64_t seed, const SplineData &data);

// The largest of two measures of the errors per degree, printed as a table on destruction.
class WorstErrors {
public:
    explicit WorstErrors(std::string title) : title_(std::move(title)) {}
    WorstErrors(const WorstErrors &) = delete;
    WorstErrors &operator=(const WorstErrors &) = delete;
    ~WorstErrors();
    // error / bound, and error / (eps * hull) (or another natural unit).
    void add(int degree, long double over_bound, long double over_unit);

private:
    struct Pair {
        long double over_bound = 0;
        long double over_unit = 0;
    };
    std::string title_;
    std::map<int, Pair> worst_;
};

} // namespace support
