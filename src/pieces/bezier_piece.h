// SPDX-License-Identifier: MIT
// One Bezier piece of a spline in a frame, with proven bounds of its rounding, for bounding and subdivision.
#pragma once

#include "pieces/bezier_net.h"

#include <optional>

namespace nrb::pieces {

// Local parameters in [0, 1] on the axes of a piece; the axes of the spline come first.
using LocalParam = std::array<double, max_axes>;

// Homogeneous control points (w x, w) over a part of a polynomial piece of a spline, last axis fastest. After
// every change the piece holds its Cartesian control points and their bounding box.
class BezierPiece {
public:
    BezierPiece() = default;
    // A single point [dim].
    BezierPiece(const double *point, int dim);
    // Piece `index` of a net.
    BezierPiece(BezierNet &net, int64_t index, int axes);
    // From coefficients of a shape, over given parameter intervals.
    BezierPiece(int axes, const BernsteinShape &shape, std::vector<double> values,
                const std::array<Interval, max_axes> &part, const Rounding &rounding);
    // Replaces the coefficients by others (w x, w) about the same centre and along the same axes.
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

    // positive(): all weights are certainly positive. sound(): they are positive, or a whole coefficient is
    // certainly 0, which has no control point. The rest of the interface requires one or the other.
    [[nodiscard]] bool positive() const noexcept { return positive_; }
    [[nodiscard]] bool sound() const noexcept { return sound_; }
    // The Cartesian control points.
    [[nodiscard]] const double *point(int64_t i) const noexcept {
        return numbers_.data() + first_point_ + i * dim();
    }
    [[nodiscard]] bool has_point(int64_t i) const noexcept { return weight(i) != 0; }
    // The bounding box of the control points, [dim].
    [[nodiscard]] const double *lower() const noexcept { return point(coefficients()); }
    [[nodiscard]] const double *upper() const noexcept { return lower() + dim(); }
    // The largest side of the bounding box.
    [[nodiscard]] double size() const noexcept { return size_; }
    // The largest distance of a control point from the centre.
    [[nodiscard]] double reach() const noexcept { return reach_; }
    // Every point of the piece is within moved() of a point of the spline, and vice versa. moved() accounts
    // for the rounding of the control points, records_moved() for that of the coefficients alone.
    [[nodiscard]] double moved() const noexcept { return moved_; }
    [[nodiscard]] double records_moved() const noexcept { return rounding_.moved(reach_, least_weight_); }

    // The parameter at a local parameter.
    [[nodiscard]] LocalParam parameter(const LocalParam &place) const noexcept;
    // The local parameter of a parameter, clamped to [0, 1].
    [[nodiscard]] LocalParam place(const LocalParam &parameter) const noexcept;

    // Halves along an axis: the piece becomes the upper half; the lower half is returned.
    BezierPiece halve(int axis);
    // Halves along the axis with the longest control polygon. Empty if no axis has a degree, or if the
    // parameter intervals cannot be halved.
    std::optional<BezierPiece> halve();
    // The part of a curve piece between two parameters, lower < upper.
    [[nodiscard]] BezierPiece between(Interval range) const;

private:
    // The size of coefficients, control points and box together.
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
    std::vector<double> numbers_; // coefficients, then control points, then the box, in one allocation
    int64_t first_point_ = 0;
    std::array<Interval, max_axes> part_{}; // parameter intervals
    Rounding rounding_;
    double size_ = 0, reach_ = 0, moved_ = 0;
    double least_weight_ = 1;
    bool positive_ = true, sound_ = true;
};

// `more`: further breaks along each axis, in the domain.
std::vector<BezierPiece> bezier_pieces(const Spline &spline, const Frame &frame,
                                       const BernsteinNet::Breaks &more = {});

} // namespace nrb::pieces
