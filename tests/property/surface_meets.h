// Meets of curves and surfaces through the C interface, for tests.
#pragma once

#include "curve_meets.h"

#include <array>
#include <limits>

namespace surface_meets {

using namespace support;
using curve_meets::bezier;
using curve_meets::point_of;
using curve_meets::Vec;

struct Hits {
    Vec t, uv, ranges_curve, ranges_surface;
    std::vector<int32_t> kinds;
    int32_t complete = -1;

    [[nodiscard]] size_t size() const { return t.size(); }
    [[nodiscard]] int64_t count(int32_t kind) const { return std::count(kinds.begin(), kinds.end(), kind); }
};

// `work`: the limit; 0: none of its own.
inline Hits meets(const nurbs *curve, const nurbs *surface, double tolerance, int64_t work = 0) {
    Hits h;
    int64_t count = -1;
    nurbs_call_options call;
    require_ok(nurbs_call_options_init(&call, sizeof call));
    call.work = work;
    const auto ask = [&](int64_t cap) {
        require_ok(nurbs_curve_surface_intersections_with(
            curve, surface, tolerance, cap, h.t.data(), h.uv.data(), h.kinds.data(), h.ranges_curve.data(),
            h.ranges_surface.data(), &count, &h.complete, &call));
    };
    ask(0);
    const auto n = static_cast<size_t>(count);
    h.t.resize(n);
    h.uv.resize(2 * n);
    h.ranges_curve.resize(2 * n);
    h.ranges_surface.resize(4 * n);
    h.kinds.resize(n);
    ask(count);
    EXPECT_TRUE(std::is_sorted(h.t.begin(), h.t.end()));
    return h;
}
inline Hits meets(const Handle &curve, const Handle &surface, double tolerance) {
    return meets(curve.get(), surface.get(), tolerance);
}

inline Vec point_at(const nurbs *surface, const double *uv, uint32_t flags = 0) {
    Vec x(3);
    require_ok(nurbs_eval(surface, 1, uv, 0, 0, x.data(), 0, 0, flags));
    return x;
}
inline double distance(const Vec &x, const Vec &y) {
    return std::hypot(x[0] - y[0], x[1] - y[1], x[2] - y[2]);
}
// At jumps from the nearest sides.
inline double gap_of(const nurbs *curve, double t, const nurbs *surface, const double *uv) {
    double least = HUGE_VAL;
    for (uint32_t sides = 0; sides < 8; ++sides) {
        Vec x(3);
        require_ok(nurbs_eval(curve, 1, &t, 0, 0, x.data(), 0, 0, (sides >> 2) * NURBS_LEFT));
        const uint32_t flags =
            (sides & 1U) * NURBS_ON_AXIS(0, NURBS_LEFT) + (sides >> 1 & 1U) * NURBS_ON_AXIS(1, NURBS_LEFT);
        least = std::min(least, distance(x, point_at(surface, uv, flags)));
    }
    return least;
}
inline double size_of(const SplineData &data) {
    double size = 0;
    for (const double x : data.points) {
        size = std::max(size, std::abs(x));
    }
    return size;
}

// What rounding a parameter moves a point by: weights of a ratio of 100 make it 100 times as fast at most.
inline double noise_of(const SplineData &data) {
    double share = 1e-11;
    for (size_t k = 0; k < data.knots.size(); ++k) {
        double shortest = HUGE_VAL, largest = 0;
        const Vec &knots = data.knots[k];
        for (size_t i = 0; i + 1 < knots.size(); ++i) {
            shortest = knots[i + 1] > knots[i] ? std::min(shortest, knots[i + 1] - knots[i]) : shortest;
            largest = std::max(largest, std::abs(knots[i + 1]));
        }
        share += 400 * data.degrees[k] * std::numeric_limits<double>::epsilon() * largest / shortest;
    }
    return share * size_of(data);
}
// Where weights all but vanish, parameters have no digits for the place.
inline bool has_even_weights(const SplineData &data) {
    return std::ranges::all_of(data.weights, [](double w) { return w > 0.1 && w < 10; });
}

inline SplineData patch(int32_t p, int32_t q, Vec points, Vec weights = {}) {
    SplineData data{{p, q}, {p + 1, q + 1}, {{}, {}}, 3, std::move(points), std::move(weights), 0};
    for (size_t k = 0; k < 2; ++k) {
        const auto order = static_cast<size_t>(data.counts[k]);
        data.knots[k].assign(order, 0.0);
        data.knots[k].insert(data.knots[k].end(), order, 1.0);
    }
    return data;
}

inline Handle sphere() {
    return made([](nurbs **out) {
        return nurbs_surface_sphere(nullptr, nullptr, nullptr, 1, NURBS_ARC_QUARTERS, out);
    });
}
inline Handle line(const Vec &a, const Vec &b) {
    return made([&](nurbs **out) { return nurbs_curve_line(3, a.data(), b.data(), out); });
}

} // namespace surface_meets
