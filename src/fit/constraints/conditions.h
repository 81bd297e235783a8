// SPDX-License-Identifier: MIT
// Linear equality constraints of a fit.
#pragma once

#include "fit/constraints/linear_rows.h"
#include "fit/least_squares/penalised_system.h"

#include <array>
#include <vector>

namespace nrb::fit {

// Derivative `orders` of the spline at `place` is target[dim].
struct FitCondition {
    std::array<double, max_axes> place;
    std::array<int, max_axes> orders;
    std::vector<double> target;
};

// The equations as rows of coefficients of the unknowns.
class Conditions {
public:
    Conditions(const std::vector<KnotVectorPtr> &axes, const std::vector<FitCondition> &conditions);

    [[nodiscard]] bool empty() const noexcept { return rows_.empty(); }
    [[nodiscard]] const std::vector<LinearRow> &rows() const noexcept { return rows_; }
    // Adds a multiple of the squared residuals of the conditions to the sum that is minimised. They vanish at
    // the solution, and determine what only the conditions determine.
    void add_squares(NormalEquations &equations);
    // Moves x from the minimum of that sum to the minimum under the conditions, by Lagrange multipliers.
    // Throws Status::contradiction with the index of a condition that those before it, or the spline, do not
    // allow. Returns by how much the trace of the influence matrix of the data is less than that of the
    // equations with the squares.
    double impose(PenalisedSystem &system, int dim, std::vector<DoubleDouble> &x) const;

private:
    [[nodiscard]] double lost_freedom(const PenalisedSystem &system, const std::vector<DoubleDouble> &columns,
                                      const std::vector<DoubleDouble> &matrix) const;

    std::vector<LinearRow> rows_;
    DoubleDouble factor_; // of the squares
};

} // namespace nrb::fit
