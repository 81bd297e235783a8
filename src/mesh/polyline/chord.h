// SPDX-License-Identifier: MIT
// How far parts of a curve are from a segment, and how far they turn from its direction, with proof.
#pragma once

#include "pieces/bezier_piece.h"

#include <vector>

namespace nrb::mesh {

// The segment between two points of the frame of some pieces.
class Chord {
public:
    // Of points of `dim` coordinates.
    explicit Chord(int dim);
    void set(const double *start, const double *end);

    // No less than the distance of the points.
    [[nodiscard]] double length() const noexcept { return length_ + 8 * rounding_; }
    // No point of the exact piece is farther from the segment.
    [[nodiscard]] double distance(const pieces::BezierPiece &piece);
    // No farther is the first point of the piece from the start, and its last point from the end of the segment.
    [[nodiscard]] double start_gap(const pieces::BezierPiece &piece) const noexcept;
    [[nodiscard]] double end_gap(const pieces::BezierPiece &piece) const noexcept;
    // No tangent of the exact piece makes a larger angle with the direction of the segment; pi where that is not known.
    [[nodiscard]] double turn(const pieces::BezierPiece &piece) const;
    // What rounding adds to all that.
    [[nodiscard]] double noise(const pieces::BezierPiece &piece) const noexcept;

private:
    struct Spread { // of the control points, seen along the segment
        double across = 0;
        double least = 0, most = 0;
    };
    struct Bends { // of what lies across the segment
        double across = 0;
        bool rough = false; // the piece is so long that halves would give a much better bound
    };

    [[nodiscard]] Spread spread(const pieces::BezierPiece &piece);
    [[nodiscard]] Bends bends(const pieces::BezierPiece &piece) const noexcept;
    [[nodiscard]] double distance(const pieces::BezierPiece &piece, int halvings);
    [[nodiscard]] double distance_of_halves(const pieces::BezierPiece &piece, int halvings);
    [[nodiscard]] double angle_with(const double *vector, double error) const noexcept;

    int dim_;
    std::vector<double> start_, end_, direction_; // of length 1, or 0 if the ends are one point
    double length_ = 0, rounding_ = 0;            // of the coordinates
    std::vector<double> numerators_; // w times the vectors across the segment, [coefficients][dim]
};

} // namespace nrb::mesh
