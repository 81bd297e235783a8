// SPDX-License-Identifier: MIT
// Sparse symmetric positive systems.
#pragma once

#include "numeric/solvers/sparse/conjugate_gradients.h"

#include <cstdint>
#include <deque>
#include <optional>
#include <vector>

namespace nrb::inline numeric {

// Entry (i, j) of a symmetric matrix, each with its mirror image.
struct Entry {
    int64_t row;
    int64_t column;
    double value;
};

// K x for x[unknowns][width].
std::vector<double> times(const std::vector<Entry> &entries, const std::vector<double> &x, int64_t width);

// K + rho D for many rho. Where factors cost more than many products with K, systems are solved by conjugate gradients from the best
// combination of the last solutions, preconditioned by the diagonal; if these do not converge in some steps, as with a small rho, by the
// factors for this rho, which then precondition the systems for others nearby.
class SparseSystem {
public:
    // Entries between unknowns 0 to n - 1, a diagonal, and the order in which the unknowns are eliminated. Precondition:
    // n < 2^31.
    SparseSystem(const std::vector<Entry> &entries, std::vector<double> diagonal, std::vector<int64_t> order);

    // x[n][width] of (K + rho D) x = right; false where a pivot is not positive.
    [[nodiscard]] bool solve(double rho, const std::vector<double> &right, int64_t width,
                             std::vector<double> &x);

private:
    static constexpr int few_steps = 5; // that cost less than new factors

    [[nodiscard]] SparseColumns shifted(double rho) const;
    [[nodiscard]] bool factors_suit(double rho) const noexcept;
    bool iterate(double rho, std::vector<double> &x, int64_t width);
    bool factorise(double rho);
    void remember(double rho, std::vector<double> x);

    std::vector<double> diagonal_; // in the order of elimination, as what follows
    std::vector<int64_t> order_;
    SparseColumns entries_;
    std::optional<SparseLdlt> factors_;
    bool factorised_ = false; // for factors_rho_
    double factors_rho_ = 0;
    std::vector<double> right_;
    std::deque<ShiftedSolution> known_; // for this right side
};

} // namespace nrb::inline numeric
