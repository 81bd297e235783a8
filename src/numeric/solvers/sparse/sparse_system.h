// SPDX-License-Identifier: MIT
// Sparse symmetric positive definite systems that depend on a parameter.
#pragma once

#include "numeric/solvers/sparse/conjugate_gradients.h"

#include <cstdint>
#include <deque>
#include <optional>
#include <vector>

namespace nrb::inline numeric {

// Entry (i, j) of a symmetric matrix; its mirror image is an entry of its own.
struct Entry {
    int64_t row;
    int64_t column;
    double value;
};

// K x for x[unknowns][width].
std::vector<double> times(const std::vector<Entry> &entries, const std::vector<double> &x, int64_t width);

// Solves systems with K + rho D for many rho. Where a factorisation costs more than many products with K,
// conjugate gradients start from the best combination of the last solutions, preconditioned by the diagonal.
// If they do not converge in a limited number of steps, as with a small rho, the matrix for this rho is
// factorised; the factors then precondition the systems for nearby rho.
class SparseSystem {
public:
    // The entries between unknowns 0 to n - 1 (K), the diagonal (D), and the elimination order of the
    // unknowns. Precondition: n < 2^31.
    SparseSystem(const std::vector<Entry> &entries, std::vector<double> diagonal, std::vector<int64_t> order);

    // x[n][width] of (K + rho D) x = right; false if a pivot is not positive.
    [[nodiscard]] bool solve(double rho, const std::vector<double> &right, int64_t width,
                             std::vector<double> &x);

private:
    static constexpr int few_steps = 5; // they cost less than a new factorisation

    [[nodiscard]] SparseColumns shifted(double rho) const;
    [[nodiscard]] bool factors_suit(double rho) const noexcept;
    bool iterate(double rho, std::vector<double> &x, int64_t width);
    bool factorise(double rho);
    void remember(double rho, std::vector<double> x);

    std::vector<double> diagonal_; // in elimination order, as the members below
    std::vector<int64_t> order_;
    SparseColumns entries_;
    std::optional<SparseLdlt> factors_;
    bool factorised_ = false; // for factors_rho_
    double factors_rho_ = 0;
    std::vector<double> right_;
    std::deque<ShiftedSolution> known_; // for this right-hand side
};

} // namespace nrb::inline numeric
