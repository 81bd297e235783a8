// Least squares and null directions of many equations in few unknowns.
#pragma once

#include <cstddef>
#include <vector>

namespace nrb {

// The singular value decomposition of a matrix of few columns: Householder's triangle, then one-sided Jacobi
// rotations of its columns (J. Demmel, K. Veselic, "Jacobi's method is more accurate than QR", SIAM J. Matrix
// Anal. Appl. 13 (1992)), so that columns of very different length do no harm. Cost: O(m n^2).
class SmallSvd {
public:
    // `rows` is [m][n], `right` [m] or empty.
    SmallSvd(std::vector<double> rows, int n, std::vector<double> right = {});

    // The right singular vector of the singular value that has `rank` smaller ones: 0 for the unit vector that
    // the matrix makes smallest.
    [[nodiscard]] std::vector<double> direction(int rank) const;
    // The shortest vector that solves the equations best; singular values below `cutoff` times the largest
    // count as 0.
    [[nodiscard]] std::vector<double> solution(double cutoff) const;

private:
    void triangulate(std::vector<double> &rows, std::vector<double> &right, size_t m);
    bool rotate(size_t i, size_t j) noexcept;
    [[nodiscard]] double length(size_t column) const noexcept;

    size_t n_;
    std::vector<double> columns_; // of the triangle times the rotations, [n][n]
    std::vector<double> vectors_; // right singular vectors, [n][n]
    std::vector<double> right_;   // the right side in the basis of the triangle
};

} // namespace nrb
