// SPDX-License-Identifier: MIT
// Symmetric matrices over the control points of a spline, which couple those whose functions overlap.
#pragma once

#include "base/limits.h"
#include "basis/knot_vector.h"
#include "numeric/double_double.h"
#include "numeric/solvers/sparse/sparse_ldlt.h"

#include <array>
#include <cstdint>
#include <vector>

namespace nrb::fit {

using Index = std::array<int64_t, max_axes>;

// Calls visit(index) for those from `first` on, counts[k] along each axis, last axis fastest.
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

// Unknowns are the distinct layers of control points on each axis, last axis fastest. An element is kept at the first of its
// two functions and the offset to the second one, counted in layers before these are wrapped; half of the offsets will do.
class StencilMatrix {
public:
    // An element for each pair of layers that are not farther apart than the degree, or than `least_reach`.
    explicit StencilMatrix(const std::vector<KnotVectorPtr> &axes, const Index &least_reach = {});

    [[nodiscard]] int axes() const noexcept { return axes_; }
    [[nodiscard]] int64_t size() const noexcept { return counts_[0] * counts_[1] * counts_[2]; }
    // The number of the unknown that a control point is, or is a copy of.
    [[nodiscard]] int64_t unknown(const Index &layer) const noexcept;
    // Adds to the element of two control points, and to its mirror image; `second` is not before `first`.
    void add(const Index &first, const Index &second, const DoubleDouble &value) noexcept;
    // factor times a matrix of the same pattern.
    void add_multiple(double factor, const StencilMatrix &other) noexcept;
    [[nodiscard]] DoubleDouble trace() const noexcept;
    // Of the diagonal; 1 where that is 0.
    [[nodiscard]] DoubleDouble mean() const noexcept;

    // In which order to eliminate the unknowns.
    [[nodiscard]] std::vector<int64_t> elimination_order() const;
    // By columns in that order; with all elements that overlapping functions can have, 0 or not.
    [[nodiscard]] ColumnsOf<DoubleDouble> columns(const std::vector<int64_t> &order) const;

private:
    // Calls visit(other unknown, place) for the offsets of an unknown, that of itself first.
    template <class Visit>
    void for_each_offset(int64_t row, Visit &&visit) const;

    int axes_;
    Index counts_{1, 1, 1};
    Index reach_{};
    std::array<bool, max_axes> periodic_{};
    int64_t offsets_; // of an unknown
    std::vector<DoubleDouble> values_;
};

} // namespace nrb::fit
