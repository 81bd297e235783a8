// SPDX-License-Identifier: MIT
// Bounds on the distance of a Bezier piece from a shape.
#pragma once

#include "base/numbers.h"
#include "recognize/shape_forms.h"
#include "recognize/shape_pieces.h"

namespace nrb::recognize {

struct DistanceBound {
    double upper = infinity;
    double noise = 0; // the part of `upper` that is due to rounding
};

// The upper bound follows from the range of the values of the shape's implicit equation along the piece. For
// circles, spheres and cylinders, the value is the squared distance from the centre or axis minus a constant;
// for a torus, it is the squared distance from the central circle, minus a constant, times a factor that is
// bounded from below; for the other quadrics, the gradient converts values to distances. Where the gradient
// is small compared to the value, the bound is the distance of one point plus the extent of the piece.
class PieceDistance {
public:
    explicit PieceDistance(const Shape &shape);

    // Precondition: the piece is sound().
    [[nodiscard]] DistanceBound upper(const pieces::BezierPiece &piece) const;
    // The largest distance of a corner: at most the true distance minus `noise`.
    [[nodiscard]] double lower(const pieces::BezierPiece &piece, double noise) const;

private:
    [[nodiscard]] DistanceBound in_plane(const pieces::BezierPiece &piece) const;
    [[nodiscard]] DistanceBound by_gradient(const pieces::BezierPiece &piece) const;
    [[nodiscard]] DistanceBound from_torus(const pieces::BezierPiece &piece) const;
    [[nodiscard]] double by_extent(const pieces::BezierPiece &piece) const;
    [[nodiscard]] bool across_axis(const TorusForms &torus, double distance) const noexcept;
    [[nodiscard]] bool beyond(const pieces::BezierPiece &piece, double distance) const noexcept;

    Shape shape_;
    Quadric quadric_;
};

} // namespace nrb::recognize
