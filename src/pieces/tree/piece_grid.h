// SPDX-License-Identifier: MIT
// The Bezier pieces of a spline in a grid, computed on request.
//
// All coordinates are relative to the centre of the control points and divided by a power of two, so that the
// shape has a size near 1 whatever its unit; weights are divided by another power of two.
#pragma once

#include "pieces/bezier_net.h"
#include "pieces/tree/patch_kernel.h"
#include "pieces/tree/patch_squares.h"

#include <memory>
#include <vector>

namespace nrb::pieces {

class PieceGrid {
public:
    explicit PieceGrid(const Spline &spline);

    using Index = std::array<int64_t, max_axes>; // along the axes of the spline

    [[nodiscard]] const PatchShape &shape() const noexcept { return shape_; }
    [[nodiscard]] SquareTables tables() const noexcept { return squares_->tables(); }
    [[nodiscard]] int spline_axes() const noexcept { return axes_; }
    // The axis of the spline that corresponds to an axis of the shape.
    [[nodiscard]] int spline_axis(int k) const noexcept { return map_[static_cast<size_t>(k)]; }
    [[nodiscard]] int64_t count() const noexcept { return count_; }
    [[nodiscard]] int64_t count(int axis) const noexcept {
        return std::ssize(breaks_[static_cast<size_t>(axis)]) - 1;
    }
    [[nodiscard]] int64_t control_points() const noexcept { return counts_[0] * counts_[1] * counts_[2]; }
    // The coefficients of piece i. They are computed from the control points each time, because storing all
    // of them would take (p + 1)(q + 1) times the memory of the control points. work: as large as out.
    void patch(int64_t i, double *work, double *out) const noexcept;
    [[nodiscard]] Index index(int64_t piece) const noexcept;
    [[nodiscard]] int64_t piece(const Index &index) const noexcept;
    [[nodiscard]] double break_at(int axis, int64_t i) const noexcept {
        return breaks_[static_cast<size_t>(axis)][static_cast<size_t>(i)];
    }
    // Whether the spline may be discontinuous at break i.
    [[nodiscard]] bool jumps(int axis, int64_t i) const noexcept {
        return jumps_[static_cast<size_t>(axis)][static_cast<size_t>(i)] != 0;
    }
    // Whether its first derivatives, or those of the homogeneous coordinates, may be discontinuous there.
    [[nodiscard]] bool kinks(int axis, int64_t i) const noexcept {
        return kinks_[static_cast<size_t>(axis)][static_cast<size_t>(i)] != 0;
    }
    // The neighbour of piece i upwards or downwards, or -1 at an end or where the spline jumps.
    [[nodiscard]] int64_t neighbour(int axis, int64_t i, bool up) const noexcept;
    [[nodiscard]] bool periodic(int axis) const noexcept { return periodic_[static_cast<size_t>(axis)]; }
    [[nodiscard]] int64_t find(int axis, double t) const noexcept;
    // The pieces that contain the parameters: two along an axis at a break, none outside the domain.
    [[nodiscard]] std::vector<int64_t> containing(const AxisValues &parameters) const;

    [[nodiscard]] const Frame &frame() const noexcept { return frame_; }
    // The parameter intervals of a piece, along each axis of the spline.
    [[nodiscard]] std::array<Interval, max_axes> part(int64_t piece) const noexcept;

    // Converts a point x of the caller to these units; writes lanes() values.
    void place(const double *x, double *out) const noexcept;
    [[nodiscard]] double scaled(double length) const noexcept;
    [[nodiscard]] double unscaled(double length) const noexcept;
    // The largest magnitude of a point in these units, without subtracting the centre.
    [[nodiscard]] double size() const noexcept { return size_; }
    [[nodiscard]] double magnitude(const double *x) const noexcept;  // |x| in these units
    [[nodiscard]] double radius() const noexcept { return radius_; } // about the centre
    [[nodiscard]] double weight_ratio() const noexcept { return ratio_; }

    // Whether all weights are >= 0 and every coefficient has, relative to its own weight, a point within
    // moved() of the exact one. Otherwise records and weights have absolute errors.
    [[nodiscard]] bool positive() const noexcept { return positive_; }
    [[nodiscard]] double moved() const noexcept { return rounding_.apart; }
    [[nodiscard]] const Rounding &rounding() const noexcept { return rounding_; }
    // The same bound for a part, subdivided `depth` times, whose errors are divided by its weights, all at
    // least `least`, and whose control points are within `reach` of the centre. It is 0 where moved() alone
    // is the bound.
    [[nodiscard]] double moved_by_weights(double reach, double least, int depth = 0) const noexcept {
        return positive_ ? 0 : (8 + depth) * rounding_.moved(reach, least);
    }
    // Errors relative to the sum of the magnitudes: of coefficients of squares, and of values at a place,
    // where Bernstein functions take three roundings for each degree, and sums take one for each term.
    [[nodiscard]] double product_error() const noexcept { return squares_->error(); }
    [[nodiscard]] double value_error() const noexcept { return value_error_; }
    // 64 eps times the sum of p + 1 over the axes: the allowance of certificates for rounding.
    [[nodiscard]] double allowance() const noexcept { return allowance_; }

private:
    void set_axes(const Spline &spline);
    void set_extraction(const Spline &spline);
    void copy(const Spline &spline);
    [[nodiscard]] NetPart records_of(const Index &spans) const noexcept;
    void set_sizes(const Spline &spline, const std::vector<double> &sizes);

    PatchShape shape_;
    int axes_ = 0;
    std::array<int, max_axes> map_{};
    std::array<std::vector<double>, max_axes> breaks_;
    std::array<std::vector<char>, max_axes> jumps_, kinks_; // at each break
    std::array<bool, max_axes> periodic_{};
    int64_t count_ = 1;
    Frame frame_;
    std::array<int, max_axes> layers_{1, 1, 1};            // active on a piece, for each axis of the spline
    std::array<int64_t, max_axes> counts_{1, 1, 1};        // number of control points
    std::array<std::vector<int64_t>, max_axes> first_;     // first active layer of each span
    std::array<std::vector<double>, max_axes> extraction_; // matrix [degree + 1][degree + 1] of each span
    std::vector<double> records_;                          // [counts][lanes]
    std::unique_ptr<const PatchSquares> squares_;
    double size_ = 0, radius_ = 0, ratio_ = 1;
    bool positive_ = true;
    Rounding rounding_;
    double value_error_ = 0, allowance_ = 0;
};

// Built at first use, and kept with the spline.
const PieceGrid &piece_grid_of(const Spline &spline);

} // namespace nrb::pieces
