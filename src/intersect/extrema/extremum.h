// SPDX-License-Identifier: MIT
// Extrema, saddles and plateaus of a scalar spline.
#pragma once

#include "spline/part.h"

#include <algorithm>
#include <cstdint>
#include <vector>

namespace nrb::intersect {

// Bit flags.
namespace extremum_kind {
inline constexpr uint32_t minimum = 1, maximum = 2, saddle = 4, plateau = 8, undecided = 16;
}

// The extremum lies in the range; a plateau is a range on which f is constant. On periodic axes ranges may
// leave the domain.
struct Extremum {
    std::array<double, max_axes> at{};
    Part range{};
    double value = 0;
    uint32_t kinds = 0;
};

// There are no extrema outside of the ranges.
struct Extrema {
    std::vector<Extremum> list;
    [[nodiscard]] bool complete() const noexcept {
        return std::ranges::none_of(
            list, [](const Extremum &x) { return (x.kinds & extremum_kind::undecided) != 0; });
    }
};

// The kind of extremum along one axis. 1 or -1: f rises or falls before the place, and after it.
inline uint32_t turn_of(int before, int after) noexcept {
    return before == after ? extremum_kind::saddle
           : before > 0    ? extremum_kind::maximum
                           : extremum_kind::minimum;
}

} // namespace nrb::intersect
