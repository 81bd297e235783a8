// SPDX-License-Identifier: MIT
#include "numeric/solvers/small_systems.h"

#include <Eigen/Dense>
#include <algorithm>

namespace nrb::inline numeric {

namespace {

using SmallMatrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, max_axes, max_axes>;
using SmallVector = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, max_axes, 1>;

SmallMatrix small_matrix(int n, const AxisMatrix &a) {
    SmallMatrix result(n, n);
    for (int i = 0; i < n; ++i) {
        for (int j = 0; j < n; ++j) {
            result(i, j) = a[static_cast<size_t>(i)][static_cast<size_t>(j)];
        }
    }
    return result;
}

AxisMatrix axis_matrix(const SmallMatrix &a) {
    AxisMatrix result{};
    for (int i = 0; i < a.rows(); ++i) {
        for (int j = 0; j < a.cols(); ++j) {
            result[static_cast<size_t>(i)][static_cast<size_t>(j)] = a(i, j);
        }
    }
    return result;
}

AxisVector axis_values(const SmallVector &x) {
    AxisVector result{};
    std::copy(x.data(), x.data() + x.size(), result.begin());
    return result;
}

} // namespace

AxisVector symmetric_eigenvalues(int n, const AxisMatrix &a) {
    const Eigen::SelfAdjointEigenSolver<SmallMatrix> solver(small_matrix(n, a), Eigen::EigenvaluesOnly);
    return axis_values(solver.eigenvalues());
}

AxisMatrix inverse_of_positive_part(int n, const AxisMatrix &a) {
    if (n <= 1) { // the case of every curve
        AxisMatrix result{};
        result[0][0] = n == 1 ? 1 / (1 + std::max(a[0][0], 0.0)) : 0;
        return result;
    }
    const Eigen::SelfAdjointEigenSolver<SmallMatrix> solver(small_matrix(n, a));
    const SmallVector factors = (1 + solver.eigenvalues().array().max(0.0)).inverse().matrix();
    return axis_matrix(solver.eigenvectors() * factors.asDiagonal() * solver.eigenvectors().transpose());
}

std::optional<AxisMatrix> inverse(int n, const AxisMatrix &a) {
    const Eigen::FullPivLU<SmallMatrix> factors(small_matrix(n, a));
    if (!factors.isInvertible()) {
        return std::nullopt;
    }
    return axis_matrix(factors.inverse());
}

AxisVector shortest_solution(int n, const AxisMatrix &a, const AxisVector &right) {
    const SmallVector values = Eigen::Map<const Eigen::VectorXd>(right.data(), n);
    return axis_values(small_matrix(n, a).completeOrthogonalDecomposition().solve(values));
}

} // namespace nrb::inline numeric
