// SPDX-License-Identifier: MIT
// Cholesky's factorisation of matrices of a few rows, on the stack.
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

    // Of the first n rows and columns, whose lower half is read. False unless every pivot is more than
    // `least` times the diagonal element that it is left of: then the matrix may not be positive definite.
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

    // L^-1 x for a = L L^T.
    void solve_lower(Vector &x) const noexcept {
        for (size_t i = 0; i < n_; ++i) {
            for (size_t j = 0; j < i; ++j) {
                x[i] -= l_[i][j] * x[j];
            }
            x[i] /= l_[i][i];
        }
    }

    // a^-1 x.
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

    Matrix l_; // the lower half
    size_t n_ = 0;
};

} // namespace nrb::inline numeric
