// SPDX-License-Identifier: MIT
#include "numeric/solvers/householder.h"

#include "base/numbers.h"
#include "base/watch.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace nrb::inline numeric {

namespace {

constexpr Eigen::Index panel = 48;       // columns whose reflections are applied to the others together
constexpr int64_t work_per_value = 4;    // of a reflection of one column
constexpr Eigen::Index most_chunk = 128; // columns that they are applied to at a time

} // namespace

Householder::Householder(Eigen::MatrixXd a, Pivoting pivoting)
    : a_(std::move(a)), coefficients_(std::min(a_.rows(), a_.cols())), work_(a_.cols()),
      order_(static_cast<size_t>(a_.cols())) {
    std::iota(order_.begin(), order_.end(), Eigen::Index{0});
    pivoting == Pivoting::columns ? factorise_by_columns() : factorise_by_panels();
}

Eigen::Index Householder::rank(double threshold) const noexcept {
    double largest = 0;
    for (Eigen::Index k = 0; k < coefficients_.size(); ++k) {
        largest = std::max(largest, std::abs(a_(k, k)));
    }
    Eigen::Index found = 0;
    for (Eigen::Index k = 0; k < coefficients_.size(); ++k) {
        found += std::abs(a_(k, k)) > threshold * largest ? 1 : 0;
    }
    return found;
}

// The reflection that leaves only the diagonal element of column k, applied to the columns up to `end`.
void Householder::reflect(Eigen::Index k, Eigen::Index end) {
    const Eigen::Index rest = a_.rows() - k;
    count_work(4 * rest * (end - k));
    double diagonal = 0;
    a_.col(k).tail(rest).makeHouseholderInPlace(coefficients_(k), diagonal);
    a_(k, k) = diagonal;
    a_.block(k, k + 1, rest, end - k - 1)
        .applyHouseholderOnTheLeft(a_.col(k).tail(rest - 1), coefficients_(k), work_.data() + k + 1);
}

void Householder::reflect(Eigen::Index k, Eigen::MatrixXd &x, double &work) const {
    const Eigen::Index rest = a_.rows() - k;
    count_work(work_per_value * rest);
    x.bottomRows(rest).applyHouseholderOnTheLeft(a_.col(k).tail(rest - 1), coefficients_(k), &work);
}

void Householder::turn(Eigen::MatrixXd &x) const {
    double work = 0;
    for (Eigen::Index k = coefficients_.size(); k-- > 0;) {
        reflect(k, x, work);
    }
}

void Householder::turn_back(Eigen::MatrixXd &x) const {
    double work = 0;
    for (Eigen::Index k = 0; k < coefficients_.size(); ++k) {
        reflect(k, x, work);
    }
}

// The column with the largest norm below row k (P. Businger, G. Golub, Numer. Math. 7 (1965)).
void Householder::choose_column(Eigen::Index k, Norms &norms) {
    Eigen::Index largest = 0;
    norms.updated.tail(a_.cols() - k).maxCoeff(&largest);
    largest += k;
    if (largest != k) {
        a_.col(k).swap(a_.col(largest));
        std::swap(norms.updated(k), norms.updated(largest));
        std::swap(norms.computed(k), norms.computed(largest));
        std::swap(order_[static_cast<size_t>(k)], order_[static_cast<size_t>(largest)]);
    }
}

// Norms without row k, computed anew where the difference has lost half its digits (Z. Drmac, Z. Bujanovic, ACM
// Trans. Math. Softw. 35 (2008)).
void Householder::update(Eigen::Index k, Norms &norms) const {
    const double lost = std::sqrt(eps);
    for (Eigen::Index j = k + 1; j < a_.cols(); ++j) {
        if (norms.updated(j) == 0) {
            continue;
        }
        const double ratio = std::abs(a_(k, j)) / norms.updated(j);
        const double left = std::max((1 + ratio) * (1 - ratio), 0.0);
        const double shrunk = norms.updated(j) / norms.computed(j);
        if (left * shrunk * shrunk <= lost) {
            norms.computed(j) = norms.updated(j) = a_.col(j).tail(a_.rows() - k - 1).norm();
        } else {
            norms.updated(j) *= std::sqrt(left);
        }
    }
}

void Householder::factorise_by_columns() {
    Norms norms{a_.colwise().norm(), {}};
    norms.computed = norms.updated;
    for (Eigen::Index k = 0; k < coefficients_.size(); ++k) {
        choose_column(k, norms);
        reflect(k, a_.cols());
        update(k, norms);
    }
}

void Householder::factorise_by_panels() {
    for (Eigen::Index first = 0; first < coefficients_.size(); first += panel) {
        const Eigen::Index end = std::min(first + panel, coefficients_.size());
        for (Eigen::Index k = first; k < end; ++k) {
            reflect(k, end);
        }
        apply_panel(first, end);
    }
}

void Householder::apply_panel(Eigen::Index first, Eigen::Index end) {
    const Eigen::Index rows = a_.rows() - first, size = end - first;
    const Eigen::MatrixXd vectors = a_.block(first, first, rows, size);
    const Eigen::VectorXd coefficients = coefficients_.segment(first, size);
    const Eigen::HouseholderSequence reflections(vectors, coefficients);
    for (Eigen::Index column = end; column < a_.cols(); column += most_chunk) {
        const Eigen::Index count = std::min(most_chunk, a_.cols() - column);
        count_work(4 * rows * size * count);
        a_.block(first, column, rows, count).applyOnTheLeft(reflections.adjoint());
    }
}

} // namespace nrb::inline numeric
