// SPDX-License-Identifier: MIT
// The curves that bound a face, cut into pieces along which both coordinates are monotone.
#pragma once

#include "face/covering.h"

#include <cstdint>
#include <span>
#include <vector>

namespace nrb::face {

// A monotone Bezier piece in the domain. It has its ends in common with its neighbours bit for bit, so that
// no ray passes between two pieces, however their coefficients are rounded.
struct TrimPiece {
    Point2 start, end;
    Point2 lower, upper; // the box of the ends, and so of the piece
    int32_t loop = 0;
    int32_t degree = 1;
    bool weighted = false;
    int64_t first = 0;  // index of its first coefficient
    Point2 noise{0, 0}; // how far evaluated coordinates may be from those of the stored curve
    // The curve of the loop, as it was given, that this is a piece of, and its parameters from start to end.
    // For a segment that closes a gap: the curve before the gap, and the parameter at its end.
    int32_t curve = 0;
    Interval range{0, 0};
};

// The parameter of the curve at a place of the piece, from 0 to 1.
inline double parameter_at(const TrimPiece &piece, double place) noexcept {
    const auto [lower, upper] = piece.range;
    return place == 1 || lower == upper ? upper : (1 - place) * lower + place * upper;
}

// Pieces and their coefficients: records (u, v), or (u w, v w, w) if the piece is weighted.
class TrimPieces {
public:
    [[nodiscard]] const std::vector<TrimPiece> &all() const noexcept { return pieces_; }
    [[nodiscard]] std::span<const double> coefficients(const TrimPiece &piece) const noexcept {
        const auto width = static_cast<size_t>(piece.weighted ? 3 : 2);
        return std::span(pool_).subspan(static_cast<size_t>(piece.first),
                                        (static_cast<size_t>(piece.degree) + 1) * width);
    }
    struct Jet {
        Point2 point, derivative; // derivative: by the place on the piece
    };
    [[nodiscard]] Jet jet(const TrimPiece &piece, double place) const noexcept;
    [[nodiscard]] Point2 point(const TrimPiece &piece, double place) const noexcept;
    // The place at which coordinate k takes a value between those at the ends, to rounding.
    [[nodiscard]] double place_of(const TrimPiece &piece, int k, double value) const noexcept;

    // Where the piece crosses the column of x, the vertical line at x[0]: 1 above x, -1 below; 0 if x is on
    // the piece, to rounding. Precondition: x is in the box of the piece, ends included. Cost: a few
    // evaluations; one orientation test for a line.
    [[nodiscard]] int side(const TrimPiece &piece, const Point2 &x) const noexcept;
    // The order of two pieces in the columns that both of them reach: 1 if b is above a, -1 if it is below, 0
    // if there is no such column or rounding hides the order. Precondition: they meet at their ends at most.
    [[nodiscard]] int order(const TrimPiece &a, const TrimPiece &b) const noexcept;
    // Whether the piece enters a box, to rounding: of the part of the box that the two boxes have in common,
    // one of the corners between which the piece has to pass is above it, and the opposite one below.
    // Precondition: the box meets that of the piece.
    [[nodiscard]] bool meets(const TrimPiece &piece, const Point2 &lower, const Point2 &upper) const noexcept;

    void add(TrimPiece piece, std::span<const double> coefficients);
    // Adds the segment between two places that closes a gap after a curve.
    void add_line(int32_t loop, const Point2 &start, const Point2 &end, int32_t curve, double param);
    // Adds the part between two places of a piece of another set, moved, with these ends.
    void add_part(const TrimPieces &from, const TrimPiece &piece, Interval part, const Point2 &start,
                  const Point2 &end, const Point2 &move);

private:
    std::vector<TrimPiece> pieces_;
    std::vector<double> pool_;
};

} // namespace nrb::face
