// SPDX-License-Identifier: MIT
// The Bernstein pieces of a spline over a part of its domain.
#pragma once

#include "pieces/bernstein_net.h"
#include "pieces/largest_quotient.h"
#include "spline/part.h"

namespace nrb::pieces {

// The breaks of an axis in an interval of its domain: the knots inside, and both ends.
std::vector<double> breaks_in(const KnotVector &axis, Interval part);

// The pieces x - c about the middle c of the control points.
class SplinePieces {
public:
    SplinePieces(const Spline &spline, const Part &part);
    // About another centre.
    SplinePieces(const Spline &spline, const Part &part, std::vector<double> centre);

    [[nodiscard]] int64_t count() const noexcept { return net_.pieces(); }
    [[nodiscard]] const std::vector<double> &centre() const noexcept { return centre_; }
    // The parameter at local parameters in [0, 1] of a piece, given for the last of the three axes; exact at
    // the ends of pieces.
    [[nodiscard]] std::array<double, max_axes> parameter(int64_t piece,
                                                         const std::array<double, max_axes> &place) const;

    // sign * coordinate of x - c, as a quotient.
    void fill(int64_t piece, int coordinate, double sign, QuotientPiece &out) const;
    // direction . (x - c), as a quotient.
    void fill(int64_t piece, const double *direction, QuotientPiece &out) const;
    // M (x - c) for a matrix M of `rows` rows. `norm` bounds the length of its rows, and the operator norm of
    // M.
    void fill(int64_t piece, const double *matrix, int rows, double norm, QuotientPiece &out) const;

private:
    void begin(int64_t piece, int rows, double norm, double rounding, QuotientPiece &out) const;

    int axes_;
    std::vector<double> centre_;
    BernsteinNet::Breaks breaks_;
    BernsteinNet net_;
    mutable std::vector<double> coordinates_; // of the current piece
};

} // namespace nrb::pieces
