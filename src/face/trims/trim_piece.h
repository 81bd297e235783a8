// SPDX-License-Identifier: MIT
// Pieces of the curves that bound a face, on which both parameters run one way.
#pragma once

#include "face/covering.h"

#include <cstdint>
#include <span>
#include <vector>

namespace nrb::face {

// A Bezier piece in the domain. Its ends are those of its neighbours bit for bit, so that nothing passes between two pieces
// however their coefficients are rounded.
struct TrimPiece {
    Point2 start, end;
    Point2 lower, upper; // the box of the ends, which is that of the piece
    int32_t loop = 0;
    int32_t degree = 1;
    bool weighted = false;
    int64_t first = 0;  // of its coefficients
    Point2 noise{0, 0}; // how far evaluated coordinates may be from those of the stored curve
    int32_t curve =
        0; // of the loop as it was given, with the parameters from start to end: one for a segment behind a curve
    Interval range{0, 0};
};

// Of the curve that it is a piece of.
inline double parameter_at(const TrimPiece &piece, double place) noexcept {
    const auto [lower, upper] = piece.range;
    return place == 1 || lower == upper ? upper : (1 - place) * lower + place * upper;
}

// Pieces and their coefficients: (u, v), or (u w, v w, w).
class TrimPieces {
public:
    [[nodiscard]] const std::vector<TrimPiece> &all() const noexcept { return pieces_; }
    [[nodiscard]] std::span<const double> coefficients(const TrimPiece &piece) const noexcept {
        const auto width = static_cast<size_t>(piece.weighted ? 3 : 2);
        return std::span(pool_).subspan(static_cast<size_t>(piece.first),
                                        (static_cast<size_t>(piece.degree) + 1) * width);
    }
    struct Jet {
        Point2 point, derivative; // by the place on the piece
    };
    [[nodiscard]] Jet jet(const TrimPiece &piece, double place) const noexcept;
    [[nodiscard]] Point2 point(const TrimPiece &piece, double place) const noexcept;
    // Where coordinate k passes a value between those of the ends, to rounding.
    [[nodiscard]] double place_of(const TrimPiece &piece, int k, double value) const noexcept;

    // Where the piece is in the column at x[0], relative to x: 1 above, -1 below, 0 on it to rounding. Precondition: x is in
    // the box of the piece, ends included. Cost: a few evaluations, one for lines.
    [[nodiscard]] int side(const TrimPiece &piece, const Point2 &x) const noexcept;
    // Whether b is above a, 1, or below it, -1, in the columns that both come to; 0 where there are none, or rounding hides it.
    // Precondition: they meet at their ends at most.
    [[nodiscard]] int order(const TrimPiece &a, const TrimPiece &b) const noexcept;
    // Whether the piece comes into a box, to rounding: of the two corners that it would pass between, one is above it and one
    // below. Precondition: the box meets that of the piece.
    [[nodiscard]] bool meets(const TrimPiece &piece, const Point2 &lower, const Point2 &upper) const noexcept;

    void add(TrimPiece piece, std::span<const double> coefficients);
    // The segment between two places, behind the end of a curve.
    void add_line(int32_t loop, const Point2 &start, const Point2 &end, int32_t curve, double param);
    // The part between two places of a piece of another set, moved, with these ends.
    void add_part(const TrimPieces &from, const TrimPiece &piece, Interval part, const Point2 &start,
                  const Point2 &end, const Point2 &move);

private:
    std::vector<TrimPiece> pieces_;
    std::vector<double> pool_;
};

} // namespace nrb::face
