// SPDX-License-Identifier: MIT
// Local minima of the distance between two Bezier pieces.
#pragma once

#include "pieces/bezier_piece.h"
#include "pieces/damped_descent.h"

namespace nrb::closest {

// A pair of places, one on each of two pieces.
struct PairPlace {
    pieces::LocalParam a{}, b{};
    double distance = 0;
    std::vector<double> from, to; // the points at the places
};

// A point of a piece, and its first and second derivatives with respect to local parameters.
class PieceJet {
public:
    void evaluate(const pieces::BezierPiece &piece, const pieces::LocalParam &place, bool derivatives);
    [[nodiscard]] const double *value() const noexcept { return values_.data(); }
    [[nodiscard]] const double *first(int k) const noexcept { return values_.data() + (1 + k) * dim_; }
    [[nodiscard]] const double *second(int k, int l) const noexcept; // k <= l

private:
    void set_rows(const pieces::BezierPiece &piece, const pieces::LocalParam &place);
    void contract(const pieces::BezierPiece &piece, bool derivatives);
    void divide(bool derivatives);
    // The factor of a coefficient: the product over all axes of its Bernstein functions, or of their
    // derivatives. first, second: the axes of differentiation, -1 for none.
    [[nodiscard]] double factor(const std::array<int, max_axes> &at, int first, int second) const noexcept;

    int axes_ = 1, dim_ = 1;
    std::vector<double> values_, records_, rows_;
};

// Descends to a local minimum of the distance from given places.
class PairDescent {
public:
    void run(const pieces::BezierPiece &a, const pieces::BezierPiece &b, PairPlace &at);

private:
    using Jet = pieces::SquareJet<2 * max_axes>;
    // An axis, of positive degree, of one of the two pieces.
    struct Axis {
        bool of_a;
        size_t k;
    };
    void set_axes(const pieces::BezierPiece &a, const pieces::BezierPiece &b);
    // |S|^2 for the difference S of the points, with its derivatives along axes_.
    Jet jet(const pieces::BezierPiece &a, const pieces::BezierPiece &b, const PairPlace &at);
    [[nodiscard]] const double *first(const Axis &axis) const noexcept;
    [[nodiscard]] double bend(const double *difference, const Axis &i, const Axis &j) const noexcept;

    PieceJet a_, b_;
    std::vector<Axis> axes_;
    std::vector<double> difference_;
};

} // namespace nrb::closest
