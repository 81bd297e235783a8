// SPDX-License-Identifier: MIT
#include "pieces/frame.h"

#include "base/numbers.h"

#include <algorithm>

namespace nrb::pieces {

namespace {

// The range of coordinate c; lower > upper if there are no points.
Interval range_of(std::span<const Spline *const> splines, int c) {
    Interval range{infinity, -infinity};
    for (const Spline *given : splines) {
        const Spline &spline = given->effective();
        for (int64_t i = 0; i < spline.point_count(); ++i) {
            const double x = spline.coordinate(i, c);
            if (spline.weight(i) != 0 && std::isfinite(x)) {
                range = {std::min(range.lower, x), std::max(range.upper, x)};
            }
        }
    }
    return range;
}

// Half the length, which cannot overflow; the whole length where half of it would underflow.
double extent_of(const Interval &range) noexcept {
    const double half = range.upper / 2 - range.lower / 2;
    return half < 0x1p-1000 ? range.upper - range.lower : half;
}

} // namespace

Frame frame_of(std::span<const Spline *const> splines) {
    Frame frame;
    double extent = 0;
    for (int c = 0; c < splines.front()->dim(); ++c) {
        const Interval range = range_of(splines, c);
        const bool any = range.lower <= range.upper;
        frame.centre.push_back(any ? range.lower / 2 + range.upper / 2 : 0);
        extent = std::max(extent, any ? extent_of(range) : 0);
    }
    frame.exponent = extent > 0 ? std::ilogb(extent) + 1 : 0;
    return frame;
}

} // namespace nrb::pieces
