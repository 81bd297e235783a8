// SPDX-License-Identifier: MIT
// Proven bounds on the distance of parts of a curve from a segment (chord error), and on the angles of their
// tangents with it.
#pragma once

#include "pieces/bezier_piece.h"

#include <vector>

namespace nrb::mesh {

// The segment between two points in the frame of some pieces. All bounds include rounding.
class Chord {
public:
    // For points of `dim` coordinates.
    explicit Chord(int dim);
    void set(const double *start, const double *end);

    // An upper bound on the distance of the points.
    [[nodiscard]] double length() const noexcept { return length_ + 8 * rounding_; }
    // A bound on the distance of all points of the exact piece from the segment.
    [[nodiscard]] double distance(const pieces::BezierPiece &piece);
    // Bounds on the distance of the first point of the piece from the start of the segment, and of its last
    // point from the end.
    [[nodiscard]] double start_gap(const pieces::BezierPiece &piece) const noexcept;
    [[nodiscard]] double end_gap(const pieces::BezierPiece &piece) const noexcept;
    // A bound on the angles between tangents of the exact piece and the direction of the segment; pi where
    // none is known.
    [[nodiscard]] double turn(const pieces::BezierPiece &piece) const;
    // The part of all these bounds that is due to rounding.
    [[nodiscard]] double noise(const pieces::BezierPiece &piece) const noexcept;

private:
    struct Spread { // of the control points, in the directions across and along the segment
        double across = 0;
        double least = 0, most = 0;
    };
    struct Bends { // of the components across the segment
        double across = 0;
        bool rough = false; // the piece is so long that its halves would give a much better bound
    };

    [[nodiscard]] Spread spread(const pieces::BezierPiece &piece);
    [[nodiscard]] Bends bends(const pieces::BezierPiece &piece) const noexcept;
    [[nodiscard]] double distance(const pieces::BezierPiece &piece, int halvings);
    [[nodiscard]] double distance_of_halves(const pieces::BezierPiece &piece, int halvings);
    [[nodiscard]] double angle_with(const double *vector, double error) const noexcept;

    int dim_;
    std::vector<double> start_, end_, direction_; // a unit vector, or 0 if the ends are one point
    double length_ = 0, rounding_ = 0;            // rounding_: of the coordinates
    std::vector<double> numerators_; // w times the components across the segment, [coefficients][dim]
};

} // namespace nrb::mesh
