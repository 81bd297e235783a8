// SPDX-License-Identifier: MIT
// Cholesky factorisation of matrices of a few rows, on the stack.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>

namespace nrb::inline numeric {

template <size_t N>
class SmallCholesky {
public:
    using Vector = std::array<double, N>;
    using Matrix = std::array<Vector, N>;

    // Factorises the leading n x n block, of which only the lower triangle is read. False unless every pivot
    // exceeds `least` times the diagonal element it is reduced from: otherwise the matrix may not be positive
    // definite.
    [[nodiscard]] bool factorise(const Matrix &a, int n, double least) noexcept {
        n_ = static_cast<size_t>(n);
        for (size_t i = 0; i < n_; ++i) {
            for (size_t j = 0; j < i; ++j) {
                l_[i][j] = reduced(a, i, j) / l_[j][j];
            }
            const double pivot = reduced(a, i, i);
            if (!(pivot > least * a[i][i]) || !(pivot > 0)) {
                return false;
            }
            l_[i][i] = std::sqrt(pivot);
        }
        return true;
    }

    // x becomes L^-1 x, where a = L L^T.
    void solve_lower(Vector &x) const noexcept {
        for (size_t i = 0; i < n_; ++i) {
            for (size_t j = 0; j < i; ++j) {
                x[i] -= l_[i][j] * x[j];
            }
            x[i] /= l_[i][i];
        }
    }

    // x becomes a^-1 x.
    void solve(Vector &x) const noexcept {
        solve_lower(x);
        for (size_t i = n_; i-- > 0;) {
            for (size_t j = i + 1; j < n_; ++j) {
                x[i] -= l_[j][i] * x[j];
            }
            x[i] /= l_[i][i];
        }
    }

private:
    [[nodiscard]] double reduced(const Matrix &a, size_t i, size_t j) const noexcept {
        double sum = a[i][j];
        for (size_t m = 0; m < j; ++m) {
            sum -= l_[i][m] * l_[j][m];
        }
        return sum;
    }

    Matrix l_; // the lower triangle
    size_t n_ = 0;
};

} // namespace nrb::inline numeric
