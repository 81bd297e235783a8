// SPDX-License-Identifier: MIT
// Vectors whose convex hull contains the derivative of a piece.
#pragma once

#include "pieces/bezier_piece.h"

#include <vector>

namespace nrb::pieces {

// For a Bezier piece, with respect to local parameters along one of its axes: the control points of its
// hodograph. For a rational piece these are the quotients of the coefficients of A' w - A w' and w^2.
class Slopes {
public:
    Slopes() = default;
    // Precondition: piece.positive().
    explicit Slopes(const BezierPiece &piece, int axis = 0);

    [[nodiscard]] size_t count() const noexcept { return vectors_.size() / dim_ - 1; }
    [[nodiscard]] const double *vector(size_t i) const noexcept { return vectors_.data() + i * dim_; }
    [[nodiscard]] const double *mean() const noexcept { return vector(count()); }
    // The length of the longest vector.
    [[nodiscard]] double largest() const noexcept { return largest_; }
    // How far the derivative of the exact piece may be from the convex hull.
    [[nodiscard]] double error() const noexcept { return error_; }
    // Bounds of the dot products of the derivative with a unit vector.
    [[nodiscard]] Interval along(const double *direction) const noexcept;

private:
    void set_polynomial(const BezierPiece &piece, int axis);
    void set_rational(const BezierPiece &piece, int axis);

    size_t dim_ = 1;
    std::vector<double> vectors_; // the mean comes last
    double largest_ = 0;          // length of the longest vector
    double error_ = 0;
};

// A piece of a curve with positive weights.
struct SlopedPiece {
    const BezierPiece *piece;
    const Slopes *slopes;
};

} // namespace nrb::pieces
