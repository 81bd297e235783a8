// SPDX-License-Identifier: MIT
// Sparse symmetric positive systems, by Eigen's factorisation.
#pragma once

#include <cstdint>
#include <memory>
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

// K + rho D for many rho: the order of elimination is found once.
class SparseSystem {
public:
    // Entries between unknowns 0 to n - 1, and a diagonal.
    SparseSystem(const std::vector<Entry> &entries, const std::vector<double> &diagonal);
    SparseSystem(const SparseSystem &) = delete;
    SparseSystem &operator=(const SparseSystem &) = delete;
    ~SparseSystem();

    // x[n][width] of (K + rho D) x = right; false where a pivot is not positive.
    [[nodiscard]] bool solve(double rho, const std::vector<double> &right, int64_t width,
                             std::vector<double> &x);

private:
    struct Factors; // keeps Eigen's templates out of this header
    std::unique_ptr<Factors> factors_;
};

} // namespace nrb::inline numeric
