// SPDX-License-Identifier: MIT
// Least squares and null directions of many equations in few unknowns, by Eigen's singular value
// decomposition.
#pragma once

#include <memory>
#include <vector>

namespace nrb::inline numeric {

class SmallSvd {
public:
    // `rows` is [m][n], `right` [m] or empty. Where a value is not finite, or its square overflows, all
    // results are NaN.
    SmallSvd(const std::vector<double> &rows, int n, const std::vector<double> &right = {});
    SmallSvd(const SmallSvd &) = delete;
    SmallSvd &operator=(const SmallSvd &) = delete;
    ~SmallSvd();

    // The right singular vector of the singular value that has `rank` smaller ones: 0 for the unit vector
    // that the matrix makes smallest.
    [[nodiscard]] std::vector<double> direction(int rank) const;
    // The shortest vector that solves the equations best; singular values below `cutoff` times the largest
    // count as 0.
    [[nodiscard]] std::vector<double> solution(double cutoff) const;

private:
    struct Decomposition; // keeps Eigen's templates out of this header
    size_t unknowns_;
    std::unique_ptr<Decomposition> decomposition_; // null: equations that are not finite
};

} // namespace nrb::inline numeric
