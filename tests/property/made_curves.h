// Curves that constructors make, anywhere and of any size.
#pragma once

#include "reference/number.h"
#include "support/cases.h"
#include "support/handle.h"

#include <array>
#include <cmath>
#include <gtest/gtest.h>
#include <numbers>

namespace support::curves {

inline constexpr double double_eps = 0x1p-52;
inline constexpr double pi = std::numbers::pi;
using Vec = std::vector<double>;

inline Vec random_vector(Random &random, int dim, double size) {
    Vec v;
    for (int c = 0; c < dim; ++c) {
        v.push_back(random.between(-size, size));
    }
    return v;
}

inline long double length(const std::vector<long double> &v) {
    long double sum = 0;
    for (const long double x : v) {
        sum += x * x;
    }
    return std::sqrt(sum);
}

inline double largest(const Vec &v) {
    double size = 0;
    for (const double x : v) {
        size = std::max(size, std::fabs(x));
    }
    return size;
}

inline Vec random_params(Random &random, int n) {
    Vec params = {0, 1};
    for (int i = 2; i < n; ++i) {
        params.push_back(random.unit());
    }
    return params;
}

inline double size_of(const nurbs *g) {
    return largest(read_back(g).points);
}

} // namespace support::curves
