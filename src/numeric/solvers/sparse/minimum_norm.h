// SPDX-License-Identifier: MIT
// Smallest solutions of few linear equations.
#pragma once

#include "numeric/solvers/sparse/sparse_rows.h"

#include <cstdint>
#include <vector>

namespace nrb::inline numeric {

// A x = b for a wide matrix: A Q = L with a product Q of rotations of two unknowns each, and x = Q (y, 0) with L y = b is
// the shortest vector that fulfils the equations. Nothing is squared, so that equations hold to a few eps of |A| |x|.
//
// An equation is reduced by the rotations of those before it, in the order of their last unknowns, and its rest is then
// turned into its last unknown, from the first one on (W. Givens 1958; A. George, M. Heath, "Solution of sparse linear
// least squares problems using Givens rotations", Linear Algebra Appl. 34 (1980)). Where unknowns are control points of
// a curve, an equation so meets only rotations of its neighbours: the cost is linear. An equation whose rest is shorter
// than a threshold follows from those before it.
class MinimumNorm {
public:
    // Rows of length 1 for n unknowns; rests of up to the threshold count as 0. Throws Status::not_representable if an
    // element is not finite.
    MinimumNorm(const SparseRows &rows, int64_t n, double threshold);

    [[nodiscard]] int64_t rank() const noexcept { return std::ssize(pivots_); }
    // x[n][width] for right[rows][width]; of dependent equations the right sides do not count.
    [[nodiscard]] std::vector<double> solve(const std::vector<double> &right, int64_t width) const;
    // lambda[rows], 0 for dependent ones, for which A^T lambda is closest to x; and the length of what is left of x.
    struct Multipliers {
        std::vector<double> values;
        double rest;
    };
    [[nodiscard]] Multipliers multipliers(const std::vector<double> &x) const;
    // What is left of x, perpendicular to the independent rows.
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
    // By independent equations, in the order of the reduction: their rows, the unknowns they end in, and L.
    std::vector<int64_t> row_of_;
    std::vector<int64_t> pivots_;
    std::vector<double> diagonal_;
    std::vector<size_t> starts_{0};
    std::vector<int64_t> before_; // numbers of equations
    std::vector<double> lower_;
};

} // namespace nrb::inline numeric
