// SPDX-License-Identifier: MIT
// Normal equations with a penalty, solved for one value of its factor after the other.
#pragma once

#include "fit/least_squares/normal_equations.h"
#include "numeric/solvers/sparse/selected_inverse.h"

#include <optional>

namespace nrb::fit {

// The equations (G + lambda P) x = r, solved by sparse L D L^T factors with iterative refinement. Factors in
// double precision are corrected by residuals in double-double precision; where that does not converge, the
// factors are in double-double precision as well. The condition of G is the square of that of the
// least-squares problem; in spite of that, the error of x is that of the equations, not of their solution.
class PenalisedSystem {
public:
    using Numbers = std::vector<DoubleDouble>;

    // P is 0 if `penalty` is null.
    PenalisedSystem(const NormalEquations &equations, const StencilMatrix *penalty);

    // Replaces G, that of the equations, by another matrix of the same pattern.
    void set_matrix(const StencilMatrix &matrix);

    // The smaller one of lambda and the largest factor beside which digits of the data are left: beyond that
    // factor the minimum stays the same, a function without penalty.
    [[nodiscard]] double limited(double lambda) const;
    // Returns -1, or an unknown that is not determined.
    [[nodiscard]] int64_t try_factorise(double lambda);
    // The same, but also returns an unknown that may be determined by nothing but rounding errors of the
    // sums. Systems with expensive factorisations are not examined for that.
    [[nodiscard]] int64_t try_factorise_surely(double lambda);
    // Both throw Status::rank naming a control point that is not determined, fail_rank() always.
    void factorise(double lambda);
    [[noreturn]] void fail_rank(int64_t unknown) const;
    // The solutions for right-hand sides [unknowns][width].
    [[nodiscard]] Numbers solve(const Numbers &right, int64_t width);
    // The solution for the right-hand side of the equations, without refinement if the factors are in double
    // precision: accurate enough to be compared with others.
    [[nodiscard]] Numbers estimate();

    // For x[unknowns][dim]: missing() is r - G x, remaining_squares() is sum w |y - s|^2, and
    // relative_residual() is |(G + lambda P) x - r| / |r|.
    [[nodiscard]] Numbers missing(const Numbers &x) const;
    // G x for x[unknowns][width].
    [[nodiscard]] Numbers product(const Numbers &x, int64_t width) const;
    [[nodiscard]] double remaining_squares(const Numbers &x) const;
    [[nodiscard]] double relative_residual(const Numbers &x) const;

    // From the factors: freedom() is the trace of (G + lambda P)^(-1) G, the degrees of freedom, with its
    // error as the trace of (G + lambda P)^(-1) (G + lambda P) shows it; log_determinant() is
    // log det (G + lambda P).
    struct Freedom {
        double value, error;
    };
    [[nodiscard]] Freedom freedom() const;
    [[nodiscard]] double log_determinant() const;
    // The trace of (G + lambda P)^(-1) times another matrix of the same pattern.
    [[nodiscard]] double trace_with(const StencilMatrix &matrix) const;
    // The elements of the inverse for overlapping functions; place_of() gives the row of an unknown.
    [[nodiscard]] SelectedInverse inverse() const;
    [[nodiscard]] int64_t place_of(int64_t unknown) const noexcept {
        return place_[static_cast<size_t>(unknown)];
    }

private:
    [[nodiscard]] int64_t factorise_in_double();
    [[nodiscard]] int64_t factorise_precisely();
    [[nodiscard]] bool refine(const Numbers &right, int64_t width, Numbers &x) const;
    void correct(Numbers &residual, int64_t width) const;
    // ordered(): rows permuted into the order of elimination; restored(): back.
    [[nodiscard]] Numbers ordered(const Numbers &x, int64_t width) const;
    [[nodiscard]] Numbers restored(const Numbers &x, int64_t width) const;
    template <class Number>
    [[nodiscard]] int64_t unsure_pivot(const LdltOf<Number> &factors) const;

    const NormalEquations &equations_;
    double lambda_ = 0;
    std::vector<int64_t> order_, place_;
    ColumnsOf<DoubleDouble> data_, smooth_, sum_; // G, P, G + lambda P
    std::optional<SparseLdlt> factors_;
    std::optional<LdltOf<DoubleDouble>> precise_; // once they have been needed
    bool in_double_ = false;
};

} // namespace nrb::fit
