// SPDX-License-Identifier: MIT
// The points that three surfaces have in common.
#pragma once

#include "intersect/hits.h"
#include "spline/spline.h"

#include <array>

namespace nrb::intersect {

// `at` and `range`: parameters u, v on each of the three surfaces in turn.
struct CommonPoint {
    std::array<double, 6> at{};
    std::array<Interval, 6> range{};
    std::array<double, 3> point{};
    HitKind kind = HitKind::crossing; // undecided: `at` is about the middle of a range left open
};

// In ascending order of the parameters on the first surface. The ranges hold all common points.
struct CommonPoints {
    std::vector<CommonPoint> list;
    [[nodiscard]] bool complete() const noexcept {
        return std::ranges::none_of(list, [](const CommonPoint &x) { return x.kind == HitKind::undecided; });
    }
};

// tolerance >= 0: the size in space below which parts need not be distinguished. Precondition: surfaces in
// space.
CommonPoints common_points(const std::array<const Spline *, 3> &surfaces, double tolerance);

} // namespace nrb::intersect
