// SPDX-License-Identifier: MIT
// A starting point for least squares under linear inequalities.
#pragma once

#include "fit/constraints/linear_rows.h"
#include "fit/least_squares/penalised_system.h"

#include <vector>

namespace nrb::fit {

// A primal-dual interior point method for min x^T A x / 2 - r^T x under C x >= d and equations (S. Mehrotra,
// "On the implementation of a primal-dual interior point method", SIAM J. Optim. 2 (1992)). With slacks
// s = C x - d and multipliers z, all positive, each step has the matrix A + C^T (z / s) C, and s z tends to
// 0. The number of steps hardly depends on the number of rows. The method ends where the matrix has become
// too ill-conditioned to be factorised, which is why another method (Inequalities) has to finish.
class InteriorPoint {
public:
    // `equations` of dimension 1: matrix A and right side r. The first `equal` rows are equations. All
    // arguments have to outlive this object.
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
    // Computes the residuals of the optimality conditions.
    void measure();
    [[nodiscard]] bool factorise();
    // The step after which s z is `products`, to first order.
    [[nodiscard]] Step step_to(const Numbers &products);
    // The largest part of a step that keeps slacks and multipliers positive.
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
