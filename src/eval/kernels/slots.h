// SPDX-License-Identifier: MIT
// The graded order of partial derivatives, in which they are stored: by total order, then by the order along
// the later axes. A derivative's place in this order is its slot.
#pragma once

#include "spline/spline.h"

#include <algorithm>
#include <array>
#include <cstdint>

namespace nrb::eval {

// The number of partial derivatives of total orders 0 to `order`: binomial(order + axes, axes).
constexpr int64_t slot_count(int axes, int64_t order) noexcept {
    switch (axes) {
    case 1:
        return order + 1;
    case 2:
        return (order + 1) * (order + 2) / 2;
    default:
        return (order + 1) * (order + 2) * (order + 3) / 6;
    }
}

// The slot of the derivative of orders (i, j, k). Axes that the spline lacks have order 0.
constexpr int64_t slot(int axes, int64_t i, int64_t j = 0, int64_t k = 0) noexcept {
    const int64_t later = axes == 3 ? slot_count(2, j + k - 1) + k : j;
    return slot_count(axes, i + j + k - 1) + later;
}

// The orders of a partial derivative along the axes. Axes that the spline lacks have order 0.
using Orders = std::array<int, max_axes>;

inline int64_t slot(int axes, const Orders &a) noexcept {
    return slot(axes, a[0], a[1], a[2]);
}

// Calls visit(i, j, k) with the orders of every slot, in increasing order of slots.
template <class Visit>
constexpr void for_each_slot(int axes, int order, Visit &&visit) {
    for (int total = 0; total <= order; ++total) {
        for (int later = 0; later <= (axes > 1 ? total : 0); ++later) {
            for (int last = 0; last <= (axes > 2 ? later : 0); ++last) {
                visit(total - later, later - last, last);
            }
        }
    }
}

} // namespace nrb::eval
