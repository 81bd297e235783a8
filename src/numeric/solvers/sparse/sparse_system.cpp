// SPDX-License-Identifier: MIT
#include "numeric/solvers/sparse/sparse_system.h"

#include "base/finite.h"
#include "base/watch.h"

#include <algorithm>
#include <cmath>

namespace nrb::inline numeric {

namespace {

constexpr int64_t work_of_an_entry = 8; // for moving it in memory

// Compressed columns with unsorted rows; `number` maps each unknown to its new index.
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

// Transposing sorts the rows of each column, and leaves a symmetric matrix unchanged; entries that occur
// twice are summed.
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
        column = std::vector<std::pair<int32_t, double>>();
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
    : order_(std::move(order)), entries_(ascending(by_columns(entries, numbers_of(order_)))) {
    for (const int64_t i : order_) {
        diagonal_.push_back(diagonal[static_cast<size_t>(i)]);
    }
    factors_.emplace(entries_);
}

SparseColumns SparseSystem::shifted(double rho) const {
    SparseColumns sum = entries_;
    for (size_t j = 0; j < order_.size(); ++j) {
        const auto first = sum.rows.begin() + sum.starts[j], end = sum.rows.begin() + sum.starts[j + 1];
        const auto row = std::lower_bound(first, end, static_cast<int32_t>(j));
        sum.values[static_cast<size_t>(row - sum.rows.begin())] += rho * diagonal_[j];
    }
    return sum;
}

// Whether conjugate gradients preconditioned by the factors converge in few steps: the eigenvalues of the
// preconditioned matrix lie within a factor of the quotient of both values of rho.
bool SparseSystem::factors_suit(double rho) const noexcept {
    const double root = std::sqrt(std::max(rho / factors_rho_, factors_rho_ / rho));
    return 2 * std::pow((root - 1) / (root + 1), few_steps) < 1e-10;
}

bool SparseSystem::iterate(double rho, std::vector<double> &x, int64_t width) {
    constexpr int many = 60;
    const double product = 2 * static_cast<double>(entries_.rows.size());
    if (factors_->cost() <= many * product || (factorised_ && !factors_suit(rho))) {
        return false;
    }
    std::vector<double> solution = x;
    ConjugateGradients iteration(shifted(rho), rho, diagonal_, factorised_ ? &*factors_ : nullptr, width);
    const bool found = iteration.solve(solution, factorised_ ? few_steps : many, known_);
    if (found) {
        x.swap(solution);
    }
    return found;
}

bool SparseSystem::factorise(double rho) {
    factorised_ = factors_->factorise(shifted(rho)) < 0;
    factors_rho_ = rho;
    return factorised_;
}

bool SparseSystem::solve(double rho, const std::vector<double> &right, int64_t width,
                         std::vector<double> &x) {
    std::vector<double> ordered(order_.size() * static_cast<size_t>(width));
    for (size_t i = 0; i < order_.size(); ++i) {
        std::copy_n(right.begin() + order_[i] * width, width,
                    ordered.begin() + static_cast<int64_t>(i) * width);
    }
    if (ordered != right_) {
        right_ = ordered;
        known_.clear();
    }
    if (!iterate(rho, ordered, width)) {
        if (!factorise(rho)) {
            return false;
        }
        factors_->solve(ordered.data(), width);
    }
    x.resize(ordered.size());
    for (size_t i = 0; i < order_.size(); ++i) {
        std::copy_n(ordered.begin() + static_cast<int64_t>(i) * width, width, x.begin() + order_[i] * width);
    }
    if (!all_finite(x)) {
        return false;
    }
    remember(rho, std::move(ordered));
    return true;
}

void SparseSystem::remember(double rho, std::vector<double> x) {
    constexpr size_t most = 4;
    known_.push_front({rho, std::move(x)});
    if (known_.size() > most) {
        known_.pop_back();
    }
}

} // namespace nrb::inline numeric
