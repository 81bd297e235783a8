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
    using Numbers = std::vector<DoubleDouble>;

    // Without a penalty P is 0.
    PenalisedSystem(const NormalEquations &equations, const StencilMatrix *penalty);

    // Another matrix G of the same pattern, instead of that of the equations.
    void set_matrix(const StencilMatrix &matrix);

    // The factor, or the largest one beside which digits of the data are left: beyond it the minimum is the same, one of
    // functions that pay nothing.
    [[nodiscard]] double limited(double lambda) const;
    // Returns -1, or an unknown that is not determined.
    [[nodiscard]] int64_t try_factorise(double lambda);
    // The same, also where rounding of the sums may be all that determines it.
    [[nodiscard]] int64_t try_factorise_surely(double lambda);
    // Throws Status::rank naming the control point.
    void factorise(double lambda);
    [[noreturn]] void fail_rank(int64_t unknown) const;
    // Solutions for right sides [unknowns][width].
    [[nodiscard]] Numbers solve(const Numbers &right, int64_t width);
    // The solution for the right side of the equations: to be trusted where it is compared with others.
    [[nodiscard]] Numbers estimate();

    // Of x[unknowns][dim]: r - G x; sum w |y - s|^2; |G x + lambda P x - r| / |r|.
    [[nodiscard]] Numbers missing(const Numbers &x) const;
    // G x for x[unknowns][width].
    [[nodiscard]] Numbers product(const Numbers &x, int64_t width) const;
    [[nodiscard]] double remaining_squares(const Numbers &x) const;
    [[nodiscard]] double relative_residual(const Numbers &x) const;

    // Of the factors: the trace of (G + lambda P)^(-1) G, with its error as the trace of (G + lambda P)^(-1) (G + lambda P) shows it;
    // and log det (G + lambda P).
    struct Freedom {
        double value, error;
    };
    [[nodiscard]] Freedom freedom() const;
    [[nodiscard]] double log_determinant() const;
    // The trace of (G + lambda P)^(-1) times another matrix of the same pattern.
    [[nodiscard]] double trace_with(const StencilMatrix &matrix) const;
    // The elements of the inverse for overlapping functions, by place_of() their unknowns.
    [[nodiscard]] SelectedInverse inverse() const;
    [[nodiscard]] int64_t place_of(int64_t unknown) const noexcept {
        return place_[static_cast<size_t>(unknown)];
    }

private:
    [[nodiscard]] int64_t factorise_in_double();
    [[nodiscard]] int64_t factorise_precisely();
    [[nodiscard]] bool refine(const Numbers &right, int64_t width, Numbers &x) const;
    void correct(Numbers &residual, int64_t width) const;
    // Rows in the order of elimination, and back.
    [[nodiscard]] Numbers ordered(const Numbers &x, int64_t width) const;
    [[nodiscard]] Numbers restored(const Numbers &x, int64_t width) const;
    template <class Number>
    [[nodiscard]] int64_t unsure_pivot(const LdltOf<Number> &factors) const;

    const NormalEquations &equations_;
    double lambda_ = 0;
    std::vector<int64_t> order_, place_;
    ColumnsOf<DoubleDouble> data_, smooth_, sum_; // G, P, G + lambda P
    std::optional<SparseLdlt> factors_;
    std::optional<LdltOf<DoubleDouble>> precise_; // if they were needed
    bool in_double_ = false;
};

} // namespace nrb::fit
