// SPDX-License-Identifier: MIT
// The tensor product: the net is contracted with the basis functions of one axis after the other, axis 0
// first. After each axis, every derivative that is still needed is kept. Points and grids share these steps,
// and therefore every bit of their results.
#pragma once

#include "eval/kernels/slots.h"

#include <array>

namespace nrb::eval {

// Calls step(source, a, target) for every partial derivative that is kept after axis `level`. It is made from
// slot `source` of what was kept after the axes before, by derivative a of the functions of this axis, and
// becomes slot `target`. Slots are in graded order of the axes seen so far.
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

// The length rounded up to a multiple of 4, for whole vectors.
constexpr int64_t padded(int64_t length) noexcept {
    return (length + 3) / 4 * 4;
}

// The intermediate results of the contraction, one slab for each axis but the last. After axis k, data[k]
// holds an array of length[k] doubles for each slot that is kept. Such an array consists of the rows of axis
// k + 1, of length[k + 1] doubles each; the length for the last axis is the width of a record.
struct Slabs {
    std::array<double *, max_axes> data{};
    std::array<int64_t, max_axes> length{};
};

} // namespace nrb::eval
