// SPDX-License-Identifier: MIT
#include "numeric/solvers/minimum_norm.h"

#include "base/representable.h"
#include "base/watch.h"
#include "numeric/norm.h"
#include "numeric/solvers/householder.h"

#include <utility>

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
    const auto given = matrix_of(rows, n);
    Eigen::MatrixXd columns(n, given.rows());
    for (Eigen::Index k = 0; k < given.rows(); ++k) {
        count_work(n);
        columns.col(k) = given.row(k).transpose();
    }
    return columns;
}

} // namespace

struct MinimumNorm::Factors {
    Householder qr;
    Eigen::Index rank;

    Factors(Eigen::MatrixXd columns, double threshold)
        : qr(std::move(columns), Householder::Pivoting::columns), rank(qr.rank(threshold)) {}
    [[nodiscard]] auto triangle() const { return qr.factors().topLeftCorner(rank, rank); }
};

MinimumNorm::MinimumNorm(const std::vector<double> &rows, int64_t n, double threshold)
    : unknowns_(n), factors_(std::make_unique<Factors>(transposed(rows, n), threshold)) {}

MinimumNorm::~MinimumNorm() = default;

int64_t MinimumNorm::rank() const noexcept {
    return factors_->rank;
}

std::vector<double> MinimumNorm::solve(const std::vector<double> &right, int64_t width) const {
    const Eigen::Index rank = factors_->rank;
    const auto given = matrix_of(right, width);
    RowMajor pivoted(rank, width);
    for (Eigen::Index i = 0; i < rank; ++i) {
        pivoted.row(i) = given.row(factors_->qr.order()[static_cast<size_t>(i)]);
    }
    Eigen::MatrixXd x = Eigen::MatrixXd::Zero(unknowns_, width);
    x.topRows(rank) = factors_->triangle().transpose().triangularView<Eigen::Lower>().solve(pivoted);
    x.applyOnTheLeft(factors_->qr.q());
    return values_of(x);
}

MinimumNorm::Multipliers MinimumNorm::multipliers(const std::vector<double> &x) const {
    const Eigen::Index rank = factors_->rank;
    Eigen::MatrixXd turned = Eigen::Map<const Eigen::VectorXd>(x.data(), unknowns_);
    factors_->qr.turn_back(turned);
    const Eigen::VectorXd solved =
        factors_->triangle().triangularView<Eigen::Upper>().solve(turned.col(0).head(rank));
    std::vector<double> values(static_cast<size_t>(factors_->qr.columns()), 0.0);
    for (Eigen::Index i = 0; i < rank; ++i) {
        values[static_cast<size_t>(factors_->qr.order()[static_cast<size_t>(i)])] = solved(i);
    }
    return {std::move(values), norm(turned.data() + rank, static_cast<int>(unknowns_ - rank))};
}

std::vector<double> MinimumNorm::kernel_part(const std::vector<double> &x) const {
    Eigen::MatrixXd turned = Eigen::Map<const Eigen::VectorXd>(x.data(), unknowns_);
    factors_->qr.turn_back(turned);
    turned.topRows(factors_->rank).setZero();
    factors_->qr.turn(turned);
    return values_of(turned);
}

struct RowSpace::Factors {
    Householder qr;
};

RowSpace::RowSpace(const std::vector<double> &rows, int64_t n)
    : unknowns_(n), factors_(std::make_unique<Factors>(
                        Factors{Householder(transposed(rows, n), Householder::Pivoting::none)})) {}

RowSpace::~RowSpace() = default;

int64_t RowSpace::size() const noexcept {
    return std::min(factors_->qr.rows(), factors_->qr.columns());
}

double RowSpace::coordinate(int64_t row, int64_t j) const noexcept {
    return j <= row ? factors_->qr.factors()(j, row) : 0;
}

std::vector<double> RowSpace::expand(const std::vector<double> &y, int64_t width) const {
    Eigen::MatrixXd x = Eigen::MatrixXd::Zero(unknowns_, width);
    x.topRows(size()) = matrix_of(y, width);
    x.applyOnTheLeft(factors_->qr.q());
    return values_of(x);
}

} // namespace nrb::inline numeric
