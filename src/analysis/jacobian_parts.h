// SPDX-License-Identifier: MIT
// Parts of the pieces of a spline on which a determinant of first derivatives is examined.
#pragma once

#include "pieces/derivative_pieces.h"

#include <deque>
#include <limits>
#include <optional>

namespace nrb::analysis {

// A polynomial on a part of a piece; from and to are places between 0 and 1 on the axes of the spline.
struct JacobianPart {
    RoundedPolynomial f;
    size_t piece = 0;
    std::array<double, max_axes> from{};
    std::array<double, max_axes> to{1, 1, 1};
};

// The boundaries of a piece that a polynomial was divided by, lower and upper of each axis.
using BoundaryZeros = std::array<std::array<bool, 2>, max_axes>;
// Divides by the boundaries on which all coefficients vanish to rounding, as often as they do.
BoundaryZeros divide_boundaries(RoundedPolynomial &f, int axes);

// Parts that wait to be examined, from the largest to the smallest.
class PartQueue {
public:
    explicit PartQueue(int axes) : axes_(axes) {} // an empty deque allocates

    // No more are halved than so many.
    void limit(int64_t halvings) noexcept { most_ = halvings; }
    void add(JacobianPart part);
    [[nodiscard]] bool empty() const noexcept { return parts_.empty(); }
    [[nodiscard]] size_t size() const noexcept { return parts_.size(); }
    // Precondition: not empty.
    JacobianPart take();
    // Adds the halves of a part, which is cut along the axis on which it is longest, in units of `scale`,
    // among the axes with a degree. False, with the part unchanged, if no side is longer than `least`, or if
    // as many parts have been halved as memory allows.
    bool halve(JacobianPart &part, const std::array<double, max_axes> &scale, double least);

private:
    int axes_;
    int64_t most_ = std::numeric_limits<int64_t>::max();
    std::optional<int64_t> halvings_; // that memory allows, less those made
    std::deque<JacobianPart> parts_;
};

} // namespace nrb::analysis
