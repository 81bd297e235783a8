// SPDX-License-Identifier: MIT
// The homogeneous Bezier coefficients of all pieces of a spline in a frame, with what rounding may have made
// of them.
#pragma once

#include "pieces/bernstein_net.h"
#include "pieces/frame.h"

namespace nrb::pieces {

// How far coefficients (A, w) may be from the exact ones (A*, w*), about the centre of the frame. Where all
// weights are positive for certain, errors are relative to them: every point A / w is within `apart` of one
// of the exact piece, and the other way round, whatever the weights. Otherwise |A - A*| <= record and |w -
// w*| <= weight.
struct Rounding {
    double apart = 0;
    double record = 0;
    double weight = 0;

    [[nodiscard]] bool relative() const noexcept { return weight == 0; }
    // Whether a weight is positive for certain, and not so small beside the largest one, which is near 1,
    // that products with it underflow.
    [[nodiscard]] bool positive(double w) const noexcept { return w > 64 * weight && w >= 0x1p-900; }
    // How far a point may be away, if all weights are at least `least` and all control points within `reach`.
    [[nodiscard]] double moved(double reach, double least) const noexcept {
        return relative() ? apart : apart + 1.05 * (record + reach * weight) / least;
    }
};

// Further ends of pieces may be given along each axis, in the domain. Cost: linear in the number of pieces.
class BezierNet {
public:
    BezierNet(const Spline &spline, Frame frame, const BernsteinNet::Breaks &more = {});
    // In another unit of length.
    void rescale(int exponent) noexcept { frame_.exponent = exponent; }

    [[nodiscard]] const Frame &frame() const noexcept { return frame_; }
    [[nodiscard]] const BernsteinShape &shape() const noexcept { return shape_; } // of (A, w)
    [[nodiscard]] int64_t count() const noexcept { return net_.pieces(); }
    [[nodiscard]] bool weighted() const noexcept { return net_.weighted(); }
    [[nodiscard]] bool positive() const noexcept { return net_.positive(); }
    [[nodiscard]] double error() const noexcept { return net_.error(); }
    // Largest magnitudes |x - c| of control points, and of one that is active on a piece; not scaled.
    [[nodiscard]] const std::vector<double> &sizes() const noexcept { return records_.sizes; }
    [[nodiscard]] double size(int64_t piece) const noexcept { return net_.size(piece); }
    // The control points as they enter a net, not scaled.
    [[nodiscard]] const CentredRecords &records() const noexcept { return records_; }
    // The ends of a piece along each axis of the spline.
    [[nodiscard]] std::array<Interval, max_axes> part(int64_t piece) const noexcept;

    // Coefficient after coefficient (A, w), `stride` apart.
    void copy(int64_t piece, double *out, int64_t stride);
    // Of the coefficients of a piece; `more` is relative to their size, of what is done with them besides.
    [[nodiscard]] Rounding rounding(int64_t piece, double more = 0) const noexcept;
    // The same of all pieces, with control points in a radius.
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
