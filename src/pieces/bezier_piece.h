// SPDX-License-Identifier: MIT
// One Bezier piece of a spline in a frame, with proof of how far rounding may have moved it, to be bounded
// and halved.
#pragma once

#include "pieces/bezier_net.h"

#include <optional>

namespace nrb::pieces {

// Places between 0 and 1 on the axes of a piece, those of the spline first.
using LocalParam = std::array<double, max_axes>;

// Homogeneous control points (w x, w) over a part of a polynomial piece of a spline, last axis fastest.
class BezierPiece {
public:
    BezierPiece() = default;
    // A single point [dim].
    BezierPiece(const double *point, int dim);
    // Piece `index` of a net.
    BezierPiece(BezierNet &net, int64_t index, int axes);
    // Coefficients of the shape, over the parameters of a part.
    BezierPiece(int axes, const BernsteinShape &shape, std::vector<double> values,
                const std::array<Interval, max_axes> &part, const Rounding &rounding);
    // Any other coefficients (w x, w), about the same centre, of the same axes.
    void replace(int width, std::vector<double> values, const Rounding &rounding);

    [[nodiscard]] int axes() const noexcept { return axes_; }
    [[nodiscard]] int dim() const noexcept { return shape_.width - 1; }
    [[nodiscard]] int degree(int k) const noexcept {
        return shape_.degrees[static_cast<size_t>(max_axes - axes_ + k)];
    }
    [[nodiscard]] int64_t coefficients() const noexcept { return shape_.coefficients(); }
    [[nodiscard]] const double *record(int64_t i) const noexcept {
        return numbers_.data() + i * shape_.width;
    }
    [[nodiscard]] double weight(int64_t i) const noexcept { return record(i)[dim()]; }
    [[nodiscard]] const BernsteinShape &shape() const noexcept { return shape_; }
    [[nodiscard]] const Rounding &rounding() const noexcept { return rounding_; }

    // Whether all weights are positive for certain; sound(): or 0 where the whole coefficient is 0 for
    // certain, which has no control point. The rest presumes the one or the other.
    [[nodiscard]] bool positive() const noexcept { return positive_; }
    [[nodiscard]] bool sound() const noexcept { return sound_; }
    // The control points.
    [[nodiscard]] const double *point(int64_t i) const noexcept {
        return numbers_.data() + first_point_ + i * dim();
    }
    [[nodiscard]] bool has_point(int64_t i) const noexcept { return weight(i) != 0; }
    // Of the control points, [dim].
    [[nodiscard]] const double *lower() const noexcept { return point(coefficients()); }
    [[nodiscard]] const double *upper() const noexcept { return lower() + dim(); }
    // The largest side of the box.
    [[nodiscard]] double size() const noexcept { return size_; }
    // No control point is farther from the centre.
    [[nodiscard]] double reach() const noexcept { return reach_; }
    // Every point is within moved() of one of the spline, and the other way round; of the control points as
    // they are rounded, and of the coefficients.
    [[nodiscard]] double moved() const noexcept { return moved_; }
    [[nodiscard]] double records_moved() const noexcept { return rounding_.moved(reach_, least_weight_); }

    // The parameter of a place.
    [[nodiscard]] LocalParam parameter(const LocalParam &place) const noexcept;
    // The place of a parameter, moved to the nearer end if it is outside.
    [[nodiscard]] LocalParam place(const LocalParam &parameter) const noexcept;

    // Halves along an axis: the piece becomes the upper half, the lower one is returned.
    BezierPiece halve(int axis);
    // The same along the axis with the longest legs. None if it has no degree or its parameters cannot be
    // halved.
    std::optional<BezierPiece> halve();
    // What lies between two parameters of a piece of a curve, lower < upper.
    [[nodiscard]] BezierPiece between(Interval range) const;

private:
    // Of the coefficients, points and box together.
    [[nodiscard]] size_t size_of_numbers() const noexcept {
        return static_cast<size_t>(shape_.values() + (coefficients() + 2) * dim());
    }
    [[nodiscard]] double *points() noexcept { return numbers_.data() + first_point_; }
    void update();
    bool set_points() noexcept;
    void set_reach() noexcept;
    void set_box() noexcept;
    void add_rounding(double relative) noexcept;
    void cut_before(double t) noexcept;
    void cut_after(double t) noexcept;
    void keep_even_weights(const BezierPiece &whole) noexcept;
    [[nodiscard]] double middle(int axis) const noexcept;
    [[nodiscard]] double legs(int axis) const noexcept;

    int axes_ = 1;
    BernsteinShape shape_;
    std::vector<double> numbers_; // coefficients, then control points, then the box: one piece of memory
    int64_t first_point_ = 0;
    std::array<Interval, max_axes> part_{}; // parameters
    Rounding rounding_;
    double size_ = 0, reach_ = 0, moved_ = 0;
    double least_weight_ = 1;
    bool positive_ = true, sound_ = true;
};

// Further ends of pieces may be given along each axis, in the domain.
std::vector<BezierPiece> bezier_pieces(const Spline &spline, const Frame &frame,
                                       const BernsteinNet::Breaks &more = {});

} // namespace nrb::pieces
