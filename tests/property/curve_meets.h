// Meets of curves through the C interface, for tests.
#pragma once

#include "support/handle.h"
#include "support/spline_data.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <vector>

namespace curve_meets {

using namespace support;

using Vec = std::vector<double>;

struct Hits {
    Vec a, b, ranges_a, ranges_b;
    std::vector<int32_t> kinds;
    int32_t complete = -1;

    [[nodiscard]] size_t size() const { return a.size(); }
    [[nodiscard]] int64_t count(int32_t kind) const { return std::count(kinds.begin(), kinds.end(), kind); }
};

// ask(cap, params_a, params_b, kinds, ranges_a, ranges_b, count, complete)
template <class Ask>
Hits hits_of(Ask &&ask) {
    Hits h;
    int64_t count = -1;
    require_ok(ask(int64_t{0}, nullptr, nullptr, nullptr, nullptr, nullptr, &count, &h.complete));
    const auto n = static_cast<size_t>(count);
    h.a.resize(n);
    h.b.resize(n);
    h.ranges_a.resize(2 * n);
    h.ranges_b.resize(2 * n);
    h.kinds.resize(n);
    require_ok(ask(count, h.a.data(), h.b.data(), h.kinds.data(), h.ranges_a.data(), h.ranges_b.data(),
                   &count, &h.complete));
    EXPECT_TRUE(std::is_sorted(h.a.begin(), h.a.end()));
    return h;
}

inline Hits meets(const nurbs *a, const nurbs *b, double tolerance) {
    return hits_of([&](auto... rest) { return nurbs_curve_intersections(a, b, tolerance, rest...); });
}
inline Hits meets(const Handle &a, const Handle &b, double tolerance) {
    return meets(a.get(), b.get(), tolerance);
}
inline Hits own_meets(const nurbs *g, double tolerance) {
    return hits_of([&](auto... rest) { return nurbs_curve_self_intersections(g, tolerance, rest...); });
}

inline Vec point_of(const nurbs *g, double t) {
    int32_t dim = 0;
    require_ok(nurbs_dimension(g, &dim));
    Vec x(static_cast<size_t>(dim));
    require_ok(nurbs_eval(g, 1, &t, 0, 0, x.data(), 0, 0, 0));
    return x;
}
inline double gap_of(const nurbs *a, double s, const nurbs *b, double t) {
    const Vec x = point_of(a, s), y = point_of(b, t);
    double square = 0;
    for (size_t c = 0; c < x.size(); ++c) {
        square += (x[c] - y[c]) * (x[c] - y[c]);
    }
    return std::sqrt(square);
}

inline SplineData bezier(int dim, Vec points, Vec weights = {}) {
    const auto p = static_cast<int32_t>(points.size()) / dim - 1;
    SplineData data{{p}, {p + 1}, {{}}, dim, std::move(points), std::move(weights), 0};
    data.knots[0].assign(static_cast<size_t>(p) + 1, 0.0);
    data.knots[0].insert(data.knots[0].end(), static_cast<size_t>(p) + 1, 1.0);
    return data;
}

// A polygon of the plane over [0, corners - 1].
inline SplineData polygon(Vec points) {
    const auto count = static_cast<int64_t>(points.size() / 2);
    SplineData data{{1}, {count}, {{0}}, 2, std::move(points), {}, 0};
    for (int64_t i = 0; i < count; ++i) {
        data.knots[0].push_back(static_cast<double>(i));
    }
    data.knots[0].push_back(static_cast<double>(count - 1));
    return data;
}

inline Handle circle(double x, double y, double radius) {
    const double at[] = {x, y};
    nurbs *out = nullptr;
    require_ok(nurbs_curve_circle(2, at, nullptr, nullptr, radius, NURBS_ARC_QUARTERS, &out));
    return Handle(out);
}

} // namespace curve_meets
