// SPDX-License-Identifier: MIT
// Parts of domains: boxes in the parameter space.
#pragma once

#include "spline/spline.h"

#include <algorithm>
#include <array>

namespace nrb::inline spline {

// An interval for each axis. Those of axes that the spline lacks are not read.
using Part = std::array<Interval, max_axes>;

inline Part whole_domain(const Spline &spline) noexcept {
    Part part{};
    for (int k = 0; k < spline.axes(); ++k) {
        part[static_cast<size_t>(k)] = spline.axis(k).domain();
    }
    return part;
}

// The parameter at a relative position between 0 and 1 in an interval; 0 and 1 give its ends, bit for bit.
inline double parameter_in(Interval range, double place) noexcept {
    return std::clamp(range.lower * (1 - place) + range.upper * place, range.lower, range.upper);
}

inline bool same(Interval a, Interval b) noexcept {
    return a.lower == b.lower && a.upper == b.upper;
}

} // namespace nrb::inline spline
