// SPDX-License-Identifier: MIT
// A queue of parts of pieces on which the sign of a determinant of first derivatives is examined by
// subdivision.
#pragma once

#include "pieces/derivative_pieces.h"

#include <deque>
#include <limits>
#include <optional>

namespace nrb::analysis {

// A polynomial on a part of a piece. from, to: places in [0, 1] on the axes of the spline.
struct JacobianPart {
    RoundedPolynomial f;
    size_t piece = 0;
    std::array<double, max_axes> from{};
    std::array<double, max_axes> to{1, 1, 1};
};

// By which boundaries of a piece a polynomial was divided: the lower and the upper one of each axis.
using BoundaryZeros = std::array<std::array<bool, 2>, max_axes>;
// Divides by the factors of boundaries on which all coefficients vanish to rounding, as often as they do.
BoundaryZeros divide_boundaries(RoundedPolynomial &f, int axes);

// Parts that are still to be examined, first in, first out: from the largest to the smallest.
class PartQueue {
public:
    explicit PartQueue(int axes) : axes_(axes) {} // an empty deque allocates memory

    // The most halvings that are still allowed.
    void limit(int64_t halvings) noexcept { most_ = halvings; }
    void add(JacobianPart part);
    [[nodiscard]] bool empty() const noexcept { return parts_.empty(); }
    [[nodiscard]] size_t size() const noexcept { return parts_.size(); }
    // Precondition: not empty.
    JacobianPart take();
    // Adds both halves of a part, halved along the axis of positive degree on which it is longest in units of
    // `scale`. Returns false, with the part unchanged, if no side is longer than `least`, or if the limit on
    // halvings, on memory or on work is reached.
    bool halve(JacobianPart &part, const std::array<double, max_axes> &scale, double least);

private:
    int axes_;
    int64_t most_ = std::numeric_limits<int64_t>::max();
    std::optional<int64_t> halvings_; // that memory still allows
    std::deque<JacobianPart> parts_;
};

} // namespace nrb::analysis
