// SPDX-License-Identifier: MIT
// Parts of Bezier pieces of a surface or of a curve, the cells that the search for feet subdivides.
#pragma once

#include "intersect/projection/feet/feet_net.h"

#include <deque>

namespace nrb::intersect {

// A part of a FeetNet, made by repeated halving along its axes. 'Places' are coordinates in [0, 1] of a part
// or piece.
class FeetCell {
public:
    explicit FeetCell(const FeetNet &net) : net_(&net) {}

    [[nodiscard]] const FeetNet &net() const noexcept { return *net_; }
    [[nodiscard]] const CrossPiece &piece() const noexcept { return *net_->piece; }
    [[nodiscard]] double lower(size_t axis) const noexcept { return lower_[axis]; } // in [0, 1]
    [[nodiscard]] double length(size_t axis) const noexcept { return length_[axis]; }
    [[nodiscard]] Interval places(size_t axis) const noexcept { return {lower_[axis], upper_[axis]}; }
    [[nodiscard]] std::array<double, 2> in_piece(const std::array<double, 2> &place) const noexcept {
        return {lower_[0] + length_[0] * place[0], lower_[1] + length_[1] * place[1]};
    }
    // Where its box ends, as a place in the part: a little off the side of the part, see side_shifts.
    [[nodiscard]] double side(size_t axis, size_t end) const noexcept;
    // Whether a side of the part lies on a side of the piece.
    [[nodiscard]] bool is_border(size_t axis, size_t end) const noexcept {
        return end == 0 ? lower_[axis] == 0 : upper_[axis] == 1;
    }
    [[nodiscard]] bool is_open(size_t axis, size_t end) const noexcept {
        return is_border(axis, end) && piece().open[axis][end];
    }
    // How far beyond its box an arc that runs along a side may be, in lengths of the part; 0 for sides inside
    // the piece.
    [[nodiscard]] double room(size_t axis, size_t end) const noexcept;
    // In parameters of the spline.
    [[nodiscard]] Interval range(size_t axis) const noexcept;
    [[nodiscard]] int halvings() const noexcept { return halvings_; }

    // Bernstein coefficients over the wide part (widened by `widening` on all sides): [width][coefficients].
    [[nodiscard]] const std::vector<double> &wide();
    // The factor by which rounding of the net may grow in the wide part, where that reaches beyond the piece.
    [[nodiscard]] double amplified() const noexcept;

    // Makes the halves, unless they exist, along `axis` or, if its degree is 0, the other axis; false: it is
    // too small.
    bool split(size_t axis, std::deque<FeetCell> &all);
    [[nodiscard]] FeetCell *half(size_t end) const noexcept { return halves_[end]; }

private:
    const FeetNet *net_;
    std::array<double, 2> lower_{0, 0}, upper_{1, 1}, length_{1, 1};
    int halvings_ = 0;
    std::vector<double> wide_;
    std::array<FeetCell *, 2> halves_{};
};

} // namespace nrb::intersect
