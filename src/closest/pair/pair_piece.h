// Bezier pieces of splines as the searches over pairs of splines work on them.
#pragma once

#include "pieces/bernstein_net.h"

#include <optional>

namespace nrb::closest {

// What both splines of a pair have in common: coordinates become (x - centre) 2^-exponent, at most about 1.
struct PairFrame {
    std::vector<double> centre;
    int exponent = 0;
};
PairFrame pair_frame(const Spline &a, const Spline &b);

// Places between 0 and 1 on the axes of a piece, those of the spline first.
using Place = std::array<double, max_axes>;

// Control points of a rational Bezier piece over a part of a polynomial piece of a spline, last axis fastest.
// If all weights are positive, every point of the piece is within moved() of one of the spline, and the other
// way round.
class PairPiece {
public:
    PairPiece() = default;
    // A single point [dim].
    PairPiece(const double *point, int dim);

    [[nodiscard]] int axes() const noexcept { return axes_; }
    [[nodiscard]] int dim() const noexcept { return shape_.width - 1; }
    [[nodiscard]] int degree(int k) const noexcept {
        return shape_.degrees[static_cast<size_t>(max_axes - axes_ + k)];
    }
    [[nodiscard]] int64_t coefficients() const noexcept { return shape_.coefficients(); }
    [[nodiscard]] int64_t index() const noexcept { return index_; } // of the piece of the spline
    // (w x, ..., w)
    [[nodiscard]] const double *record(int64_t i) const noexcept { return values_.data() + i * shape_.width; }
    [[nodiscard]] const BernsteinShape &shape() const noexcept { return shape_; }
    // The control points; precondition of this and what follows: positive().
    [[nodiscard]] const double *point(int64_t i) const noexcept { return points_.data() + i * dim(); }
    [[nodiscard]] bool positive() const noexcept { return positive_; }
    [[nodiscard]] double moved() const noexcept { return moved_; }
    // Of the control points.
    [[nodiscard]] const double *lower() const noexcept { return box_.data(); }
    [[nodiscard]] const double *upper() const noexcept { return box_.data() + dim(); }
    // The largest side of the box.
    [[nodiscard]] double size() const noexcept { return size_; }
    // The parameter of a place.
    [[nodiscard]] Place parameter(const Place &place) const noexcept;
    // The place of a parameter, moved to the nearer end if it is outside.
    [[nodiscard]] Place place(const Place &parameter) const noexcept;

    // Halves along the axis with the longest legs; the piece becomes the upper half. None if it has no degree
    // or its parameters cannot be halved.
    std::optional<PairPiece> halve();

private:
    friend std::vector<PairPiece> pair_pieces(const Spline &, const PairFrame &,
                                              const pieces::BernsteinNet::Breaks &);
    void update();
    [[nodiscard]] double legs(int axis) const noexcept;

    int axes_ = 1;
    int64_t index_ = 0;
    BernsteinShape shape_;
    std::vector<double> values_;
    std::vector<double> points_;
    std::vector<double> box_;
    std::array<double, max_axes> from_{}, to_{}; // parameters
    double size_ = 0;
    bool positive_ = true;
    double apart_ = 0;        // rounding relative to the weights, in space
    double record_error_ = 0; // otherwise: of every coordinate of a record
    double weight_error_ = 0; // and of every weight
    double moved_ = 0;
};

// `more`: further ends of pieces along each axis, in the domain.
std::vector<PairPiece> pair_pieces(const Spline &spline, const PairFrame &frame,
                                   const pieces::BernsteinNet::Breaks &more = {});

} // namespace nrb::closest
