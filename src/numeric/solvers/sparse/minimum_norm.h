// SPDX-License-Identifier: MIT
// Minimum-norm solutions of underdetermined sparse linear equations.
#pragma once

#include "numeric/solvers/sparse/sparse_rows.h"

#include <cstdint>
#include <vector>

namespace nrb::inline numeric {

// Solves A x = b for a wide matrix A by an orthogonal factorisation: A Q = (L, 0), up to the order of the
// unknowns, with L lower triangular and Q a product of Givens rotations. x = Q (y, 0) with L y = b is the
// shortest vector that satisfies the equations. No normal equations are formed, so the equations hold to a
// few eps of |A| |x|.
//
// The equations are taken in the order of their last unknowns. Each is multiplied by the rotations of those
// before it, and its remaining entries are then rotated into its last unknown, from the first one on (W.
// Givens 1958; A. George, M. Heath, "Solution of sparse linear least squares problems using Givens
// rotations", Linear Algebra Appl. 34 (1980)). Where the unknowns are control points of a curve, an equation
// thus meets only rotations of its neighbours: the cost is linear. An equation whose remainder is shorter
// than a threshold depends linearly on those before it.
class MinimumNorm {
public:
    // Rows of length 1 for n unknowns; a remainder no longer than the threshold counts as 0. Throws
    // Status::not_representable if an element is not finite.
    MinimumNorm(const SparseRows &rows, int64_t n, double threshold);

    [[nodiscard]] int64_t rank() const noexcept { return std::ssize(pivots_); }
    // x[n][width] for right[rows][width]; the right-hand sides of dependent equations are ignored.
    [[nodiscard]] std::vector<double> solve(const std::vector<double> &right, int64_t width) const;
    // lambda[rows], 0 for dependent equations, such that A^T lambda is closest to x; `rest` is the length of
    // x - A^T lambda.
    struct Multipliers {
        std::vector<double> values;
        double rest;
    };
    [[nodiscard]] Multipliers multipliers(const std::vector<double> &x) const;
    // The component of x orthogonal to the independent rows.
    [[nodiscard]] std::vector<double> kernel_part(const std::vector<double> &x) const;

private:
    class Reduction;
    struct Rotation {
        int64_t a;
        int64_t b;
        double cosine;
        double sine;
    };
    void turn(std::vector<double> &x, int64_t width) const;      // x = Q x
    void turn_back(std::vector<double> &x, int64_t width) const; // x = Q^T x

    int64_t unknowns_;
    int64_t rows_;
    std::vector<Rotation> rotations_;
    // For each independent equation, in the order of reduction: its row, the unknown it ends in, and its row
    // of L.
    std::vector<int64_t> row_of_;
    std::vector<int64_t> pivots_;
    std::vector<double> diagonal_;
    std::vector<size_t> starts_{0};
    std::vector<int64_t> before_; // column indices of L: indices of earlier equations
    std::vector<double> lower_;
};

} // namespace nrb::inline numeric
