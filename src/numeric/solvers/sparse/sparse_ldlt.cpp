// SPDX-License-Identifier: MIT
#include "numeric/solvers/sparse/sparse_ldlt.h"

#include "base/watch.h"
#include "numeric/solvers/sparse/multifrontal.h"

#include <algorithm>
#include <numeric>
#include <type_traits>

namespace nrb::inline numeric {

namespace {

using sparse::at;

double leading(double x) noexcept {
    return x;
}
double leading(const DoubleDouble &x) noexcept {
    return x.high;
}

} // namespace

// Visits the nonzeros of row k of L left of the diagonal: from each element of the matrix it follows the
// elimination tree up to a node already visited.
template <class Number>
template <class Any, class Visit>
void LdltOf<Number>::for_each_in_row(const ColumnsOf<Any> &matrix, int32_t k, Visit &&visit) {
    flags_[at(k)] = k;
    for (int64_t p = matrix.starts[at(k)]; p < matrix.starts[at(k) + 1] && matrix.rows[at(p)] < k; ++p) {
        for (int32_t i = matrix.rows[at(p)]; flags_[at(i)] != k; i = parent_[at(i)]) {
            if (parent_[at(i)] < 0) {
                parent_[at(i)] = k;
            }
            flags_[at(i)] = k;
            visit(i);
        }
    }
}

template <class Number>
template <class Any>
LdltOf<Number>::LdltOf(const ColumnsOf<Any> &pattern)
    : parent_(at(pattern.size()), -1), starts_(at(pattern.size()) + 1, 0), filled_(at(pattern.size())),
      diagonal_(at(pattern.size())), flags_(at(pattern.size()), -1), path_(at(pattern.size())),
      work_(at(pattern.size())) {
    for (int32_t k = 0; k < pattern.size(); ++k) {
        int64_t found = 0;
        for_each_in_row(pattern, k, [&](int32_t i) {
            ++starts_[at(i) + 1];
            ++found;
        });
        count_work(4 * found);
    }
    if constexpr (std::is_same_v<Number, double> && std::is_same_v<Any, double>) {
        join_columns(pattern);
    }
    for (size_t k = 1; k < starts_.size(); ++k) {
        starts_[k] += starts_[k - 1];
    }
}

// Forms supernodes if the columns are long on average; starts_ holds their lengths.
template <class Number>
template <class Any>
void LdltOf<Number>::join_columns(const ColumnsOf<Any> &pattern) {
    constexpr int64_t longest = 24; // longest average column length that is better treated column by column
    const auto n = static_cast<int64_t>(parent_.size());
    if (std::reduce(starts_.begin(), starts_.end(), int64_t{0}) <= longest * n) {
        return;
    }
    supernodes_ = find_supernodes(pattern, parent_, std::span(starts_).subspan(1));
    for (int64_t s = 0; s < supernodes_.count(); ++s) {
        const int64_t end = supernodes_.first[at(s) + 1], below = std::ssize(supernodes_.below(s));
        for (int64_t j = supernodes_.first[at(s)]; j < end; ++j) {
            starts_[at(j) + 1] = end - 1 - j + below;
        }
    }
}

template <class Number>
double LdltOf<Number>::cost() const noexcept {
    double sum = 0;
    for (size_t k = 1; k < starts_.size(); ++k) {
        const auto elements = static_cast<double>(starts_[k] - starts_[k - 1]);
        sum += elements * (elements + 1) / 2;
    }
    return sum;
}

// The nonzeros of row k in an order in which each comes after those that modify it; scatters the values of
// the matrix into work_.
template <class Number>
int64_t LdltOf<Number>::gather_row(const ColumnsOf<Number> &matrix, int32_t k) {
    const int64_t n = matrix.size();
    int64_t top = n;
    flags_[at(k)] = k;
    for (int64_t p = matrix.starts[at(k)]; p < matrix.starts[at(k) + 1] && matrix.rows[at(p)] <= k; ++p) {
        int32_t i = matrix.rows[at(p)];
        work_[at(i)] = work_[at(i)] + matrix.values[at(p)];
        int64_t length = 0;
        for (; flags_[at(i)] != k; i = parent_[at(i)]) {
            path_[at(length++)] = i;
            flags_[at(i)] = k;
        }
        while (length > 0) {
            path_[at(--top)] = path_[at(--length)];
        }
    }
    return top;
}

template <class Number>
int64_t LdltOf<Number>::factorise(const ColumnsOf<Number> &matrix, std::span<const double> floors) {
    const bool first =
        values_.size() < at(starts_.back()); // maybe after a call that was ended while they grew
    grow_watched(rows_, at(starts_.back())); // allocated here: many systems need no factors
    grow_watched(values_, at(starts_.back()));
    if constexpr (std::is_same_v<Number, double>) {
        if (!supernodes_.empty()) {
            if (first) {
                fill_rows();
            }
            return factorise_fronts(matrix, supernodes_, floors, starts_, values_, diagonal_);
        }
    }
    return factorise_rows(matrix, floors);
}

template <class Number>
void LdltOf<Number>::fill_rows() noexcept {
    for (int64_t s = 0; s < supernodes_.count(); ++s) {
        const int32_t end = supernodes_.first[at(s) + 1];
        for (int32_t j = supernodes_.first[at(s)]; j < end; ++j) {
            const auto own = rows_.begin() + starts_[at(j)];
            std::iota(own, own + (end - 1 - j), j + 1);
            std::ranges::copy(supernodes_.below(s), own + (end - 1 - j));
        }
    }
}

template <class Number>
int64_t LdltOf<Number>::factorise_rows(const ColumnsOf<Number> &matrix, std::span<const double> floors) {
    const auto n = static_cast<int32_t>(matrix.size());
    std::copy_n(starts_.begin(), n, filled_.begin());
    std::fill(flags_.begin(), flags_.end(), -1);
    std::fill(work_.begin(), work_.end(), Number{});
    Steps steps(n);
    for (int32_t k = 0; k < n; ++k, steps.next()) {
        int64_t top = gather_row(matrix, k), work = 0;
        Number pivot = work_[at(k)];
        work_[at(k)] = Number{};
        for (; top < n; ++top) {
            const int32_t i = path_[at(top)];
            const Number y = work_[at(i)], element = y / diagonal_[at(i)];
            work_[at(i)] = Number{};
            int64_t &end = filled_[at(i)];
            for (int64_t p = starts_[at(i)]; p < end; ++p) {
                Number &changed = work_[at(rows_[at(p)])];
                changed = changed - values_[at(p)] * y;
            }
            work += end - starts_[at(i)];
            pivot = pivot - element * y;
            rows_[at(end)] = k;
            values_[at(end++)] = element;
        }
        if (!(leading(pivot) > (floors.empty() ? 0 : floors[at(k)]))) {
            return k;
        }
        diagonal_[at(k)] = pivot;
        count_work(work);
    }
    return -1;
}

template <class Number>
void LdltOf<Number>::solve(Number *x, int64_t width) const {
    if constexpr (std::is_same_v<Number, double>) {
        if (!supernodes_.empty()) {
            return solve_fronts(supernodes_, starts_, values_, diagonal_, x, width);
        }
    }
    const auto n = static_cast<int64_t>(diagonal_.size());
    const auto add = [&](int64_t to, const Number &factor, int64_t from) {
        for (int64_t c = 0; c < width; ++c) {
            x[to * width + c] = x[to * width + c] - factor * x[from * width + c];
        }
    };
    for (int64_t j = 0; j < n; ++j) {
        count_work(2 * width * (starts_[at(j) + 1] - starts_[at(j)]));
        for (int64_t p = starts_[at(j)]; p < starts_[at(j) + 1]; ++p) {
            add(rows_[at(p)], values_[at(p)], j);
        }
    }
    for (int64_t j = 0; j < n; ++j) {
        for (int64_t c = 0; c < width; ++c) {
            x[j * width + c] = x[j * width + c] / diagonal_[at(j)];
        }
    }
    for (int64_t j = n; j-- > 0;) {
        count_work(2 * width * (starts_[at(j) + 1] - starts_[at(j)]));
        for (int64_t p = starts_[at(j)]; p < starts_[at(j) + 1]; ++p) {
            add(j, values_[at(p)], rows_[at(p)]);
        }
    }
}

template class LdltOf<double>;
template class LdltOf<DoubleDouble>;
template LdltOf<double>::LdltOf(const ColumnsOf<double> &);
template LdltOf<DoubleDouble>::LdltOf(const ColumnsOf<double> &);
template LdltOf<DoubleDouble>::LdltOf(const ColumnsOf<DoubleDouble> &);

} // namespace nrb::inline numeric
