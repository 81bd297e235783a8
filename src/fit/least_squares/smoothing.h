// SPDX-License-Identifier: MIT
// How smooth a fit should be.
#pragma once

#include "fit/least_squares/penalised_system.h"

#include <vector>

namespace nrb::fit {

enum class Smoothing : int32_t { none, given, gcv, reml, discrepancy };

// A minimum of sum w |y - s|^2 + lambda P(s).
struct Smoothed {
    double lambda = 0;
    std::vector<DoubleDouble> x; // [unknowns][dim]
    double squares = 0;          // what is left of sum w |y - s|^2
    double residual = 0;         // of the equations, relative to their right sides
    double freedom = 0;          // trace of the influence matrix
    bool reached = true;         // the target, of Smoothing::discrepancy
    bool settled = true;         // whether a shape that the data leave open is found
    int decided_by = -1;         // order of the penalty that decided what the data do not, -1: none had to
};

struct Criteria {
    double squares, freedom, gcv, reml;
};

// With n data of the dimension dim, residual squares R, freedom t, N unknowns and M of them without a penalty, lambda is
// `value`, limited to where only polynomials are left, or minimises one of
// - n R / (n - t)^2 (P. Craven, G. Wahba, "Smoothing noisy data with spline functions", Numer. Math. 31 (1979)),
// - (n - M) log (R + lambda P) + log det (G + lambda P) - (N - M) log lambda (S. Wood, "Fast stable restricted maximum
//   likelihood ...", J. R. Statist. Soc. B 73 (2011)),
// or is the largest one for which R is at most `value` (C. Reinsch, "Smoothing by spline functions", Numer. Math. 10 (1967)).
// Where there are no fewer unknowns than data the first criterion ends in 0 / 0, so that it is compared for traces that leave
// 2^-10 of the data over; where rounding makes the trace unsure, or the equations lose their rank, it is passed over.
// It is looked for between 10^-10 tr G / tr P and where only polynomials are left, in steps of ten, then between these: a
// bounded number of solutions, and nothing depends on the scale of data, parameters or weights.
class LambdaSearch {
public:
    LambdaSearch(const NormalEquations &equations, const StencilMatrix &penalty, int penalty_order,
                 PenalisedSystem &system);

    [[nodiscard]] Smoothed choose(Smoothing rule, double value);
    [[nodiscard]] Smoothed at(double lambda);
    // What is compared, in units in which weights and squares of values are multiplied by powers of two.
    [[nodiscard]] Criteria criteria(double lambda, int weight_exponent, int square_exponent);

private:
    [[nodiscard]] double squares_at(double exponent);
    // For the factors that there are.
    [[nodiscard]] double criterion(Smoothing rule, double lambda);
    [[nodiscard]] double gcv(double squares) const;
    // The trace of the influence matrix, as far as rounding lets it be told: between 0 and what there is of data and unknowns.
    [[nodiscard]] double freedom() const;
    // With a factor of the squares of values, and one of the weights, as logarithms.
    [[nodiscard]] double reml(const PenalisedSystem::Numbers &x, double lambda, double log_squares = 0,
                              double log_weights = 0) const;
    [[nodiscard]] double lambda_of(double exponent) const noexcept;
    [[nodiscard]] Smoothed smallest(Smoothing rule);
    [[nodiscard]] Smoothed within(double target);

    const NormalEquations &equations_;
    PenalisedSystem &system_;
    double free_unknowns_;
    double scale_;
    double widest_; // exponent of the largest lambda
};

} // namespace nrb::fit
