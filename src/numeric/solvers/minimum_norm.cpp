// SPDX-License-Identifier: MIT
#include "numeric/solvers/minimum_norm.h"

#include "base/representable.h"
#include "numeric/norm.h"

#include <Eigen/QR>

namespace nrb::inline numeric {

namespace {

using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

Eigen::Map<const RowMajor> matrix_of(const std::vector<double> &values, int64_t columns) {
    return {values.data(), static_cast<Eigen::Index>(values.size()) / columns, columns};
}

std::vector<double> values_of(const RowMajor &matrix) {
    return {matrix.data(), matrix.data() + matrix.size()};
}

Eigen::MatrixXd transposed(const std::vector<double> &rows, int64_t n) {
    require_representable(rows, "equations"); // which Eigen does not promise to survive
    return matrix_of(rows, n).transpose();
}

} // namespace

struct MinimumNorm::Factors {
    Eigen::ColPivHouseholderQR<Eigen::MatrixXd> qr;

    Factors(const Eigen::MatrixXd &columns, double threshold) : qr(columns.rows(), columns.cols()) {
        qr.setThreshold(threshold);
        qr.compute(columns);
    }
    [[nodiscard]] auto triangle() const { return qr.matrixQR().topLeftCorner(qr.rank(), qr.rank()); }
};

MinimumNorm::MinimumNorm(const std::vector<double> &rows, int64_t n, double threshold)
    : unknowns_(n), factors_(std::make_unique<Factors>(transposed(rows, n), threshold)) {}

MinimumNorm::~MinimumNorm() = default;

int64_t MinimumNorm::rank() const noexcept {
    return factors_->qr.rank();
}

std::vector<double> MinimumNorm::solve(const std::vector<double> &right, int64_t width) const {
    const Eigen::Index rank = factors_->qr.rank();
    const RowMajor pivoted = factors_->qr.colsPermutation().transpose() * matrix_of(right, width);
    Eigen::MatrixXd x = Eigen::MatrixXd::Zero(unknowns_, width);
    x.topRows(rank) =
        factors_->triangle().transpose().triangularView<Eigen::Lower>().solve(pivoted.topRows(rank));
    x.applyOnTheLeft(factors_->qr.householderQ());
    return values_of(x);
}

MinimumNorm::Multipliers MinimumNorm::multipliers(const std::vector<double> &x) const {
    const Eigen::Index rank = factors_->qr.rank();
    Eigen::VectorXd turned = Eigen::Map<const Eigen::VectorXd>(x.data(), unknowns_);
    turned.applyOnTheLeft(factors_->qr.householderQ().adjoint());
    Eigen::VectorXd values = Eigen::VectorXd::Zero(factors_->qr.cols());
    values.head(rank) = factors_->triangle().triangularView<Eigen::Upper>().solve(turned.head(rank));
    values = factors_->qr.colsPermutation() * values;
    return {{values.data(), values.data() + values.size()},
            norm(turned.data() + rank, static_cast<int>(unknowns_ - rank))};
}

std::vector<double> MinimumNorm::kernel_part(const std::vector<double> &x) const {
    Eigen::MatrixXd turned = Eigen::Map<const Eigen::VectorXd>(x.data(), unknowns_);
    turned.applyOnTheLeft(factors_->qr.householderQ().adjoint());
    turned.topRows(factors_->qr.rank()).setZero();
    turned.applyOnTheLeft(factors_->qr.householderQ());
    return values_of(turned);
}

struct RowSpace::Factors {
    Eigen::HouseholderQR<Eigen::MatrixXd> qr;
};

RowSpace::RowSpace(const std::vector<double> &rows, int64_t n)
    : unknowns_(n), factors_(std::make_unique<Factors>(
                        Factors{Eigen::HouseholderQR<Eigen::MatrixXd>(transposed(rows, n))})) {}

RowSpace::~RowSpace() = default;

int64_t RowSpace::size() const noexcept {
    return std::min(factors_->qr.rows(), factors_->qr.cols());
}

double RowSpace::coordinate(int64_t row, int64_t j) const noexcept {
    return j <= row ? factors_->qr.matrixQR()(j, row) : 0;
}

std::vector<double> RowSpace::expand(const std::vector<double> &y, int64_t width) const {
    Eigen::MatrixXd x = Eigen::MatrixXd::Zero(unknowns_, width);
    x.topRows(size()) = matrix_of(y, width);
    x.applyOnTheLeft(factors_->qr.householderQ());
    return values_of(x);
}

} // namespace nrb::inline numeric
