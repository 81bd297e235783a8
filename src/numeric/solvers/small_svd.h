// SPDX-License-Identifier: MIT
// Least squares and null directions of many equations in few unknowns, by Eigen's singular value
// decomposition.
#pragma once

#include <memory>
#include <vector>

namespace nrb::inline numeric {

class SmallSvd {
public:
    // `rows` is [m][n], `right` is [m] or empty. If a value is not finite, or its square overflows, all
    // results are NaN.
    SmallSvd(const std::vector<double> &rows, int n, const std::vector<double> &right = {});
    SmallSvd(const SmallSvd &) = delete;
    SmallSvd &operator=(const SmallSvd &) = delete;
    ~SmallSvd();

    // The right singular vector of the singular value that has `rank` smaller ones; rank 0 gives the unit
    // vector that the matrix shortens most.
    [[nodiscard]] std::vector<double> direction(int rank) const;
    // The shortest least-squares solution; singular values below `cutoff` times the largest count as 0.
    [[nodiscard]] std::vector<double> solution(double cutoff) const;

private:
    struct Decomposition; // keeps Eigen's templates out of this header
    size_t unknowns_;
    std::unique_ptr<Decomposition> decomposition_; // null: the equations are not finite
};

} // namespace nrb::inline numeric
