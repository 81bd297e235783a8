// SPDX-License-Identifier: MIT
// The homogeneous Bezier coefficients of all pieces of a spline in a frame, with bounds of their rounding
// errors.
#pragma once

#include "pieces/bernstein_net.h"
#include "pieces/frame.h"

namespace nrb::pieces {

// Bounds of the error of coefficients (A, w) against the exact ones (A*, w*), about the centre of the frame.
// Where all weights are certainly positive, errors are relative to the weights: every point A / w is within
// `apart` of a point of the exact piece, and vice versa, whatever the weights. Otherwise |A - A*| <= record
// and |w - w*| <= weight.
struct Rounding {
    double apart = 0;
    double record = 0;
    double weight = 0;

    [[nodiscard]] bool relative() const noexcept { return weight == 0; }
    // Whether a weight is certainly positive, and not so small relative to the largest weight, which is near
    // 1, that products with it underflow.
    [[nodiscard]] bool positive(double w) const noexcept { return w > 64 * weight && w >= 0x1p-900; }
    // How far a point may have moved if all weights are at least `least` and all control points are within
    // `reach` of the centre.
    [[nodiscard]] double moved(double reach, double least) const noexcept {
        return relative() ? apart : apart + 1.05 * (record + reach * weight) / least;
    }
};

// `more`: further breaks along each axis, in the domain. Cost: linear in the number of pieces.
class BezierNet {
public:
    BezierNet(const Spline &spline, Frame frame, const BernsteinNet::Breaks &more = {});
    // Changes the unit of length.
    void rescale(int exponent) noexcept { frame_.exponent = exponent; }

    [[nodiscard]] const Frame &frame() const noexcept { return frame_; }
    [[nodiscard]] const BernsteinShape &shape() const noexcept { return shape_; } // of (A, w)
    [[nodiscard]] int64_t count() const noexcept { return net_.pieces(); }
    [[nodiscard]] bool weighted() const noexcept { return net_.weighted(); }
    [[nodiscard]] bool positive() const noexcept { return net_.positive(); }
    [[nodiscard]] double error() const noexcept { return net_.error(); }
    // The magnitudes |x - c| of the control points, and the largest one among those active on a piece; not
    // scaled.
    [[nodiscard]] const std::vector<double> &sizes() const noexcept { return records_.sizes; }
    [[nodiscard]] double size(int64_t piece) const noexcept { return net_.size(piece); }
    // The control points as they enter the net, not scaled.
    [[nodiscard]] const CentredRecords &records() const noexcept { return records_; }
    // The parameter intervals of a piece along each axis of the spline.
    [[nodiscard]] std::array<Interval, max_axes> part(int64_t piece) const noexcept;

    // Copies the coefficients (A, w) one after another, `stride` apart.
    void copy(int64_t piece, double *out, int64_t stride);
    // The rounding of the coefficients of a piece. `more` adds an error of later operations, relative to
    // their size.
    [[nodiscard]] Rounding rounding(int64_t piece, double more = 0) const noexcept;
    // The rounding of all pieces, whose control points lie within a radius.
    [[nodiscard]] Rounding rounding_of_all(double radius) const noexcept;

private:
    [[nodiscard]] Rounding absolute() const noexcept;

    Frame frame_;
    BernsteinNet::Breaks breaks_;
    CentredRecords records_;
    BernsteinNet net_;
    BernsteinShape shape_;
    std::vector<double> points_, weights_; // of one piece
};

} // namespace nrb::pieces
