// SPDX-License-Identifier: MIT
// The sparsity pattern of a symmetric matrix over the control points of a spline.
#pragma once

#include "base/limits.h"
#include "basis/knot_vector.h"

#include <array>
#include <cstdint>
#include <vector>

namespace nrb::fit {

using Index = std::array<int64_t, max_axes>;

// Calls visit(index) for the indices from `first` on, counts[k] of them along axis k, last axis fastest.
template <class Visit>
void for_each_index(const Index &first, const Index &counts, Visit &&visit) {
    for (int64_t i = 0; i < counts[0]; ++i) {
        for (int64_t j = 0; j < counts[1]; ++j) {
            for (int64_t k = 0; k < counts[2]; ++k) {
                visit(Index{first[0] + i, first[1] + j, first[2] + k});
            }
        }
    }
}

// Unknowns are the distinct layers of control points on each axis, last axis fastest. An element is stored
// with the first of its two functions, at the offset to the second one, which is counted in layers before
// wrapping. By symmetry half of the offsets are enough.
class StencilPattern {
public:
    // Has an element for each pair of layers that are no farther apart than the degree of their axis, or than
    // `least_reach` if that is more.
    explicit StencilPattern(const std::vector<KnotVectorPtr> &axes, const Index &least_reach = {});

    [[nodiscard]] int axes() const noexcept { return axes_; }
    [[nodiscard]] int64_t size() const noexcept { return counts_[0] * counts_[1] * counts_[2]; }
    [[nodiscard]] int64_t elements() const noexcept { return size() * offsets_; }
    // The number of the unknown that a control point is, or is a periodic copy of.
    [[nodiscard]] int64_t unknown(const Index &layer) const noexcept;
    // start(): where the elements of an unknown begin, with its diagonal element. step(): how far after that
    // the element of a pair is stored; `second` is not before `first`.
    [[nodiscard]] int64_t start(int64_t unknown) const noexcept { return unknown * offsets_; }
    [[nodiscard]] int64_t step(const Index &first, const Index &second) const noexcept;
    // Calls visit(first unknown, second unknown, place) for all stored elements. On short periodic axes a
    // pair may have several elements. So may an unknown with itself; all of these but the first then stand
    // for their mirror images as well.
    template <class Visit>
    void for_each_element(Visit &&visit) const;

    // A fill-reducing order in which to eliminate the unknowns.
    [[nodiscard]] std::vector<int64_t> elimination_order() const;

private:
    // The unknown at an offset from `own`; -1 outside the grid.
    [[nodiscard]] int64_t neighbour(const Index &own, const Index &offset) const noexcept;
    // To the next offset, in the order of places in a full stencil.
    void advance(Index &offset) const noexcept;

    int axes_;
    Index counts_{1, 1, 1};
    Index reach_{};
    std::array<bool, max_axes> periodic_{};
    int64_t offsets_; // for each unknown
};

template <class Visit>
void StencilPattern::for_each_element(Visit &&visit) const {
    int64_t row = 0;
    for_each_index({}, counts_, [&](const Index &own) {
        Index offset{};
        for (int64_t place = start(row); place < start(row + 1); ++place, advance(offset)) {
            if (const int64_t other = neighbour(own, offset); other >= 0) {
                visit(row, other, place);
            }
        }
        ++row;
    });
}

} // namespace nrb::fit
