// SPDX-License-Identifier: MIT
// How far a Bezier piece is from a shape at most.
#pragma once

#include "base/numbers.h"
#include "recognize/shape_forms.h"
#include "recognize/shape_pieces.h"

namespace nrb::recognize {

struct DistanceBound {
    double upper = infinity;
    double noise = 0; // what rounding has in it
};

// The equation of the shape along the piece bounds the value of that equation: of circles, spheres and
// cylinders the square of the distance from the middle, of a torus that from its central circle times a
// factor which has a bound from below, of the other quadrics a distance by their gradient. Where the gradient
// is small beside the value, the bound is the distance of one point with the extent of the piece.
class PieceDistance {
public:
    explicit PieceDistance(const Shape &shape);

    // Precondition: the piece is sound.
    [[nodiscard]] DistanceBound upper(const pieces::BezierPiece &piece) const;
    // Of the corners, at most the true distance less the noise.
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
