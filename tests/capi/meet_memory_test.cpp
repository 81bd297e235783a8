/* SPDX-License-Identifier: MIT */
// The memory that surfaces take to meet is bounded by the work that they may do: where they are all but one, cross in hundreds of
// curves that touch, or have no tangents.
#include "check.h"
#include "counted_memory.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <vector>

namespace {

constexpr double pi = 3.14159265358979323846;

// z = height(u, v) over [0, 1]^2, bicubic with n x n control points.
template <class Height>
nurbs *graph(int64_t n, Height &&height) {
    std::vector<double> knots, points;
    for (int axis = 0; axis < 2; ++axis) {
        for (int64_t i = -3; i <= n; ++i) {
            knots.push_back(static_cast<double>(std::clamp<int64_t>(i, 0, n - 3)) /
                            static_cast<double>(n - 3));
        }
    }
    for (int64_t i = 0; i < n; ++i) {
        for (int64_t j = 0; j < n; ++j) {
            const double u = static_cast<double>(i) / static_cast<double>(n - 1),
                         v = static_cast<double>(j) / static_cast<double>(n - 1);
            points.insert(points.end(), {u, v, height(u, v)});
        }
    }
    const int32_t degrees[] = {3, 3};
    const int64_t counts[] = {n, n};
    nurbs *g = nullptr;
    CHECK_INT(nurbs_create(2, degrees, counts, knots.data(), static_cast<int64_t>(knots.size()), 3,
                           points.data(), 0, 0, nullptr, 0, 0, &g),
              NURBS_OK);
    return g;
}

// n polylines of m corners in space.
nurbs *polylines(int64_t n, int64_t m) {
    std::vector<double> knots, points;
    for (int64_t i = 0; i <= n; ++i) {
        knots.push_back(static_cast<double>(i));
    }
    for (int64_t j = -1; j <= m; ++j) {
        knots.push_back(static_cast<double>(std::clamp<int64_t>(j, 0, m - 1)));
    }
    for (int64_t i = 0; i < 3 * n * m; ++i) {
        points.push_back(std::sin(1e4 * static_cast<double>(i * i % 997)));
    }
    const int32_t degrees[] = {0, 1};
    const int64_t counts[] = {n, m};
    nurbs *g = nullptr;
    CHECK_INT(nurbs_create(2, degrees, counts, knots.data(), static_cast<int64_t>(knots.size()), 3,
                           points.data(), 0, 0, nullptr, 0, 0, &g),
              NURBS_OK);
    return g;
}

struct Pair {
    const char *name;
    nurbs *a, *b;
    int32_t complete; // at the usual limit of work, which is more than any limit here
};

// Bytes at once, besides those that handles keep after their first call.
int64_t peak_of(const Pair &pair, int64_t work) {
    nurbs_call_options call;
    CHECK_INT(nurbs_call_options_init(&call, sizeof call), NURBS_OK);
    call.work = work;
    nurbs_meet *meet = nullptr;
    counted_memory::begin();
    CHECK_INT(nurbs_surface_intersections_with(pair.a, pair.b, 1e-9, &call, &meet), NURBS_OK);
    const int64_t peak = counted_memory::end();
    int32_t complete = -1;
    CHECK_INT(nurbs_meet_counts(meet, nullptr, nullptr, &complete), NURBS_OK);
    CHECK_INT(complete, work == 0 ? pair.complete : 0);
    nurbs_meet_destroy(meet);
    return peak;
}

void check(const Pair &pair) {
    constexpr int64_t few = 200000, usual = 400000000; // bytes
    peak_of(pair, 1);
    for (const int64_t work : {100000, 1000000, 10000000, 100000000}) {
        const int64_t peak = peak_of(pair, work);
        std::printf("%s, %lld multiply-adds: %lld bytes\n", pair.name, static_cast<long long>(work),
                    static_cast<long long>(peak));
        CHECK(peak <= few + work);
    }
    const int64_t most = peak_of(pair, 0);
    std::printf("%s, usual: %lld bytes\n", pair.name, static_cast<long long>(most));
    CHECK(most <= usual);
    nurbs_destroy(pair.a);
    nurbs_destroy(pair.b);
}

} // namespace

int main() {
    if (allocations_belong_to_a_sanitizer) {
        std::puts("skipped: the sanitizer replaces malloc itself");
        return 77;
    }
    const auto rough = [](double u, double v) { return 0.05 * std::sin(37 * u + 11 * v) * std::cos(29 * v); };
    const auto beside = [&](double by) {
        return graph(40, [=](double u, double v) { return rough(u, v) + by * std::sin(50 * u * v); });
    };
    check({"all but one", graph(40, rough), beside(1e-10), 0});
    check({"near each other", graph(40, rough), beside(1e-6), 0});
    check({"waves across waves", graph(60, [](double u, double) { return 0.1 * std::sin(20 * pi * u); }),
           graph(60, [](double, double v) { return 0.1 * std::sin(20 * pi * v); }), 1});
    check({"the same polylines", polylines(15, 66), polylines(15, 66), 0});
    return check_summary("meet_memory");
}
