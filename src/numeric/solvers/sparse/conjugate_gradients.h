// SPDX-License-Identifier: MIT
// Conjugate gradients that start from known solutions of nearby systems.
#pragma once

#include "numeric/solvers/sparse/sparse_ldlt.h"

#include <deque>
#include <span>
#include <vector>

namespace nrb::inline numeric {

// A solution x of (K + rho D) x = b.
struct ShiftedSolution {
    double rho;
    std::vector<double> x;
};

// Solves (K + rho D) x = b for several right-hand sides at once, each with its own step lengths (M. Hestenes,
// E. Stiefel 1952).
class ConjugateGradients {
public:
    // matrix: K + rho D with increasing row indices. diagonal: D. factors: those of K + s D for an s near
    // rho, as preconditioner, or null to precondition with the diagonal of the matrix. `diagonal` and
    // `factors` must outlive this object.
    ConjugateGradients(SparseColumns matrix, double rho, std::span<const double> diagonal,
                       const SparseLdlt *factors, int64_t width);

    // Replaces the right-hand sides by the solution; false if it is not found in `most` steps. known:
    // solutions for the same right-hand sides.
    bool solve(std::vector<double> &right, int most, const std::deque<ShiftedSolution> &known);

private:
    // A search direction p, its image A p, and the energy p.A p for each right-hand side.
    struct Direction {
        std::vector<double> step, image, energy;
    };
    [[nodiscard]] std::vector<double> closest_of(const std::deque<ShiftedSolution> &known,
                                                 const std::vector<double> &right) const;
    [[nodiscard]] Direction direction_to(const ShiftedSolution &solution,
                                         const std::vector<double> &right) const;
    // Dot products, one for each right-hand side.
    [[nodiscard]] std::vector<double> dots(const std::vector<double> &a, const std::vector<double> &b) const;
    [[nodiscard]] bool is_small(const std::vector<double> &residual, const std::vector<double> &size) const;
    // to += part * of, with one factor for each right-hand side.
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
