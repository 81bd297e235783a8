// SPDX-License-Identifier: MIT
// A start for least squares under linear inequalities.
#pragma once

#include "fit/constraints/linear_rows.h"
#include "fit/least_squares/penalised_system.h"

#include <vector>

namespace nrb::fit {

// Steps towards min x A x / 2 - r x under C x >= d, and under equations, through the inside of the inequalities (S. Mehrotra, "On
// the implementation of a primal-dual interior point method", SIAM J. Optim. 2 (1992)): with slacks s = C x - d and multipliers
// z, all positive, each step has the matrix A + C^T (z / s) C, and s z goes to 0. Their number hardly depends on that of the
// rows. It ends where the matrix has become too stiff for its factors, which is why others have to finish.
class InteriorPoint {
public:
    // `equations` of dimension 1: matrix A and right side r; the first `equal` rows are equations. All outlive it.
    InteriorPoint(const NormalEquations &equations, const std::vector<LinearRow> &rows, size_t equal);

    struct Point {
        std::vector<DoubleDouble> x, multipliers; // of all rows
    };
    [[nodiscard]] Point from(const std::vector<DoubleDouble> &x);

private:
    using Numbers = std::vector<DoubleDouble>;
    struct Step {
        Numbers x, slacks, multipliers;
    };
    void start(const Numbers &x);
    // What the equations of the optimum are missed by.
    void measure();
    [[nodiscard]] bool factorise();
    // The step for which s z becomes `products`, to first order.
    [[nodiscard]] Step step_to(const Numbers &products);
    // The largest part of it that keeps slacks and multipliers positive.
    [[nodiscard]] double allowed(const Step &step) const noexcept;
    [[nodiscard]] double mean_product(const Step &step, double part) const noexcept;
    void take(const Step &step, double part) noexcept;

    const NormalEquations &equations_;
    const std::vector<LinearRow> &rows_;
    size_t equal_;
    PenalisedSystem plain_, stiff_;
    double mean_ = 1, size_ = 0; // of the diagonal of A, and of x
    Numbers x_, slacks_, multipliers_;
    Numbers gradient_, missed_; // A x - r - C z; C x - d - s
    double product_ = 0;        // mean of s z
};

} // namespace nrb::fit
