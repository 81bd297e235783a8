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
};

// With n data of the dimension dim, residual squares R, freedom t, N unknowns and M of them without a penalty, lambda is
// `value`, or minimises one of
// - n R / (n - t)^2 (P. Craven, G. Wahba, "Smoothing noisy data with spline functions", Numer. Math. 31 (1979)),
// - (n - M) log (R + lambda P) + log det (G + lambda P) - (N - M) log lambda (S. Wood, "Fast stable restricted maximum
//   likelihood ...", J. R. Statist. Soc. B 73 (2011)),
// or is the largest one for which R is at most `value` (C. Reinsch, "Smoothing by spline functions", Numer. Math. 10 (1967)).
// It is looked for between 10^-10 tr G / tr P and where only polynomials are left, in steps of ten, then between these: a
// bounded number of solutions, and nothing depends on the scale of data, parameters or weights.
class LambdaSearch {
public:
    // `free_unknowns`: M.
    LambdaSearch(const NormalEquations &equations, const StencilMatrix &penalty, PenalisedSystem &system,
                 double free_unknowns);

    [[nodiscard]] Smoothed choose(Smoothing rule, double value);
    [[nodiscard]] Smoothed at(double lambda);

private:
    [[nodiscard]] double squares_at(double exponent);
    [[nodiscard]] double criterion(Smoothing rule, double exponent);
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
