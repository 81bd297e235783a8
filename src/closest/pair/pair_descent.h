// Nearest points of two pieces: Newton's method in a box.
#pragma once

#include "pieces/bezier_piece.h"

namespace nrb::closest {

// A place on a piece of each of two splines.
struct PairPlace {
    pieces::Place a{}, b{};
    double distance = 0;
    std::vector<double> from, to; // the points
};

// A point of a piece, and its first and second derivatives with respect to places.
class PieceJet {
public:
    void evaluate(const pieces::BezierPiece &piece, const pieces::Place &place, bool derivatives);
    [[nodiscard]] const double *value() const noexcept { return values_.data(); }
    [[nodiscard]] const double *first(int k) const noexcept { return values_.data() + (1 + k) * dim_; }
    [[nodiscard]] const double *second(int k, int l) const noexcept; // k <= l

private:
    int axes_ = 1, dim_ = 1;
    std::vector<double> values_, records_, rows_, work_;
};

// A local minimum of the distance from places to begin with. Steps decrease the distance; where the second
// derivatives are not positive definite they are damped by the first ones (Levenberg and Marquardt).
class PairDescent {
public:
    void run(const pieces::BezierPiece &a, const pieces::BezierPiece &b, PairPlace &at);

private:
    double evaluate(const pieces::BezierPiece &a, const pieces::BezierPiece &b, const PairPlace &at,
                    bool derivatives);
    bool step(const pieces::BezierPiece &a, const pieces::BezierPiece &b, PairPlace &at, double &square);

    PieceJet a_, b_;
    std::vector<double> difference_;
    std::array<std::array<double, 2 * max_axes>, 2 * max_axes> curvature_{}, metric_{};
    std::array<double, 2 * max_axes> gradient_{};
};

} // namespace nrb::closest
