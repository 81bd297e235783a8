// SPDX-License-Identifier: MIT
#include "numeric/solvers/sparse_system.h"

#include "base/finite.h"

#include <Eigen/SparseCholesky>

namespace nrb::inline numeric {

namespace {

using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
using Sparse = Eigen::SparseMatrix<double, Eigen::ColMajor, int>;

Sparse sparse_of(const std::vector<Entry> &entries, Eigen::Index n) {
    std::vector<Eigen::Triplet<double>> triplets;
    triplets.reserve(entries.size());
    for (const Entry &entry : entries) {
        triplets.emplace_back(static_cast<int>(entry.row), static_cast<int>(entry.column), entry.value);
    }
    Sparse matrix(n, n);
    matrix.setFromTriplets(triplets.begin(), triplets.end());
    return matrix;
}

std::vector<Entry> diagonal_entries(const std::vector<double> &diagonal) {
    std::vector<Entry> entries;
    for (const double value : diagonal) {
        const int64_t i = std::ssize(entries);
        entries.push_back({i, i, value});
    }
    return entries;
}

} // namespace

std::vector<double> times(const std::vector<Entry> &entries, const std::vector<double> &x, int64_t width) {
    std::vector<double> result(x.size(), 0.0);
    for (const Entry &entry : entries) {
        for (int64_t c = 0; c < width; ++c) {
            result[static_cast<size_t>(entry.row * width + c)] +=
                entry.value * x[static_cast<size_t>(entry.column * width + c)];
        }
    }
    return result;
}

struct SparseSystem::Factors {
    Sparse matrix;
    Sparse diagonal;
    Eigen::SimplicialLDLT<Sparse> solver;
};

SparseSystem::SparseSystem(const std::vector<Entry> &entries, const std::vector<double> &diagonal)
    : factors_(std::make_unique<Factors>()) {
    const auto n = static_cast<Eigen::Index>(diagonal.size());
    factors_->matrix = sparse_of(entries, n);
    factors_->diagonal = sparse_of(diagonal_entries(diagonal), n);
    factors_->solver.analyzePattern(factors_->matrix + factors_->diagonal);
}

SparseSystem::~SparseSystem() = default;

bool SparseSystem::solve(double rho, const std::vector<double> &right, int64_t width,
                         std::vector<double> &x) {
    const Sparse sum = factors_->matrix + rho * factors_->diagonal;
    factors_->solver.factorize(sum);
    if (factors_->solver.info() != Eigen::Success || !(factors_->solver.vectorD().minCoeff() > 0)) {
        return false;
    }
    const Eigen::Index n = sum.rows();
    const RowMajor solution = factors_->solver.solve(Eigen::Map<const RowMajor>(right.data(), n, width));
    x.assign(solution.data(), solution.data() + solution.size());
    return all_finite(x);
}

} // namespace nrb::inline numeric
