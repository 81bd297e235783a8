// SPDX-License-Identifier: MIT
// Implicit polynomials: f(x) = 0 is a line, a plane, a conic, a quadric or an algebraic set of higher degree.
#pragma once

#include "pieces/derivative_pieces.h"

#include <span>
#include <vector>

namespace nrb::intersect {

// The number of monomials of total degree at most `degree`; the largest int64_t if there are more.
int64_t monomials(int variables, int degree) noexcept;

// The polynomial f, the sum of c x_i x_j ... x_k over i <= j <= ... <= k, with `degree` factors from the
// variables x_0 to x_(m - 1) and x_m = 1. The coefficients c are in lexicographic order: a x + b y + c of a
// line, a x x + b x y + c x + d y y + e y + f of a conic.
class ImplicitForm {
public:
    // Precondition: coefficients.size() == monomials(variables, degree), degree >= 1.
    ImplicitForm(int variables, int degree, std::span<const double> coefficients);

    [[nodiscard]] int degree() const noexcept { return degree_; }
    [[nodiscard]] int variables() const noexcept { return variables_; }
    [[nodiscard]] std::span<const double> coefficients() const noexcept { return coefficients_; }

    // The Bernstein form of f(x) w^degree on a piece, in the unit of f.
    [[nodiscard]] RoundedPolynomial on(const pieces::HomogeneousPiece &piece) const;

private:
    int variables_;
    int degree_;
    std::vector<double> coefficients_;
};

} // namespace nrb::intersect
