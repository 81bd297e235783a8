// SPDX-License-Identifier: MIT
#include "numeric/solvers/principal_axes.h"

#include "base/finite.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

namespace nrb::inline numeric {

namespace {

using Matrix = Eigen::MatrixXd;
using Vector = Eigen::VectorXd;

// The finite points, scaled so that no coordinate exceeds 1.
std::vector<Vector> scaled_points(const std::vector<double> &points, int dim) {
    const double largest = largest_magnitude(points);
    const int exponent = largest > 0 && std::isfinite(largest) ? std::ilogb(largest) : 0;
    std::vector<Vector> result;
    for (size_t i = 0; i < points.size(); i += static_cast<size_t>(dim)) {
        const Vector x = Eigen::Map<const Vector>(points.data() + i, dim);
        if (x.allFinite()) {
            result.push_back(x.unaryExpr([exponent](double c) { return std::ldexp(c, -exponent - 1); }));
        }
    }
    return result;
}

Matrix covariance(const std::vector<Vector> &points, int dim) {
    Vector mean = Vector::Zero(dim);
    for (const Vector &x : points) {
        mean += x / static_cast<double>(points.size());
    }
    double spread = 0;
    for (const Vector &x : points) {
        spread = std::max(spread, (x - mean).cwiseAbs().maxCoeff());
    }
    const int exponent = spread > 0 ? std::ilogb(spread) : 0; // so that small squares do not underflow
    Matrix sum = Matrix::Zero(dim, dim);
    for (const Vector &x : points) {
        const Vector d = (x - mean).unaryExpr([exponent](double c) { return std::ldexp(c, -exponent); });
        sum += d * d.transpose();
    }
    return sum;
}

} // namespace

std::vector<double> principal_axes(const std::vector<double> &points, int dim) {
    const Eigen::SelfAdjointEigenSolver<Matrix> solver(covariance(scaled_points(points, dim), dim));
    Matrix rows = solver.eigenvectors().rowwise().reverse().transpose();
    if (dim == 3 && rows.determinant() < 0) {
        rows.row(2) *= -1;
    }
    std::vector<double> axes;
    for (Eigen::Index r = 0; r < rows.rows(); ++r) {
        for (Eigen::Index c = 0; c < rows.cols(); ++c) {
            axes.push_back(rows(r, c));
        }
    }
    return axes;
}

} // namespace nrb::inline numeric
