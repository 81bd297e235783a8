// SPDX-License-Identifier: MIT
// Normal equations with a penalty, for one value of its factor after the other.
#pragma once

#include "fit/least_squares/normal_equations.h"
#include "numeric/solvers/sparse/selected_inverse.h"

#include <optional>

namespace nrb::fit {

// (G + lambda P) x = r. Factors in double precision are corrected by residuals of twice the precision; where that does not
// lead to the solution, the factors have twice the precision as well. So its error is that of the equations, not of their
// solution: the condition of G is the square of that of least squares.
class PenalisedSystem {
public:
    // Without a penalty P is 0.
    PenalisedSystem(const NormalEquations &equations, const StencilMatrix *penalty);

    // Throws Status::rank naming a control point that the data do not determine.
    void factorise(double lambda);
    // Solutions for right sides [unknowns][width].
    [[nodiscard]] std::vector<DoubleDouble> solve(const std::vector<DoubleDouble> &right, int64_t width);

    // Of the factors: the trace of (G + lambda P)^(-1) G, and log det (G + lambda P).
    [[nodiscard]] double freedom() const;
    [[nodiscard]] double log_determinant() const;
    // The elements of the inverse for overlapping functions, by unknowns.
    [[nodiscard]] SelectedInverse inverse() const;
    [[nodiscard]] int64_t place_of(int64_t unknown) const noexcept { return place_[static_cast<size_t>(unknown)]; }

private:
    [[nodiscard]] bool factorise_in_double();
    void factorise_precisely();
    [[nodiscard]] bool refine(const std::vector<DoubleDouble> &right, int64_t width,
                              std::vector<DoubleDouble> &x) const;
    void correct(std::vector<DoubleDouble> &residual, int64_t width) const;
    void multiply(const std::vector<DoubleDouble> &x, int64_t width, std::vector<DoubleDouble> &y) const;
    template <class T>
    [[nodiscard]] std::vector<T> ordered(const std::vector<DoubleDouble> &x, int64_t width) const;
    [[noreturn]] void fail_rank(int64_t unknown) const;

    const NormalEquations &equations_;
    const StencilMatrix *penalty_;
    double lambda_ = 0;
    std::vector<int64_t> order_, place_;
    SparseColumns data_, smooth_;
    std::optional<SparseLdlt> factors_;
    std::optional<LdltOf<DoubleDouble>> precise_; // if in use
    bool in_double_ = false;
};

} // namespace nrb::fit
