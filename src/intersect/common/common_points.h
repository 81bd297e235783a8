// SPDX-License-Identifier: MIT
// The points that three surfaces have in common.
#pragma once

#include "intersect/hits.h"
#include "spline/spline.h"

#include <array>

namespace nrb::intersect {

// Parameters u, v of each of the three, one after the other.
struct CommonPoint {
    std::array<double, 6> at{};
    std::array<Interval, 6> range{};
    std::array<double, 3> point{};
    HitKind kind = HitKind::crossing; // or undecided, about the middle of what is left open
};

// By rising parameters of the first one. There are no others outside of the ranges.
struct CommonPoints {
    std::vector<CommonPoint> list;
    [[nodiscard]] bool complete() const noexcept {
        return std::ranges::none_of(list, [](const CommonPoint &x) { return x.kind == HitKind::undecided; });
    }
};

// tolerance: the size in space of parts that need not be told apart, >= 0. Precondition: surfaces in space.
CommonPoints common_points(const std::array<const Spline *, 3> &surfaces, double tolerance);

} // namespace nrb::intersect
