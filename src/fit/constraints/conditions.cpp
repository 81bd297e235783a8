// SPDX-License-Identifier: MIT
#include "fit/constraints/conditions.h"

#include "base/error.h"
#include "base/watch.h"
#include "fit/least_squares/active_functions.h"

#include <algorithm>
#include <cmath>

namespace nrb::fit {

namespace {

// Scales a row so that its largest coefficient is 1 or -1.
void scale(LinearRow &row) noexcept {
    double most = 0;
    for (const LinearRow::Coefficient &coefficient : row.coefficients) {
        most = std::max(most, std::abs(coefficient.value));
    }
    for (LinearRow::Coefficient &coefficient : row.coefficients) {
        coefficient.value = most > 0 ? coefficient.value / most : 0;
    }
    for (double &target : row.target) {
        target = most > 0 ? target / most : target;
    }
}

} // namespace

Conditions::Conditions(const std::vector<KnotVectorPtr> &axes, const std::vector<FitCondition> &conditions) {
    const StencilPattern numbers(axes);
    ActiveFunctions functions(axes);
    for (const FitCondition &condition : conditions) {
        for (size_t k = 0; k < axes.size(); ++k) {
            const double t = condition.place[k]; // the last span is closed
            functions.set(k, axes[k]->find_span(t, t == axes[k]->domain().upper), t, condition.orders[k]);
        }
        functions.multiply();
        LinearRow row{{}, condition.target};
        for (size_t i = 0; i < functions.size(); ++i) {
            const Index layer = functions.layer(i);
            row.coefficients.push_back({layer, numbers.unknown(layer), functions.values()[i]});
        }
        scale(row);
        rows_.push_back(std::move(row));
    }
}

void Conditions::add_squares(NormalEquations &equations) {
    const DoubleDouble factor = equations.matrix.mean();
    factor_ = factor;
    for (const LinearRow &row : rows_) {
        const auto dim = std::ssize(row.target);
        add_square(row, factor, equations.matrix);
        for (int64_t c = 0; c < dim; ++c) {
            add_multiple(row, factor * DoubleDouble(row.target[static_cast<size_t>(c)]), dim, c,
                         equations.right);
        }
        for (size_t c = 0; c < row.target.size(); ++c) {
            equations.squares[c] =
                equations.squares[c] + factor * DoubleDouble::product(row.target[c], row.target[c]);
        }
    }
}

namespace {

// The submatrix of a dense symmetric matrix [count][count] with the rows and columns `kept`.
ColumnsOf<DoubleDouble> part(const std::vector<DoubleDouble> &matrix, size_t count,
                             std::span<const size_t> kept) {
    ColumnsOf<DoubleDouble> columns;
    for (const size_t j : kept) {
        columns.starts.push_back(std::ssize(columns.rows));
        for (size_t i = 0; i < kept.size(); ++i) {
            columns.rows.push_back(static_cast<int32_t>(i));
            columns.values.push_back(matrix[kept[i] * count + j]);
        }
    }
    columns.starts.push_back(std::ssize(columns.rows));
    return columns;
}

// Solves matrix [count][count] mu = right [count][width], row by row. A row that depends linearly on those
// before it gets mu = 0 if its right-hand side depends on theirs in the same way; otherwise
// Status::contradiction is thrown.
class Multipliers {
public:
    Multipliers(const std::vector<DoubleDouble> &matrix, const std::vector<DoubleDouble> &right, int width)
        : matrix_(matrix), right_(right), width_(static_cast<size_t>(width)),
          count_(right.size() / std::max<size_t>(width_, 1)) {}

    std::vector<DoubleDouble> solve() {
        constexpr double dependent = 0x1p-70;
        for (size_t i = 0; i < count_; ++i) {
            kept_.push_back(i);
        }
        while (!kept_.empty()) {
            const auto columns = part(matrix_, count_, kept_);
            std::vector<double> floors;
            for (const size_t i : kept_) {
                floors.push_back(dependent * matrix_[i * count_ + i].high);
            }
            LdltOf<DoubleDouble> factors(columns);
            const int64_t bad = factors.factorise(columns, floors);
            if (bad < 0) {
                return solved(factors, kept_);
            }
            check_follows(static_cast<size_t>(bad));
            kept_.erase(kept_.begin() + bad);
        }
        return std::vector<DoubleDouble>(right_.size());
    }

private:
    std::vector<DoubleDouble> solved(const LdltOf<DoubleDouble> &factors,
                                     std::span<const size_t> kept) const {
        std::vector<DoubleDouble> own(kept.size() * width_), all(right_.size());
        for (size_t i = 0; i < kept.size(); ++i) {
            std::copy_n(right_.begin() + static_cast<int64_t>(kept[i] * width_), width_,
                        own.begin() + static_cast<int64_t>(i * width_));
        }
        factors.solve(own.data(), static_cast<int64_t>(width_));
        for (size_t i = 0; i < kept.size(); ++i) {
            std::copy_n(own.begin() + static_cast<int64_t>(i * width_), width_,
                        all.begin() + static_cast<int64_t>(kept[i] * width_));
        }
        return all;
    }
    void check_follows(size_t bad) const {
        constexpr double rounding = 0x1p-40;
        const std::span<const size_t> before = std::span(kept_).first(bad);
        std::vector<DoubleDouble> mu(right_.size());
        if (!before.empty()) {
            const auto columns = part(matrix_, count_, before);
            LdltOf<DoubleDouble> factors(columns);
            (void)factors.factorise(columns);
            mu = solved(factors, before);
        }
        const size_t row = kept_[bad];
        for (size_t c = 0; c < width_; ++c) {
            DoubleDouble sum = right_[row * width_ + c];
            double size = std::abs(sum.high);
            for (const size_t i : before) {
                const DoubleDouble term = matrix_[row * count_ + i] * mu[i * width_ + c];
                sum = sum - term;
                size = std::max(size, std::abs(term.high));
            }
            if (std::abs(sum.high) > rounding * size) {
                fail(Status::contradiction, "conditions[%zu] contradicts those before it", row);
            }
        }
    }

    const std::vector<DoubleDouble> &matrix_;
    const std::vector<DoubleDouble> &right_;
    size_t width_, count_;
    std::vector<size_t> kept_;
};

} // namespace

// Let C be the rows of the conditions, t their targets, A the matrix of the system, and A Z = C^T. With mu
// from C Z mu = C x - t, the solution is x - Z mu.
double Conditions::impose(PenalisedSystem &system, int dim, std::vector<DoubleDouble> &x) const {
    const auto count = std::ssize(rows_);
    const auto at = [&](int64_t i, int64_t j) { return static_cast<size_t>(i * count + j); };
    std::vector<DoubleDouble> columns(x.size() / static_cast<size_t>(dim) * rows_.size());
    for (int64_t r = 0; r < count; ++r) {
        for (const LinearRow::Coefficient &coefficient : rows_[static_cast<size_t>(r)].coefficients) {
            DoubleDouble &value = columns[static_cast<size_t>(coefficient.unknown * count + r)];
            value = value + DoubleDouble(coefficient.value);
        }
    }
    columns = system.solve(columns, count);
    std::vector<DoubleDouble> matrix(rows_.size() * rows_.size());
    std::vector<DoubleDouble> missing(rows_.size() * static_cast<size_t>(dim));
    for (int64_t r = 0; r < count; ++r) {
        const LinearRow &row = rows_[static_cast<size_t>(r)];
        for (int64_t j = 0; j < count; ++j) {
            matrix[at(r, j)] = left_side(row, columns, count, j);
        }
        for (int c = 0; c < dim; ++c) {
            missing[static_cast<size_t>(r * dim + c)] =
                left_side(row, x, dim, c) - DoubleDouble(row.target[static_cast<size_t>(c)]);
        }
    }
    const std::vector<DoubleDouble> mu = Multipliers(matrix, missing, dim).solve();
    for (size_t i = 0; i < x.size(); ++i) {
        const auto unknown = static_cast<int64_t>(i) / dim, c = static_cast<int64_t>(i) % dim;
        for (int64_t r = 0; r < count; ++r) {
            x[i] = x[i] -
                   columns[static_cast<size_t>(unknown * count + r)] * mu[static_cast<size_t>(r * dim + c)];
        }
    }
    return lost_freedom(system, columns, matrix);
}

// Let Z = A^-1 C^T, and G the matrix of the data, without the squares of the conditions. The loss is
//     factor tr (C Z) + tr ((C Z)^-1 Z^T G Z)
// where C and Z of the second term are restricted to linearly independent conditions.
double Conditions::lost_freedom(const PenalisedSystem &system, const std::vector<DoubleDouble> &columns,
                                const std::vector<DoubleDouble> &matrix) const {
    const auto count = rows_.size();
    const std::vector<DoubleDouble> image = system.product(columns, static_cast<int64_t>(count));
    std::vector<DoubleDouble> right(count * count);
    DoubleDouble lost;
    for (size_t i = 0; i < count; ++i) {
        lost = lost + factor_ * matrix[i * count + i];
        for (size_t j = 0; j < count; ++j) {
            for (size_t u = 0; u < columns.size(); u += count) {
                right[i * count + j] = right[i * count + j] + columns[u + i] * image[u + j];
            }
            for (size_t r = 0; r < count; ++r) {
                right[i * count + j] =
                    right[i * count + j] - factor_ * matrix[r * count + i] * matrix[r * count + j];
            }
        }
    }
    const std::vector<DoubleDouble> solved = Multipliers(matrix, right, static_cast<int>(count)).solve();
    for (size_t i = 0; i < count; ++i) {
        lost = lost + solved[i * count + i];
    }
    return lost.high;
}

} // namespace nrb::fit
