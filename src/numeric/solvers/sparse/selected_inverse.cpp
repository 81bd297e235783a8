// SPDX-License-Identifier: MIT
#include "numeric/solvers/sparse/selected_inverse.h"

#include "base/watch.h"

#include <algorithm>

namespace nrb::inline numeric {

namespace {

size_t place(int64_t i) noexcept {
    return static_cast<size_t>(i);
}
double rounded(double x) noexcept {
    return x;
}
double rounded(const DoubleDouble &x) noexcept {
    return x.high;
}

} // namespace

// Z_ij = - sum_k Z_ik L_kj for i > j, and Z_jj = 1 / d_j - sum_k Z_jk L_kj, over the elements k of column j of L.
template <class Number>
SelectedInverse::SelectedInverse(const LdltOf<Number> &factors)
    : starts_(factors.starts().begin(), factors.starts().end()),
      rows_(factors.rows().begin(), factors.rows().end()), values_(rows_.size()),
      diagonal_(factors.diagonal().size()) {
    std::vector<double> column(diagonal_.size(), 0.0), sums(diagonal_.size(), 0.0); // 0 outside the column
    for (int64_t j = std::ssize(diagonal_); j-- > 0;) {
        const int64_t first = starts_[place(j)], end = starts_[place(j) + 1];
        for (int64_t p = first; p < end; ++p) {
            column[place(rows_[place(p)])] = rounded(factors.values()[place(p)]);
        }
        int64_t work = 0;
        for (int64_t p = first; p < end; ++p) {
            const int64_t k = rows_[place(p)];
            const double factor = column[place(k)];
            double sum = diagonal_[place(k)] * factor;
            for (int64_t r = starts_[place(k)]; r < starts_[place(k) + 1]; ++r) {
                const auto i = place(rows_[place(r)]);
                sum += values_[place(r)] * column[i];
                sums[i] += values_[place(r)] * factor;
            }
            sums[place(k)] += sum;
            work += 2 * (starts_[place(k) + 1] - starts_[place(k)]);
        }
        double diagonal = 1 / rounded(factors.diagonal()[place(j)]);
        for (int64_t p = first; p < end; ++p) {
            values_[place(p)] = -sums[place(rows_[place(p)])];
            diagonal -= values_[place(p)] * column[place(rows_[place(p)])];
        }
        diagonal_[place(j)] = diagonal;
        for (int64_t p = first; p < end; ++p) { // what lies outside column j was added to as well
            const int64_t k = rows_[place(p)];
            column[place(k)] = sums[place(k)] = 0;
            for (int64_t r = starts_[place(k)]; r < starts_[place(k) + 1]; ++r) {
                sums[place(rows_[place(r)])] = 0;
            }
        }
        count_work(work);
    }
}

double SelectedInverse::trace_of_product(const SparseColumns &matrix) const noexcept {
    double sum = 0;
    for (int64_t j = 0; j < matrix.size(); ++j) {
        int64_t next = starts_[place(j)];
        for (int64_t p = matrix.starts[place(j)]; p < matrix.starts[place(j) + 1]; ++p) {
            const int32_t row = matrix.rows[place(p)];
            if (row < j) {
                continue;
            }
            if (row == j) {
                sum += diagonal_[place(j)] * matrix.values[place(p)];
                continue;
            }
            while (rows_[place(next)] < row) {
                ++next;
            }
            sum += 2 * values_[place(next)] * matrix.values[place(p)];
        }
    }
    return sum;
}

double SelectedInverse::element(int64_t i, int64_t j) const noexcept {
    if (i == j) {
        return diagonal_[place(i)];
    }
    const auto [column, row] = std::minmax(i, j);
    const auto first = rows_.begin() + starts_[place(column)],
               end = rows_.begin() + starts_[place(column) + 1];
    const auto found = std::lower_bound(first, end, static_cast<int32_t>(row));
    return found != end && *found == row ? values_[place(found - rows_.begin())] : 0;
}

template SelectedInverse::SelectedInverse(const LdltOf<double> &);
template SelectedInverse::SelectedInverse(const LdltOf<DoubleDouble> &);

} // namespace nrb::inline numeric
