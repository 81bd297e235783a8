// SPDX-License-Identifier: MIT
#include "numeric/solvers/sparse/selected_inverse.h"

#include "base/watch.h"
#include "numeric/solvers/sparse/dense_product.h"

#include <Eigen/Core>

#include <algorithm>
#include <type_traits>

namespace nrb::inline numeric {

namespace {

using sparse::at;

double rounded(double x) noexcept {
    return x;
}
double rounded(const DoubleDouble &x) noexcept {
    return x.high;
}

// The block recurrence for a supernode with columns J and the rows R below them, after all later supernodes.
// With Z the inverse: Y = L_RJ L_JJ^-1, Z_RJ = -Z_RR Y and Z_JJ = L_JJ^-T D^-1 L_JJ^-1 - Y^T Z_RJ.
class BlockInverse {
public:
    BlockInverse(const SparseLdlt &factors, std::span<double> values, std::span<double> diagonal)
        : factors_(factors), supernodes_(factors.supernodes()), values_(values), diagonal_(diagonal),
          place_(diagonal.size(), -1) {}

    void invert() {
        Steps steps(supernodes_.count());
        for (int64_t s = supernodes_.count(); s-- > 0; steps.next()) {
            read_factors(s);
            read_inverse(s);
            invert_block();
            write(s);
        }
    }

private:
    using Matrix = Eigen::MatrixXd;

    void invert_block() {
        const Eigen::Index n = own_.rows();
        Matrix inverse = Matrix::Identity(n, n); // of L_JJ
        own_.triangularView<Eigen::UnitLower>().solveInPlace(inverse);
        count_work(n * n * n / 3);
        const Matrix upper = -inverse.transpose(), factors = minus(upper, below_, false); // factors = Y^T
        inverse_below_ = minus(behind_, factors, false);
        square_ = minus(upper * pivots_.cwiseInverse().asDiagonal(), -upper, true);
        subtract(factors, inverse_below_.transpose(), true, square_);
    }
    // c -= a b^T.
    static void subtract(const Matrix &a, const Matrix &b, bool lower, Matrix &c) {
        subtract_product({c.data(), c.rows(), c.cols(), c.rows()}, {a.data(), a.rows(), a.cols(), a.rows()},
                         {b.data(), b.rows(), b.cols(), b.rows()}, lower);
    }
    static Matrix minus(const Matrix &a, const Matrix &b, bool lower) {
        Matrix c = Matrix::Zero(a.rows(), b.rows());
        subtract(a, b, lower, c);
        return c;
    }
    void read_factors(int64_t s) {
        const int64_t first = supernodes_.first[at(s)], n = supernodes_.columns(s);
        const int64_t r = std::ssize(supernodes_.below(s));
        own_.resize(n, n);
        below_.resize(r, n);
        pivots_ = Eigen::VectorXd::Map(factors_.diagonal().data() + first, n);
        for (int64_t j = 0; j < n; ++j) {
            const double *const from = factors_.values().data() + factors_.starts()[at(first + j)];
            std::copy_n(from, n - 1 - j, own_.col(j).data() + j + 1);
            std::copy_n(from + (n - 1 - j), r, below_.col(j).data());
        }
    }
    // Reads Z_RR, whose elements are in columns that are already done.
    void read_inverse(int64_t s) {
        const auto rows = supernodes_.below(s);
        const auto r = std::ssize(rows);
        behind_.resize(r, r);
        for (int64_t i = 0; i < r; ++i) {
            place_[at(rows[at(i)])] = i;
        }
        for (int64_t j = 0; j < r; ++j) {
            const auto column = at(rows[at(j)]);
            behind_(j, j) = diagonal_[column];
            for (int64_t p = factors_.starts()[column]; p < factors_.starts()[column + 1]; ++p) {
                if (const int64_t i = place_[at(factors_.rows()[at(p)])]; i >= 0) {
                    behind_(i, j) = behind_(j, i) = values_[at(p)];
                }
            }
        }
        for (const int32_t row : rows) {
            place_[at(row)] = -1;
        }
    }
    void write(int64_t s) {
        const int64_t first = supernodes_.first[at(s)], n = supernodes_.columns(s);
        for (int64_t j = 0; j < n; ++j) {
            double *const to = values_.data() + factors_.starts()[at(first + j)];
            std::copy_n(square_.col(j).data() + j + 1, n - 1 - j, to);
            std::copy_n(inverse_below_.col(j).data(), inverse_below_.rows(), to + (n - 1 - j));
            diagonal_[at(first + j)] = square_(j, j);
        }
    }

    const SparseLdlt &factors_;
    const Supernodes &supernodes_;
    std::span<double> values_, diagonal_;
    std::vector<int64_t> place_;                           // index in R
    Matrix own_, below_, behind_, inverse_below_, square_; // L_JJ, L_RJ, Z_RR, Z_RJ, Z_JJ
    Eigen::VectorXd pivots_;
};

} // namespace

template <class Number>
SelectedInverse::SelectedInverse(const LdltOf<Number> &factors)
    : starts_(factors.starts().begin(), factors.starts().end()),
      rows_(factors.rows().begin(), factors.rows().end()), values_(rows_.size()),
      diagonal_(factors.diagonal().size()) {
    if constexpr (std::is_same_v<Number, double>) {
        if (!factors.supernodes().empty()) {
            BlockInverse(factors, values_, diagonal_).invert();
            return;
        }
    }
    invert_columns(factors);
}

// Z_ij = - sum_k Z_ik L_kj for i > j, and Z_jj = 1 / d_j - sum_k Z_jk L_kj, over the nonzeros k of column j
// of L.
template <class Number>
void SelectedInverse::invert_columns(const LdltOf<Number> &factors) {
    std::vector<double> column(diagonal_.size(), 0.0), sums(diagonal_.size(), 0.0); // 0 outside the column
    for (int64_t j = std::ssize(diagonal_); j-- > 0;) {
        const int64_t first = starts_[at(j)], end = starts_[at(j) + 1];
        for (int64_t p = first; p < end; ++p) {
            column[at(rows_[at(p)])] = rounded(factors.values()[at(p)]);
        }
        int64_t work = 0;
        for (int64_t p = first; p < end; ++p) {
            const int64_t k = rows_[at(p)];
            const double factor = column[at(k)];
            double sum = diagonal_[at(k)] * factor;
            for (int64_t r = starts_[at(k)]; r < starts_[at(k) + 1]; ++r) {
                const auto i = at(rows_[at(r)]);
                sum += values_[at(r)] * column[i];
                sums[i] += values_[at(r)] * factor;
            }
            sums[at(k)] += sum;
            work += 2 * (starts_[at(k) + 1] - starts_[at(k)]);
        }
        double diagonal = 1 / rounded(factors.diagonal()[at(j)]);
        for (int64_t p = first; p < end; ++p) {
            values_[at(p)] = -sums[at(rows_[at(p)])];
            diagonal -= values_[at(p)] * column[at(rows_[at(p)])];
        }
        diagonal_[at(j)] = diagonal;
        for (int64_t p = first; p < end; ++p) { // sums outside column j were added to as well
            const int64_t k = rows_[at(p)];
            column[at(k)] = sums[at(k)] = 0;
            for (int64_t r = starts_[at(k)]; r < starts_[at(k) + 1]; ++r) {
                sums[at(rows_[at(r)])] = 0;
            }
        }
        count_work(work);
    }
}

double SelectedInverse::trace_of_product(const SparseColumns &matrix) const noexcept {
    double sum = 0;
    for (int64_t j = 0; j < matrix.size(); ++j) {
        int64_t next = starts_[at(j)];
        for (int64_t p = matrix.starts[at(j)]; p < matrix.starts[at(j) + 1]; ++p) {
            const int32_t row = matrix.rows[at(p)];
            if (row < j) {
                continue;
            }
            if (row == j) {
                sum += diagonal_[at(j)] * matrix.values[at(p)];
                continue;
            }
            while (rows_[at(next)] < row) {
                ++next;
            }
            sum += 2 * values_[at(next)] * matrix.values[at(p)];
        }
    }
    return sum;
}

double SelectedInverse::element(int64_t i, int64_t j) const noexcept {
    if (i == j) {
        return diagonal_[at(i)];
    }
    const auto [column, row] = std::minmax(i, j);
    const auto first = rows_.begin() + starts_[at(column)], end = rows_.begin() + starts_[at(column) + 1];
    const auto found = std::lower_bound(first, end, static_cast<int32_t>(row));
    return found != end && *found == row ? values_[at(found - rows_.begin())] : 0;
}

template SelectedInverse::SelectedInverse(const LdltOf<double> &);
template SelectedInverse::SelectedInverse(const LdltOf<DoubleDouble> &);

} // namespace nrb::inline numeric
