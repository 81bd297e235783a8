// SPDX-License-Identifier: MIT
// The numerators of derivatives and normals on single Bernstein pieces.
#pragma once

#include "bernstein/rounded_polynomial.h"
#include "pieces/spline_pieces.h"

namespace nrb::pieces {

// One piece of a spline in homogeneous coordinates A = w (x - c), w about a nearby centre c, so that rounding
// is relative to the size of the piece. Lengths and weights are in units of powers of two near the largest.
// In polynomial splines, and where weights are equal, w is the constant 1.
struct HomogeneousPiece {
    RoundedPolynomial points; // A
    RoundedPolynomial weight;
    int exponent = 0;             // of the unit of length
    int weight_exponent = 0;      // of the unit of weights
    bool positive = true;         // the weight is positive in the whole piece; false: its sign is unknown
    int first_axis = 0;           // the first of the three axes that the spline has
    Part part{};                  // the parameter intervals, for the axes of the spline
    std::vector<double> centre{}; // c

    // Index among the three axes of axis k of the spline.
    [[nodiscard]] int axis(int k) const noexcept { return first_axis + k; }
    [[nodiscard]] double parameter(int k, double place) const noexcept;
};

// The pieces of a part of a spline, computed on request; last axis fastest.
class PieceMaker {
public:
    PieceMaker(const Spline &spline, const Part &part);
    // With one centre for all pieces.
    PieceMaker(const Spline &spline, const Part &part, std::vector<double> centre);

    [[nodiscard]] int64_t count() const noexcept;
    [[nodiscard]] int64_t count(int k) const noexcept {
        return std::ssize(breaks_[static_cast<size_t>(k)]) - 1;
    }
    [[nodiscard]] const std::vector<double> &breaks(int k) const noexcept {
        return breaks_[static_cast<size_t>(k)];
    }
    [[nodiscard]] HomogeneousPiece piece(int64_t index) const;

private:
    [[nodiscard]] Spline sub_spline(const std::array<int64_t, max_axes> &spans) const;

    const Spline &spline_;
    bool weighted_;
    std::vector<double> centre_; // empty: each piece has its own
    BernsteinNet::Breaks breaks_;
};

// Numerators of derivatives with respect to the local parameters of a piece with coefficients A, w. Each
// vanishes where the derivative does, and has its direction: where the sign of w is unknown, odd powers of w
// are multiplied by w once more. Along axis k of the spline C' = D / w^2 with D = A' w - A w'.
RoundedPolynomial tangent_numerator(const HomogeneousPiece &piece, int k);
// S_u x S_v = N / w^3 with N = w A_u x A_v + w_v A x A_u - w_u A x A_v; a scalar in dimension 2.
RoundedPolynomial normal_numerator(const HomogeneousPiece &piece);
// det(V_u, V_v, V_w) = J / w^4 for a volume in space.
RoundedPolynomial volume_numerator(const HomogeneousPiece &piece);
// C' x C'' = M / w^3 for a curve, with M = w A' x A'' + w'' A x A' - w' A x A''; a scalar in dimension 2.
RoundedPolynomial bend_numerator(const HomogeneousPiece &piece);
// det(C', C'', C''') = T / w^4 for a curve in space.
RoundedPolynomial twist_numerator(const HomogeneousPiece &piece);

} // namespace nrb::pieces
