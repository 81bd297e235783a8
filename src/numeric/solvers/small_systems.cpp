// SPDX-License-Identifier: MIT
#include "numeric/solvers/small_systems.h"

#include <Eigen/Dense>
#include <algorithm>

namespace nrb::inline numeric {

namespace {

using Matrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, max_axes, max_axes>;
using Vector = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, max_axes, 1>;

Matrix matrix_of(int n, const AxisMatrix &a) {
    Matrix result(n, n);
    for (int i = 0; i < n; ++i) {
        for (int j = 0; j < n; ++j) {
            result(i, j) = a[static_cast<size_t>(i)][static_cast<size_t>(j)];
        }
    }
    return result;
}

AxisVector values_of(const Vector &x) {
    AxisVector result{};
    std::copy(x.data(), x.data() + x.size(), result.begin());
    return result;
}

} // namespace

AxisVector symmetric_eigenvalues(int n, const AxisMatrix &a) {
    const Eigen::SelfAdjointEigenSolver<Matrix> solver(matrix_of(n, a), Eigen::EigenvaluesOnly);
    return values_of(solver.eigenvalues());
}

std::optional<AxisMatrix> inverse(int n, const AxisMatrix &a) {
    const Eigen::FullPivLU<Matrix> factors(matrix_of(n, a));
    if (!factors.isInvertible()) {
        return std::nullopt;
    }
    const Matrix inverse = factors.inverse();
    AxisMatrix result{};
    for (int i = 0; i < n; ++i) {
        for (int j = 0; j < n; ++j) {
            result[static_cast<size_t>(i)][static_cast<size_t>(j)] = inverse(i, j);
        }
    }
    return result;
}

AxisVector shortest_solution(int n, const AxisMatrix &a, const AxisVector &right) {
    const Vector values = Eigen::Map<const Eigen::VectorXd>(right.data(), n);
    return values_of(matrix_of(n, a).completeOrthogonalDecomposition().solve(values));
}

} // namespace nrb::inline numeric
