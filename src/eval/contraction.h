// The tensor product: one axis after the other is contracted with its basis functions, axis 0 first, and
// every order of derivative that is still needed is kept. Points and grids share these steps and hence every
// bit of their results.
#pragma once

#include "eval/axis_basis.h"
#include "eval/slots.h"
#include "spline/contract.h"

#include <array>
#include <span>

namespace nrb {

// Calls step(source, order, target) for every partial derivative kept after axis `level`: `source` is the
// index of what was kept after the axes before, `target` its own, both in graded order of the axes seen so
// far.
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

// What the contraction of each axis leaves: kept[k] arrays of length[k] doubles after axis k. The last length
// is the width of a record.
struct Slabs {
    std::array<double *, max_axes> data{};
    std::array<int64_t, max_axes> length{};
};

// Part of a slab.
struct Stretch {
    int64_t offset;
    int64_t length;
};

// Contracts axis `level` of the slabs before it (level >= 1), over the given stretches of each row. Row r of
// the axis is length[level] doubles; the active rows begin at row `first`.
inline void contract_level(int level, int order, int degree, const AxisBasis &basis, int64_t first,
                           const Slabs &slabs, std::span<const Stretch> stretches) noexcept {
    const auto at = static_cast<size_t>(level);
    const int64_t length = slabs.length[at];
    for_each_step(level, order, [&](int64_t source, int a, int64_t target) {
        const double *rows = slabs.data[at - 1] + source * slabs.length[at - 1] + first * length;
        for (const Stretch &stretch : stretches) {
            contract(basis.values + static_cast<int64_t>(a) * (degree + 1), degree + 1, rows + stretch.offset,
                     length, stretch.length, slabs.data[at] + target * length + stretch.offset);
        }
    });
}

} // namespace nrb
