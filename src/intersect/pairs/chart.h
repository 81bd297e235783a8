// SPDX-License-Identifier: MIT
// Pairs of pieces of curves that come near each other in one place at most.
#pragma once

#include "base/numbers.h"
#include "intersect/pairs/slopes.h"

#include <array>

namespace nrb::intersect {

// F(x, y) = A(x) - B(y) over [0, 1]^2, and a matrix M of two rows with M F' near the identity: rho is the
// largest row sum of |M F' - I| over all of it. If rho < 1, then for every z and z0 of the square
//     |z - z0| (1 - rho) <= |M (F(z) - F(z0))|        in the maximum norm
// (R. Krawczyk 1969), so that there is one place at most where F is 0, and all where |F| is small lie close
// together.
class Chart {
public:
    void set(const Slopes &a, const Slopes &b, int dim);

    [[nodiscard]] bool proven() const noexcept { return rho_ < 0.9; }
    // Whether a row of M F is nowhere as small as where |F| <= near, as control points tell. Precondition: proven().
    [[nodiscard]] bool excludes(const pieces::BezierPiece &a, const pieces::BezierPiece &b,
                                double near) const noexcept;
    // One step of Newton's method with M from a difference.
    [[nodiscard]] std::array<double, 2> step(const double *difference) const noexcept;
    // The square of the sine between the mean slopes.
    [[nodiscard]] double square_of_sine() const noexcept { return sine_; }
    // How far from z0 a place may be where |F| <= `near`, if F(z0) is the difference.
    [[nodiscard]] double radius(const double *difference, double near) const noexcept;
    // Where such places are, beyond the square too. What is nearer to z0 by the radius r is also nearer to what
    // a step leads to by rho r + |M| near.
    [[nodiscard]] std::array<Interval, 2> solutions(const std::array<double, 2> &z0, const double *difference,
                                                    double near) const noexcept;
    // 1 or -1: A' x B' in the plane.
    [[nodiscard]] int turn() const noexcept { return turn_; }

private:
    bool set_rows(const double *u, const double *v);
    [[nodiscard]] const double *row(size_t k) const noexcept {
        return rows_.data() + k * static_cast<size_t>(dim_);
    }

    int dim_ = 0;
    std::vector<double> rows_; // of M
    double norm_ = 0;          // the largest one of its rows
    double rho_ = infinity;
    double sine_ = 0;
    int turn_ = 0;
};

} // namespace nrb::intersect
