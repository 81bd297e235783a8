// SPDX-License-Identifier: MIT
// Least squares under linear inequalities.
#pragma once

#include "fit/constraints/linear_rows.h"
#include "fit/least_squares/penalised_system.h"

#include <vector>

namespace nrb::fit {

// Minimises x^T A x / 2 - r^T x under rows C x >= d, some of them C x = d, for one coordinate, by the method
// of multipliers, also known as the augmented Lagrangian method (M. Hestenes, "Multiplier and gradient
// methods", J. Optim. Theory Appl. 4 (1969)). With multipliers m and a factor f, each step minimises
//     x^T A x / 2 - r^T x + sum max(0, m + f (d - C x))^2 / (2 f)
// and then sets m = max(0, m + f (d - C x)) (R. Rockafellar, "A dual approach to solving nonlinear
// programming problems by unconstrained optimization", Math. Program. 5 (1973)). That function is convex and
// piecewise quadratic, so that Newton's method with exact line searches ends after finitely many steps. The
// matrices A + f C^T C of the rows that count have the pattern of A.
class Inequalities {
public:
    // `equations` of dimension 1: matrix A and right side r. The first `equal` rows are equations.
    Inequalities(NormalEquations equations, std::vector<LinearRow> rows, size_t equal);

    // Starts from x. Throws Status::contradiction if no x fulfils the rows, Status::rank if the minimum is
    // not unique.
    [[nodiscard]] std::vector<DoubleDouble> minimum(std::vector<DoubleDouble> x);
    // The trace of the influence matrix at the minimum, with the rows that hold as equations; `data` is the
    // matrix G of the data.
    [[nodiscard]] double freedom(const StencilMatrix &data);

private:
    using Numbers = std::vector<DoubleDouble>;
    // m + f (d - C x) of all rows; 0 for inequalities that do not count.
    [[nodiscard]] Numbers forces(const Numbers &x) const;
    [[nodiscard]] Numbers left_sides(const Numbers &x) const;
    void minimise(Numbers &x);
    [[nodiscard]] int64_t try_factorise(const std::vector<bool> &counting, double factor);
    void factorise(const std::vector<bool> &counting);
    [[nodiscard]] Numbers newton_step(const std::vector<bool> &counting);
    [[nodiscard]] double best_part(const Numbers &x, const Numbers &end, const Numbers &step) const;
    // The largest violation of a row, or of its complementarity: an inequality with a positive multiplier has
    // to hold as an equation.
    [[nodiscard]] double missed(const Numbers &x) const;
    [[nodiscard]] bool equation(size_t row) const noexcept { return row < equal_; }
    [[nodiscard]] std::vector<bool> counting(const Numbers &x) const;

    NormalEquations equations_;
    std::vector<LinearRow> rows_;
    size_t equal_;
    PenalisedSystem plain_, stiff_;
    Numbers multipliers_;
    double mean_, factor_, strongest_; // of the diagonal of A; the factor f, and the largest one to be tried
    std::vector<bool> factorised_;     // the rows in the factors of stiff_
    double factor_of_factors_ = 0;
};

} // namespace nrb::fit
