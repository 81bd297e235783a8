// SPDX-License-Identifier: MIT
// The tensor product: one axis after the other is contracted with its basis functions, axis 0 first, and
// every order of derivative that is still needed is kept. Points and grids share these steps and hence every
// bit of their results.
#pragma once

#include "eval/kernels/slots.h"

#include <array>

namespace nrb::eval {

// Calls step(source, order, target) for every partial derivative kept after axis `level`: `source` is the
// index of what was kept after the axes before, `target` its own index, both in graded order of the axes seen
// so far.
template <class Step>
void for_each_step(int level, int order, Step &&step) {
    if (level == 0) {
        for (int a = 0; a <= order; ++a) {
            step(int64_t{0}, a, int64_t{a});
        }
        return;
    }
    for_each_slot(level, order, [&](int i, int j, int k) {
        const int64_t source = slot(level, i, j, k);
        for (int a = 0; a <= order - i - j - k; ++a) {
            step(source, a, level == 1 ? slot(2, i, a) : slot(3, i, j, a));
        }
    });
}

// The next multiple of 4, a length that suits vectors.
constexpr int64_t padded(int64_t length) noexcept {
    return (length + 3) / 4 * 4;
}

// What the contraction of each axis but the last leaves: kept[k] arrays of length[k] doubles after axis k.
// Row r of axis k + 1 is length[k + 1] doubles of such an array; the last length is the width of a record.
struct Slabs {
    std::array<double *, max_axes> data{};
    std::array<int64_t, max_axes> length{};
};

} // namespace nrb::eval
