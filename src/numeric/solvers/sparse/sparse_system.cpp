// SPDX-License-Identifier: MIT
#include "numeric/solvers/sparse/sparse_system.h"

#include "base/finite.h"
#include "base/watch.h"

#include <algorithm>

namespace nrb::inline numeric {

namespace {

constexpr int64_t work_of_an_entry = 8; // which is moved about in memory

// By columns, rows in any order. New numbers by the old ones.
SparseColumns by_columns(const std::vector<Entry> &entries, const std::vector<int32_t> &number) {
    SparseColumns columns;
    columns.starts.assign(number.size() + 1, 0);
    for (const Entry &entry : entries) {
        ++columns.starts[static_cast<size_t>(number[static_cast<size_t>(entry.column)]) + 1];
    }
    for (size_t j = 1; j < columns.starts.size(); ++j) {
        columns.starts[j] += columns.starts[j - 1];
    }
    grow_watched(columns.rows, entries.size());
    grow_watched(columns.values, entries.size());
    std::vector<int64_t> next(columns.starts.begin(), columns.starts.end() - 1);
    for (const Entry &entry : entries) {
        count_work(work_of_an_entry);
        const auto column = static_cast<size_t>(number[static_cast<size_t>(entry.column)]);
        const auto place = static_cast<size_t>(next[column]++);
        columns.rows[place] = number[static_cast<size_t>(entry.row)];
        columns.values[place] = entry.value;
    }
    return columns;
}

// The transpose of a symmetric matrix is the matrix with rows that ascend; those that occur twice are added.
SparseColumns ascending(const SparseColumns &matrix) {
    const auto n = static_cast<int32_t>(matrix.size());
    std::vector<std::vector<std::pair<int32_t, double>>> columns(static_cast<size_t>(n));
    int64_t size = 0;
    for (int32_t j = 0; j < n; ++j) {
        const int64_t first = matrix.starts[static_cast<size_t>(j)],
                      end = matrix.starts[static_cast<size_t>(j) + 1];
        count_work(work_of_an_entry * (end - first));
        for (int64_t p = first; p < end; ++p) {
            auto &column = columns[static_cast<size_t>(matrix.rows[static_cast<size_t>(p)])];
            const double value = matrix.values[static_cast<size_t>(p)];
            if (!column.empty() && column.back().first == j) {
                column.back().second += value;
            } else {
                column.emplace_back(j, value);
                ++size;
            }
        }
    }
    SparseColumns result;
    grow_watched(result.rows, static_cast<size_t>(size));
    grow_watched(result.values, static_cast<size_t>(size));
    result.starts.push_back(0);
    size_t place = 0;
    for (auto &column : columns) {
        count_work(work_of_an_entry * std::ssize(column));
        for (const auto &[row, value] : column) {
            result.rows[place] = row;
            result.values[place++] = value;
        }
        result.starts.push_back(static_cast<int64_t>(place));
        column = {};
    }
    return result;
}

std::vector<int32_t> numbers_of(const std::vector<int64_t> &order) {
    std::vector<int32_t> number(order.size());
    for (size_t i = 0; i < order.size(); ++i) {
        number[static_cast<size_t>(order[i])] = static_cast<int32_t>(i);
    }
    return number;
}

} // namespace

std::vector<double> times(const std::vector<Entry> &entries, const std::vector<double> &x, int64_t width) {
    std::vector<double> result(x.size(), 0.0);
    for (const Entry &entry : entries) {
        count_work(2 * width);
        for (int64_t c = 0; c < width; ++c) {
            result[static_cast<size_t>(entry.row * width + c)] +=
                entry.value * x[static_cast<size_t>(entry.column * width + c)];
        }
    }
    return result;
}

SparseSystem::SparseSystem(const std::vector<Entry> &entries, std::vector<double> diagonal,
                           std::vector<int64_t> order)
    : diagonal_(std::move(diagonal)), order_(std::move(order)),
      entries_(ascending(by_columns(entries, numbers_of(order_)))) {
    factors_.emplace(entries_);
}

bool SparseSystem::solve(double rho, const std::vector<double> &right, int64_t width,
                         std::vector<double> &x) {
    const size_t n = order_.size();
    SparseColumns sum = entries_;
    for (size_t j = 0; j < n; ++j) {
        const auto first = sum.rows.begin() + sum.starts[j], end = sum.rows.begin() + sum.starts[j + 1];
        const auto row = std::lower_bound(first, end, static_cast<int32_t>(j));
        sum.values[static_cast<size_t>(row - sum.rows.begin())] +=
            rho * diagonal_[static_cast<size_t>(order_[j])];
    }
    if (!factors_->factorise(sum)) {
        return false;
    }
    const auto length = static_cast<size_t>(width);
    std::vector<double> ordered(n * length);
    for (size_t i = 0; i < n; ++i) {
        std::copy_n(right.begin() + order_[i] * width, width,
                    ordered.begin() + static_cast<int64_t>(i) * width);
    }
    factors_->solve(ordered.data(), width);
    x.resize(ordered.size());
    for (size_t i = 0; i < n; ++i) {
        std::copy_n(ordered.begin() + static_cast<int64_t>(i) * width, width, x.begin() + order_[i] * width);
    }
    return all_finite(x);
}

} // namespace nrb::inline numeric
