// SPDX-License-Identifier: MIT
#include "numeric/solvers/small_svd.h"

#include "base/numbers.h"

#include <Eigen/QR>
#include <Eigen/SVD>

namespace nrb::inline numeric {

namespace {

using Rows = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

std::vector<double> coordinates(const Eigen::VectorXd &x) {
    return {x.data(), x.data() + x.size()};
}

} // namespace

// A Householder QR factorisation precedes it, so that Jacobi's rotations work on few rows.
using Rotations = Eigen::JacobiSVD<Eigen::MatrixXd, Eigen::NoQRPreconditioner>;

struct SmallSvd::Decomposition {
    Rotations svd;
    Eigen::VectorXd right; // multiplied by Q^T
};

// Only finite numbers are decomposed: for others Eigen leaves sizes uninitialised that its solutions then
// read.
SmallSvd::SmallSvd(const std::vector<double> &rows, int n, const std::vector<double> &right)
    : unknowns_(static_cast<size_t>(n)) {
    const Eigen::Index given = static_cast<Eigen::Index>(rows.size()) / n,
                       m = std::max<Eigen::Index>(given, n);
    Rows matrix = Rows::Zero(m, n);
    matrix.topRows(given) = Eigen::Map<const Rows>(rows.data(), given, n);
    Eigen::VectorXd values = Eigen::VectorXd::Zero(m);
    values.head(static_cast<Eigen::Index>(right.size())) =
        Eigen::Map<const Eigen::VectorXd>(right.data(), static_cast<Eigen::Index>(right.size()));
    const Eigen::HouseholderQR<Eigen::MatrixXd> triangle(matrix);
    const Eigen::MatrixXd upper = triangle.matrixQR().topRows(n).triangularView<Eigen::Upper>();
    const Eigen::VectorXd turned = triangle.householderQ().adjoint() * values;
    if (upper.allFinite() && turned.allFinite()) { // squares may have overflowed
        const Rotations svd(upper, Eigen::ComputeFullU | Eigen::ComputeFullV);
        decomposition_ = std::make_unique<Decomposition>(Decomposition{svd, turned.head(n)});
    }
}

SmallSvd::~SmallSvd() = default;

std::vector<double> SmallSvd::direction(int rank) const {
    if (decomposition_ == nullptr) {
        return std::vector<double>(unknowns_, nan_value);
    }
    const Eigen::MatrixXd &v = decomposition_->svd.matrixV();
    return coordinates(v.col(v.cols() - 1 - rank));
}

std::vector<double> SmallSvd::solution(double cutoff) const {
    if (decomposition_ == nullptr) {
        return std::vector<double>(unknowns_, nan_value);
    }
    Rotations &svd = decomposition_->svd;
    svd.setThreshold(cutoff);
    return coordinates(svd.solve(decomposition_->right));
}

} // namespace nrb::inline numeric
