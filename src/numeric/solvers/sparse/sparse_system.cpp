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

// Conjugate gradients for several right sides at once, each with steps of its own.
class SparseSystem::Iteration {
public:
    Iteration(const SparseSystem &system, double rho, int64_t width)
        : matrix_(system.shifted(rho)), factors_(system.factorised_ ? &*system.factors_ : nullptr),
          width_(width), n_(matrix_.size()), inverse_diagonal_(static_cast<size_t>(n_)) {
        for (int64_t j = 0; j < n_; ++j) {
            inverse_diagonal_[static_cast<size_t>(j)] = 1 / element(j, j);
        }
    }

    // Replaces the right side by the solution; false if it is not found in `most` steps.
    bool solve(std::vector<double> &right, int most) {
        constexpr double enough = 1e-10; // of the right side: the energy is off by its square
        std::vector<double> x(right.size(), 0.0), residual = right, conditioned, direction,
                                                  image(right.size());
        const std::vector<double> size = dots(right, right);
        std::vector<double> energy(size.size(), 0.0);
        for (int step = 0; step <= most; ++step) {
            if (small(residual, size, enough)) {
                right.swap(x);
                return true;
            }
            conditioned = residual;
            precondition(conditioned);
            const std::vector<double> next = dots(residual, conditioned);
            direction.resize(conditioned.size(), 0.0);
            add_scaled(direction, quotients(next, energy), conditioned);
            energy = next;
            multiply(direction, image);
            const std::vector<double> along = quotients(energy, dots(direction, image));
            for (size_t i = 0; i < x.size(); ++i) {
                const double part = along[i % static_cast<size_t>(width_)];
                x[i] += part * direction[i];
                residual[i] -= part * image[i];
            }
        }
        return false;
    }

private:
    [[nodiscard]] double element(int64_t row, int64_t column) const noexcept {
        const auto first = matrix_.rows.begin() + matrix_.starts[static_cast<size_t>(column)],
                   end = matrix_.rows.begin() + matrix_.starts[static_cast<size_t>(column) + 1];
        return matrix_.values[static_cast<size_t>(std::lower_bound(first, end, static_cast<int32_t>(row)) -
                                                  matrix_.rows.begin())];
    }
    // By right sides.
    [[nodiscard]] std::vector<double> dots(const std::vector<double> &a, const std::vector<double> &b) const {
        std::vector<double> sums(static_cast<size_t>(width_), 0.0);
        for (size_t i = 0; i < a.size(); ++i) {
            sums[i % sums.size()] += a[i] * b[i];
        }
        return sums;
    }
    static std::vector<double> quotients(const std::vector<double> &a, const std::vector<double> &b) {
        std::vector<double> result(a.size());
        std::transform(a.begin(), a.end(), b.begin(), result.begin(),
                       [](double x, double y) { return y > 0 ? x / y : 0; });
        return result;
    }
    [[nodiscard]] bool small(const std::vector<double> &residual, const std::vector<double> &size,
                             double part) const {
        const std::vector<double> squares = dots(residual, residual);
        for (size_t c = 0; c < squares.size(); ++c) {
            if (!(squares[c] <= part * part * size[c])) {
                return false;
            }
        }
        return true;
    }
    // direction = conditioned + part * direction.
    void add_scaled(std::vector<double> &direction, const std::vector<double> &part,
                    const std::vector<double> &conditioned) const {
        for (size_t i = 0; i < direction.size(); ++i) {
            direction[i] = conditioned[i] + part[i % static_cast<size_t>(width_)] * direction[i];
        }
    }
    void precondition(std::vector<double> &x) const {
        if (factors_ != nullptr) {
            factors_->solve(x.data(), width_);
            return;
        }
        for (size_t i = 0; i < x.size(); ++i) {
            x[i] *= inverse_diagonal_[i / static_cast<size_t>(width_)];
        }
    }
    // The columns of a symmetric matrix are its rows.
    void multiply(const std::vector<double> &x, std::vector<double> &image) const {
        for (int64_t j = 0; j < n_; ++j) {
            double *out = image.data() + j * width_;
            std::fill_n(out, width_, 0.0);
            const int64_t first = matrix_.starts[static_cast<size_t>(j)],
                          end = matrix_.starts[static_cast<size_t>(j) + 1];
            count_work(2 * width_ * (end - first));
            for (int64_t p = first; p < end; ++p) {
                const double value = matrix_.values[static_cast<size_t>(p)];
                const double *from = x.data() + int64_t{matrix_.rows[static_cast<size_t>(p)]} * width_;
                for (int64_t c = 0; c < width_; ++c) {
                    out[c] += value * from[c];
                }
            }
        }
    }

    SparseColumns matrix_;
    const SparseLdlt *factors_;
    int64_t width_;
    int64_t n_;
    std::vector<double> inverse_diagonal_;
};

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

bool SparseSystem::solve_ordered(double rho, std::vector<double> &x, int64_t width) {
    constexpr int many = 60, few = 12; // the latter with factors, which cost more to use
    const double product = 2 * static_cast<double>(entries_.rows.size());
    if (factors_->cost() > many * product) {
        const std::vector<double> right = x;
        if (Iteration(*this, rho, width).solve(x, factorised_ ? few : many)) {
            return true;
        }
        x = right;
    }
    factorised_ = factors_->factorise(shifted(rho)) < 0;
    if (factorised_) {
        factors_->solve(x.data(), width);
    }
    return factorised_;
}

bool SparseSystem::solve(double rho, const std::vector<double> &right, int64_t width,
                         std::vector<double> &x) {
    std::vector<double> ordered(order_.size() * static_cast<size_t>(width));
    for (size_t i = 0; i < order_.size(); ++i) {
        std::copy_n(right.begin() + order_[i] * width, width,
                    ordered.begin() + static_cast<int64_t>(i) * width);
    }
    if (!solve_ordered(rho, ordered, width)) {
        return false;
    }
    x.resize(ordered.size());
    for (size_t i = 0; i < order_.size(); ++i) {
        std::copy_n(ordered.begin() + static_cast<int64_t>(i) * width, width, x.begin() + order_[i] * width);
    }
    return all_finite(x);
}

} // namespace nrb::inline numeric
