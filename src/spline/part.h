// SPDX-License-Identifier: MIT
// Boxes of parameters.
#pragma once

#include "spline/spline.h"

#include <array>

namespace nrb::inline spline {

// An interval for each axis; those of axes that a spline lacks are not read.
using Part = std::array<Interval, max_axes>;

inline Part whole_domain(const Spline &spline) noexcept {
    Part part{};
    for (int k = 0; k < spline.axes(); ++k) {
        part[static_cast<size_t>(k)] = spline.axis(k).domain();
    }
    return part;
}

inline bool same(Interval a, Interval b) noexcept {
    return a.lower == b.lower && a.upper == b.upper;
}

} // namespace nrb::inline spline
