// The Bezier pieces of a spline in the frame of a shape.
#pragma once

#include "bernstein/products.h"
#include "recognize/shape_model.h"
#include "spline/spline.h"

#include <vector>

namespace nrb::recognize {

// Homogeneous coefficients (w x, w y, w z, w), and how far rounding may have moved what they stand for: if
// all weights are > 0, every point of the piece is within moved() of that of the spline.
class ShapePiece {
public:
    BernsteinShape shape; // width 4
    std::vector<double> values;

    [[nodiscard]] int64_t coefficients() const noexcept { return shape.coefficients(); }
    [[nodiscard]] const double *at(int64_t i) const noexcept { return values.data() + 4 * i; }
    // The Cartesian point of a coefficient. Precondition: its weight is not 0.
    [[nodiscard]] Vector3 point(int64_t i) const noexcept {
        const double *p = at(i);
        return {p[0] / p[3], p[1] / p[3], p[2] / p[3]};
    }
    // Makes all weights > 0; false if they are not of one sign for certain. A weight of 0 is allowed if the
    // whole coefficient is 0 without rounding. Sets size() and moved().
    bool certify() noexcept;
    [[nodiscard]] double size() const noexcept { return size_; } // of the largest point
    [[nodiscard]] double moved() const noexcept { return moved_; }

    // Halves along the axis on which the control points spread most; the piece becomes the upper half. False
    // if it has no degree.
    bool halve_into(ShapePiece &lower);

private:
    // A Moebius map of the parameter of every axis, by which the weights at its ends come near each other, so
    // that the middle of the parameter is near that of the piece. Exact, since weights are multiplied by
    // powers of two.
    void balance() noexcept;

    friend std::vector<ShapePiece> shape_pieces(const Spline &spline, const Shape &shape);

    double apart_ = 0;        // distance from the exact points, by rounding relative to the weights
    double record_error_ = 0; // otherwise: of every coefficient (w x, w y, w z)
    double weight_error_ = 0; // and of every weight
    double size_ = 0;
    double moved_ = 0;
};

// Cost: linear in the number of pieces. Precondition: dimension 2 or 3.
std::vector<ShapePiece> shape_pieces(const Spline &spline, const Shape &shape);

} // namespace nrb::recognize
