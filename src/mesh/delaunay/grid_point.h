// SPDX-License-Identifier: MIT
// Points of an integer grid, with exact predicates for orientation and for circles, in integer arithmetic.
#pragma once

#include "numeric/exact_sum.h"

#include <cstdint>

namespace nrb::mesh {

// Both coordinates from 0 to grid_end.
struct GridPoint {
    int32_t u = 0, v = 0;
    friend bool operator==(const GridPoint &, const GridPoint &) = default;
};
inline constexpr int32_t grid_end = int32_t{1} << 30;

// Twice the signed area of the triangle, positive if it is counterclockwise: a difference of two products of
// at most 60 bits.
inline int64_t orientation(const GridPoint &a, const GridPoint &b, const GridPoint &c) noexcept {
    return int64_t{b.u - a.u} * (c.v - a.v) - int64_t{b.v - a.v} * (c.u - a.u);
}

// (b - a) . (c - a): positive if the angle at a is acute.
inline int64_t scalar_product(const GridPoint &a, const GridPoint &b, const GridPoint &c) noexcept {
    return int64_t{b.u - a.u} * (c.u - a.u) + int64_t{b.v - a.v} * (c.v - a.v);
}

// A metric in which the square of a length is uu u^2 + vv v^2: its circles are ellipses with axes along u and
// v. Precondition: 0 < uu, vv <= most.
struct GridMetric {
    int32_t uu = 1, vv = 1;
    static constexpr int32_t most = int32_t{1} << 30;
    friend bool operator==(const GridMetric &, const GridMetric &) = default;
};

// Whether p lies strictly inside the circle through a counterclockwise triangle: the sign of a sum of three
// products of at most 122 bits.
inline bool in_circle(const GridPoint &a, const GridPoint &b, const GridPoint &c,
                      const GridPoint &p) noexcept {
    const auto lifted = [](int64_t u, int64_t v) { return u * u + v * v; };
    const int64_t au = a.u - p.u, av = a.v - p.v, bu = b.u - p.u, bv = b.v - p.v, cu = c.u - p.u,
                  cv = c.v - p.v;
    Int128 sum = Int128::product(lifted(au, av), bu * cv - bv * cu);
    sum += Int128::product(lifted(bu, bv), cu * av - cv * au);
    sum += Int128::product(lifted(cu, cv), au * bv - av * bu);
    return sum.high() > 0 || (sum.high() == 0 && sum.low() > 0);
}

// The same for a circle of a metric. Squares of lengths have up to 91 bits, and are multiplied in two parts:
// the low 32 bits, and those above.
inline bool in_circle(const GridMetric &metric, const GridPoint &a, const GridPoint &b, const GridPoint &c,
                      const GridPoint &p) noexcept {
    const int64_t au = a.u - p.u, av = a.v - p.v, bu = b.u - p.u, bv = b.v - p.v, cu = c.u - p.u,
                  cv = c.v - p.v;
    Int128 high, low;
    const auto add = [&](int64_t u, int64_t v, int64_t area) {
        Int128 square = Int128::product(metric.uu, u * u);
        square += Int128::product(metric.vv, v * v);
        high += Int128::product(square.high() << 32 | static_cast<int64_t>(square.low() >> 32), area);
        low += Int128::product(static_cast<int64_t>(square.low() & 0xffffffffU), area);
    };
    add(au, av, bu * cv - bv * cu);
    add(bu, bv, cu * av - cv * au);
    add(cu, cv, au * bv - av * bu);
    ExactSum sum;
    sum.add(high, 32);
    sum.add(low, 0);
    return !sum.negative() && !sum.zero();
}

} // namespace nrb::mesh
