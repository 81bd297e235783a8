// SPDX-License-Identifier: MIT
// Upper bounds on the one-sided Hausdorff distance from one Bezier piece to another, by matching their
// points.
#pragma once

#include "closest/pair/pair_descent.h"

namespace nrb::closest {

// Each corner of piece x is matched with the nearest point of piece y, and every other point of x with the
// point of y at the multilinear interpolation of the corners' parameters. The bound is the largest distance
// of matched points. With x = X / w and the composition of y with the map = Y / v, the distance is
// |X v - Y w| / (v w), and its bound follows from the Bernstein coefficients of numerator and denominator; in
// every variable, the composition has the sum of the degrees of y. The bound exceeds the distance by a
// quantity of second order in the size of x, even where the pieces touch. It includes rounding and moved() of
// both pieces, and is infinite unless all weights are positive.
class MatchedBound {
public:
    // The places on y nearest to the corners of x, by descents that start at `guess`; empty if the pieces
    // cannot be compared.
    std::vector<pieces::LocalParam> corners(const pieces::BezierPiece &x, const pieces::BezierPiece &y,
                                            const pieces::LocalParam &guess);
    // The bound for given places on y of the corners of x, in the order of corners_of(x). `enough`: a bound
    // this small need not be improved.
    static double upper(const pieces::BezierPiece &x, const pieces::BezierPiece &y,
                        const std::vector<pieces::LocalParam> &corners, double enough);
    // The corners of x, last axis fastest. An axis of degree 0 has only one end.
    static std::vector<pieces::LocalParam> corners_of(const pieces::BezierPiece &x);

private:
    PieceJet jet_;
    PairDescent descent_;
};

} // namespace nrb::closest
