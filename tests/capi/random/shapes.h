/* SPDX-License-Identifier: MIT */
// Random splines of at most a thousand control points, as users have them and as no one would wish to have them.
#ifndef NURBS_TESTS_CAPI_RANDOM_SHAPES_H
#define NURBS_TESTS_CAPI_RANDOM_SHAPES_H

#include <nurbs/nurbs.h>

#include <cstdint>
#include <random>

namespace random_calls {

class Random {
public:
    explicit Random(uint64_t seed) : engine_(seed) {}
    int below(int n) { return static_cast<int>(engine_() % static_cast<uint64_t>(n)); }
    bool one_in(int n) { return below(n) == 0; }
    double unit() { return static_cast<double>(engine_() >> 11) * 0x1p-53; }
    double between(double a, double b) { return a + (b - a) * unit(); }
    template <class T, size_t n>
    T any_of(const T (&values)[n]) {
        return values[below(static_cast<int>(n))];
    }

private:
    std::mt19937_64 engine_;
};

// With so many axes, in so many dimensions; never null.
nurbs *random_shape(Random &random, int32_t axes, int32_t dim);

} // namespace random_calls

#endif
