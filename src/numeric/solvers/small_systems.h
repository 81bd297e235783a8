// Symmetric systems of as few unknowns as a shape, or two of them, have parameters; without memory of their own.
#pragma once

#include "base/limits.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>

namespace nrb::inline numeric {

template <size_t kSize>
using SmallVector = std::array<double, kSize>;
template <size_t kSize>
using SmallMatrix = std::array<std::array<double, kSize>, kSize>;

// x becomes the solution of A x = x for the first n unknowns, by Cholesky's factorisation of the lower half; false
// unless A is positive definite beyond rounding: a pivot that has lost all but 3 bits of its diagonal entry is noise.
template <size_t kSize>
bool solve_positive(int n, SmallMatrix<kSize> a, SmallVector<kSize> &x) noexcept {
    constexpr double least_pivot = 8 * std::numeric_limits<double>::epsilon();
    const auto size = static_cast<size_t>(n);
    for (size_t i = 0; i < size; ++i) {
        double pivot = a[i][i];
        for (size_t j = 0; j < i; ++j) {
            for (size_t m = 0; m < j; ++m) {
                a[i][j] -= a[i][m] * a[j][m];
            }
            a[i][j] /= a[j][j];
            x[i] -= a[i][j] * x[j];
            pivot -= a[i][j] * a[i][j];
        }
        if (!(pivot > least_pivot * a[i][i]) || !(pivot > 0)) {
            return false;
        }
        a[i][i] = std::sqrt(pivot);
        x[i] /= a[i][i];
    }
    for (size_t i = size; i-- > 0;) {
        for (size_t m = i + 1; m < size; ++m) {
            x[i] -= a[m][i] * x[m];
        }
        x[i] /= a[i][i];
    }
    return true;
}

// A damped Newton step: (H + D) step = -gradient among the free unknowns of the first n, D diagonal, 0 for the others.
// False unless H + D is positive definite there, so that the step descends.
template <size_t kSize>
bool newton_step(int n, const SmallMatrix<kSize> &hessian, const SmallVector<kSize> &damping,
                 const SmallVector<kSize> &gradient, const std::array<bool, kSize> &free,
                 SmallVector<kSize> &step) noexcept {
    std::array<size_t, kSize> places{};
    size_t size = 0;
    for (size_t k = 0; k < static_cast<size_t>(n); ++k) {
        if (free[k]) {
            places[size++] = k;
        }
    }
    SmallMatrix<kSize> a{};
    SmallVector<kSize> x{};
    for (size_t i = 0; i < size; ++i) {
        for (size_t j = 0; j <= i; ++j) {
            a[i][j] = hessian[places[i]][places[j]];
        }
        a[i][i] += damping[places[i]];
        x[i] = -gradient[places[i]];
    }
    step = {};
    if (!solve_positive(static_cast<int>(size), a, x)) {
        return false;
    }
    for (size_t i = 0; i < size; ++i) {
        step[places[i]] = x[i];
    }
    return true;
}

// Of the first n <= max_axes rows and columns; what is behind them is 0.
using AxisMatrix = SmallMatrix<max_axes>;
using AxisVector = SmallVector<max_axes>;

// The eigenvalues of a symmetric matrix, rising.
AxisVector symmetric_eigenvalues(int n, const AxisMatrix &a);
// None where a pivot of Gauss' elimination with full pivoting counts as 0 to rounding.
std::optional<AxisMatrix> inverse(int n, const AxisMatrix &a);
// The shortest vector of those for which A x is closest to right, directions that A shrinks to rounding left out.
AxisVector shortest_solution(int n, const AxisMatrix &a, const AxisVector &right);

} // namespace nrb::inline numeric
