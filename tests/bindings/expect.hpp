/* SPDX-License-Identifier: MIT */
// What the tests of the C++ wrapper share: counted failures, comparison of values, statuses of calls.
#ifndef TESTS_BINDINGS_EXPECT_HPP
#define TESTS_BINDINGS_EXPECT_HPP

#include <nurbs/nurbs.hpp>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <limits>
#include <numbers>
#include <vector>

using Values = std::vector<double>;

inline constexpr double eps = std::numeric_limits<double>::epsilon();
inline constexpr double infinity = std::numeric_limits<double>::infinity();
inline constexpr double nan_value = std::numeric_limits<double>::quiet_NaN();
inline constexpr double pi = std::numbers::pi;

inline int failures = 0;

inline void expect(bool condition, const char *what, const char *file, int line) {
    if (!condition) {
        std::cout << file << ":" << line << ": " << what << "\n";
        ++failures;
    }
}
#define EXPECT(condition) expect((condition), #condition, __FILE__, __LINE__)

inline bool near(const Values &a, const Values &b, double by = 1e-12) {
    return std::ranges::equal(a, b, [by](double x, double y) { return std::abs(x - y) <= by; });
}

#ifndef NURBS_CPP_RESULTS
// The error that a call throws; success if it throws none.
template <class F>
libnurbs::Error error_of(F &&f) {
    try {
        f();
    } catch (const libnurbs::Error &error) {
        return error;
    }
    return {libnurbs::Status::ok, ""};
}

template <class F>
libnurbs::Status status_of(F &&f) {
    return error_of(f).status();
}
#endif

#endif // TESTS_BINDINGS_EXPECT_HPP
