// SPDX-License-Identifier: MIT
// Extrema of scalar splines as the tests of them read them.
#pragma once

#include "support/handle.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <vector>

namespace support {

inline constexpr uint32_t all_extrema = NURBS_EXTREMUM_MINIMUM | NURBS_EXTREMUM_MAXIMUM |
                                        NURBS_EXTREMUM_SADDLE | NURBS_EXTREMUM_PLATEAU |
                                        NURBS_EXTREMUM_UNDECIDED;

struct Extremum {
    std::vector<double> at, range; // [axes], [axes][2]
    double value = 0;
    int32_t kinds = 0;
};

struct Extrema {
    std::vector<Extremum> list;
    int32_t complete = -1;

    [[nodiscard]] int64_t count(int32_t kinds) const {
        return std::ranges::count(list, kinds, &Extremum::kinds);
    }
    // Minima less saddles plus maxima.
    [[nodiscard]] int64_t alternating() const {
        return count(NURBS_EXTREMUM_MINIMUM) - count(NURBS_EXTREMUM_SADDLE) + count(NURBS_EXTREMUM_MAXIMUM);
    }
    [[nodiscard]] bool has(int32_t kind) const {
        return std::ranges::any_of(list, [=](const Extremum &x) { return (x.kinds & kind) != 0; });
    }
};

inline Extrema extrema_of(const nurbs *g, int64_t work = 0, uint32_t kinds = all_extrema) {
    nurbs_call_options call;
    require_ok(nurbs_call_options_init(&call, sizeof call));
    call.work = work;
    Extrema result;
    int64_t count = -1;
    require_ok(
        nurbs_extrema_with(g, kinds, 0, nullptr, nullptr, nullptr, nullptr, &count, &result.complete, &call));
    int32_t number_of_axes = 0;
    require_ok(nurbs_axes(g, &number_of_axes));
    const auto n = static_cast<size_t>(count), axes = static_cast<size_t>(number_of_axes);
    std::vector<double> params(n * axes), values(n), ranges(2 * n * axes);
    std::vector<int32_t> found(n);
    require_ok(nurbs_extrema_with(g, kinds, count, params.data(), values.data(), found.data(), ranges.data(),
                                  &count, &result.complete, &call));
    for (size_t i = 0; i < n; ++i) {
        const auto at = params.begin() + static_cast<std::ptrdiff_t>(i * axes),
                   range = ranges.begin() + static_cast<std::ptrdiff_t>(2 * i * axes);
        result.list.push_back({{at, at + static_cast<std::ptrdiff_t>(axes)},
                               {range, range + static_cast<std::ptrdiff_t>(2 * axes)},
                               values[i],
                               found[i]});
    }
    EXPECT_EQ(result.complete, result.has(NURBS_EXTREMUM_UNDECIDED) ? 0 : 1);
    EXPECT_TRUE(std::ranges::is_sorted(result.list, {}, &Extremum::at));
    return result;
}

} // namespace support
