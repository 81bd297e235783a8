// SPDX-License-Identifier: MIT
// The Bernstein pieces of a spline over a part of its domain.
#pragma once

#include "pieces/bernstein_net.h"
#include "pieces/largest_quotient.h"
#include "spline/part.h"

namespace nrb::pieces {

// Ends of the pieces of an axis in an interval of its domain: its knots inside, and the ends.
std::vector<double> breaks_in(const KnotVector &axis, Interval part);

// The pieces about the middle of the control points, x - c.
class SplinePieces {
public:
    SplinePieces(const Spline &spline, const Part &part);
    // About another centre.
    SplinePieces(const Spline &spline, const Part &part, std::vector<double> centre);

    [[nodiscard]] int64_t count() const noexcept { return net_.pieces(); }
    [[nodiscard]] const std::vector<double> &centre() const noexcept { return centre_; }
    // The parameter at places between 0 and 1 of a piece on each of the last axes of the three; the ends of
    // pieces bit for bit.
    [[nodiscard]] std::array<double, max_axes> parameter(int64_t piece,
                                                         const std::array<double, max_axes> &place) const;

    // sign * coordinate of x - c, as a quotient.
    void fill(int64_t piece, int coordinate, double sign, QuotientPiece &out) const;
    // direction . (x - c).
    void fill(int64_t piece, const double *direction, QuotientPiece &out) const;
    // M (x - c) for a matrix of `rows` rows. Its rows are at most `norm` long, and its value too.
    void fill(int64_t piece, const double *matrix, int rows, double norm, QuotientPiece &out) const;

private:
    void begin(int64_t piece, int rows, double norm, double rounding, QuotientPiece &out) const;

    int axes_;
    std::vector<double> centre_;
    BernsteinNet::Breaks breaks_;
    BernsteinNet net_;
    mutable std::vector<double> coordinates_; // of the present piece
};

} // namespace nrb::pieces
