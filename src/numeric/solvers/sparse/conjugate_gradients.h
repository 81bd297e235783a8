// SPDX-License-Identifier: MIT
// Conjugate gradients that begin from what is known of systems nearby.
#pragma once

#include "numeric/solvers/sparse/sparse_ldlt.h"

#include <deque>
#include <span>
#include <vector>

namespace nrb::inline numeric {

// x of (K + rho D) x = b.
struct ShiftedSolution {
    double rho;
    std::vector<double> x;
};

// Solves (K + rho D) x = b for several right sides at once, each with steps of its own (M. Hestenes, E. Stiefel 1952).
class ConjugateGradients {
public:
    // matrix: K + rho D with ascending rows; factors: of K + s D for an s near rho, to precondition with, or null for the diagonal of
    // the matrix. diagonal: D. The last two must outlive this.
    ConjugateGradients(SparseColumns matrix, double rho, std::span<const double> diagonal,
                       const SparseLdlt *factors, int64_t width);

    // Replaces the right side by the solution; false if it is not found in `most` steps. known: solutions for the same right side.
    bool solve(std::vector<double> &right, int most, const std::deque<ShiftedSolution> &known);

private:
    // A direction and its product with the matrix, and the products of both.
    struct Direction {
        std::vector<double> step, image, energy;
    };
    [[nodiscard]] std::vector<double> closest_of(const std::deque<ShiftedSolution> &known,
                                                 const std::vector<double> &right) const;
    [[nodiscard]] Direction direction_to(const ShiftedSolution &solution,
                                         const std::vector<double> &right) const;
    // By right sides.
    [[nodiscard]] std::vector<double> dots(const std::vector<double> &a, const std::vector<double> &b) const;
    [[nodiscard]] bool is_small(const std::vector<double> &residual, const std::vector<double> &size) const;
    // to += part * of.
    void add(std::vector<double> &to, const std::vector<double> &part,
             const std::vector<double> &of) const noexcept;
    void precondition(std::vector<double> &x) const;
    void multiply(const std::vector<double> &x, std::vector<double> &image) const;

    SparseColumns matrix_;
    double rho_;
    std::span<const double> diagonal_;
    const SparseLdlt *factors_;
    int64_t width_;
    std::vector<double> inverse_diagonal_; // of the matrix
};

} // namespace nrb::inline numeric
