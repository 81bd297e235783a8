// SPDX-License-Identifier: MIT
// The choice of the smoothing parameter lambda, the factor of the penalty.
#pragma once

#include "fit/least_squares/penalised_system.h"

#include <vector>

namespace nrb::fit {

enum class Smoothing : int32_t { none, given, gcv, reml, discrepancy };

// A minimum of sum w |y - s|^2 + lambda P(s).
struct Smoothed {
    double lambda = 0;
    std::vector<DoubleDouble> x; // [unknowns][dim]
    double squares = 0;          // remaining sum w |y - s|^2
    double residual = 0;         // of the equations, relative to their right sides
    double freedom = 0;          // trace of the influence matrix
    bool reached = true;         // whether the target of Smoothing::discrepancy was reached
    bool settled = true;         // whether a shape that the data leave open has converged
    int decided_by = -1;         // order of the penalty that decided what the data leave open, -1: none
};

struct Criteria {
    double squares, freedom, gcv, reml;
};

// Chooses lambda. Let there be n data of dimension dim, residual squares R, degrees of freedom t (the trace
// of the influence matrix), and N unknowns, M of them without a penalty (the dimension of its null space).
// Then lambda is `value`, limited to where only polynomials are left; or it minimises one of
// - gcv: n R / (n - t)^2 (P. Craven, G. Wahba, "Smoothing noisy data with spline functions", Numer. Math. 31
//   (1979)),
// - reml: (n - M) log (R + lambda P) + log det (G + lambda P) - (N - M) log lambda (S. Wood, "Fast stable
//   restricted maximum likelihood ...", J. R. Statist. Soc. B 73 (2011));
// or, for discrepancy, it is the largest one for which R is at most `value` (C. Reinsch, "Smoothing by spline
// functions", Numer. Math. 10 (1967)).
// With at least as many unknowns as data, gcv tends to 0 / 0, and is compared only for traces that leave
// 2^-10 of the data over. A lambda is passed over if rounding makes the trace uncertain, or if the equations
// lose their rank.
// The search runs from 10^-10 tr G / tr P to where only polynomials are left, in steps of a factor of ten,
// and then between these. The number of solutions is bounded, and nothing depends on the scale of data,
// parameters or weights.
class LambdaSearch {
public:
    LambdaSearch(const NormalEquations &equations, const StencilMatrix &penalty, int penalty_order,
                 PenalisedSystem &system);

    [[nodiscard]] Smoothed choose(Smoothing rule, double value);
    [[nodiscard]] Smoothed at(double lambda);
    // The criteria at lambda, in units in which weights and squares of values are multiplied by powers of
    // two.
    [[nodiscard]] Criteria criteria(double lambda, int weight_exponent, int square_exponent);

private:
    [[nodiscard]] double squares_at(double exponent);
    // For the current factors of the system.
    [[nodiscard]] double criterion(Smoothing rule, double lambda);
    [[nodiscard]] double gcv(double squares) const;
    // The trace of the influence matrix, as far as rounding shows it: between 0 and the numbers of data and
    // of unknowns.
    [[nodiscard]] double freedom() const;
    // `log_squares` and `log_weights` are the logarithms of the units of the weighted squares and of the
    // weights.
    [[nodiscard]] double reml(const PenalisedSystem::Numbers &x, double lambda, double log_squares = 0,
                              double log_weights = 0) const;
    [[nodiscard]] double lambda_of(double exponent) const noexcept;
    [[nodiscard]] Smoothed smallest(Smoothing rule);
    [[nodiscard]] Smoothed within(double target);

    const NormalEquations &equations_;
    PenalisedSystem &system_;
    double free_unknowns_;
    double scale_;
    double widest_; // decimal exponent of the largest lambda
};

} // namespace nrb::fit
