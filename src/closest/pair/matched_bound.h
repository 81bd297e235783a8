// SPDX-License-Identifier: MIT
// How far a piece is from another one, at most, if its points are matched with points of the other one.
#pragma once

#include "closest/pair/pair_descent.h"

namespace nrb::closest {

// The corners of piece x are matched with the points of piece y that are nearest to them, what is between
// them with what the multilinear map between the parameters makes of it: the largest distance of matched
// points, by the quotients of the Bernstein coefficients of X v - Y w and v w (the composition of Y with the
// map has in every variable the sum of the degrees of y). Of second order in the size of x, even where both
// touch. Rounding and moved() of both are included; infinite where weights are not positive.
class MatchedBound {
public:
    // Places on y near those of the corners of x, from a guess on; none if the two cannot be compared.
    std::vector<pieces::LocalParam> corners(const pieces::BezierPiece &x, const pieces::BezierPiece &y,
                                            const pieces::LocalParam &guess);
    // By places on y of the corners of x, in the order of corners_of(x); `enough`: no less is wanted.
    static double upper(const pieces::BezierPiece &x, const pieces::BezierPiece &y,
                        const std::vector<pieces::LocalParam> &corners, double enough);
    // The last axis is the fastest; axes without a degree have one end.
    static std::vector<pieces::LocalParam> corners_of(const pieces::BezierPiece &x);

private:
    PieceJet jet_;
    PairDescent descent_;
};

} // namespace nrb::closest
