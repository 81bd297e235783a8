// SPDX-License-Identifier: MIT
// Smallest solutions of linear equations, by Eigen's orthogonal factorisations.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

namespace nrb::inline numeric {

// A x = b for a wide matrix of few rows: with the pivoted triangular factorisation A^T P = Q R (Businger &
// Golub 1965) of the transpose the rows that pivots above a threshold belong to are independent, and x = Q
// R^-T P^T b is the shortest vector that fulfils their equations. Nothing is squared, so that equations hold
// to a few eps of |A| |x|. Cost: n m^2.
class MinimumNorm {
public:
    // `rows` is [m][n]; pivots up to the threshold times the largest count as 0. Throws
    // Status::not_representable if an entry is not finite.
    MinimumNorm(const std::vector<double> &rows, int64_t n, double threshold);
    MinimumNorm(const MinimumNorm &) = delete;
    MinimumNorm &operator=(const MinimumNorm &) = delete;
    ~MinimumNorm();

    [[nodiscard]] int64_t rank() const noexcept;
    // x[n][width] for right[m][width].
    [[nodiscard]] std::vector<double> solve(const std::vector<double> &right, int64_t width) const;
    // lambda[m], 0 for dependent rows, for which A^T lambda is closest to x; and what is left of x.
    struct Multipliers {
        std::vector<double> values;
        double rest;
    };
    [[nodiscard]] Multipliers multipliers(const std::vector<double> &x) const;
    // What is left of x, perpendicular to the independent rows.
    [[nodiscard]] std::vector<double> kernel_part(const std::vector<double> &x) const;

private:
    struct Factors; // keeps Eigen's templates out of this header
    int64_t unknowns_;
    std::unique_ptr<Factors> factors_;
};

// The space that rows span: orthonormal vectors of which each row is a combination, so that equations between
// few rows can be solved among their coordinates.
class RowSpace {
public:
    RowSpace(const std::vector<double> &rows, int64_t n); // throws Status::not_representable
    RowSpace(const RowSpace &) = delete;
    RowSpace &operator=(const RowSpace &) = delete;
    ~RowSpace();

    [[nodiscard]] int64_t size() const noexcept;
    // Coordinate j of a row.
    [[nodiscard]] double coordinate(int64_t row, int64_t j) const noexcept;
    // The vectors x[n][width] of these coordinates y[size][width].
    [[nodiscard]] std::vector<double> expand(const std::vector<double> &y, int64_t width) const;

private:
    struct Factors;
    int64_t unknowns_;
    std::unique_ptr<Factors> factors_;
};

} // namespace nrb::inline numeric
