// SPDX-License-Identifier: MIT
#include "modify/constrain/linear_constraints.h"

#include "base/checked.h"
#include "base/watch.h"
#include "modify/constrain/scaling.h"
#include "numeric/norm.h"
#include "numeric/solvers/minimum_norm.h"

#include <algorithm>
#include <cmath>
#include <functional>

namespace nrb::modify {

namespace {

// Equations with fixed weights: row[row_of[k]] . x = right_k along a vector.
class LinearSystem {
public:
    LinearSystem(const NetState &state, const std::vector<LocalEquations> &all)
        : dim_(state.start().dim()), columns_(state.columns()), unknowns_(std::ssize(columns_.point_costs)) {
        static_cast<void>(checked_product(std::ssize(all) * max_axes, unknowns_, "equations"));
        size_t rows = 0;
        for (const LocalEquations &local : all) {
            rows += local.functions.size();
        }
        rows_.reserve(rows * static_cast<size_t>(unknowns_));
        for (const LocalEquations &local : all) {
            add_rows(local);
        }
        const double threshold = pivot_threshold(state.start(), row_of_.size(), unknowns_);
        if (values_only_) {
            solver_ = std::make_unique<MinimumNorm>(rows_, unknowns_, threshold);
            return;
        }
        space_ = std::make_unique<RowSpace>(rows_, unknowns_);
        solver_ = std::make_unique<MinimumNorm>(reduced_rows(), space_->size() * dim_, threshold);
    }

    [[nodiscard]] int64_t rank() const noexcept { return solver_->rank() * (values_only_ ? dim_ : 1); }
    // The shortest solution that cancels the residuals, in coordinates of the space of the rows unless all
    // conditions are values.
    [[nodiscard]] std::vector<double> solve(const std::vector<LocalEquations> &all) const {
        std::vector<double> right;
        for (const LocalEquations &local : all) {
            for (const double residual : local.residual) {
                right.push_back(-residual / size_of_[row_of_[right.size()]]);
            }
        }
        return solver_->solve(right, values_only_ ? dim_ : 1);
    }
    // The scaled moves [columns][dim] of a solution.
    [[nodiscard]] std::vector<double> moves(const std::vector<double> &solution) const {
        return values_only_ ? solution : space_->expand(solution, dim_);
    }
    // What multipliers leave of a solution, as a part of it.
    [[nodiscard]] double optimality(const std::vector<double> &solution) const {
        const size_t width = values_only_ ? static_cast<size_t>(dim_) : 1;
        double rest = 0;
        std::vector<double> component(solution.size() / width);
        for (size_t c = 0; c < width; ++c) {
            for (size_t i = 0; i < component.size(); ++i) {
                component[i] = solution[i * width + c];
            }
            rest = std::hypot(rest, solver_->multipliers(component).rest);
        }
        return rest == 0 ? 0 : rest / length_of(solution);
    }

private:
    void add_rows(const LocalEquations &local) {
        const size_t first = size_of_.size(),
                     width = local.jacobian.size() / std::max<size_t>(1, local.residual.size());
        for (const std::vector<double> &functions : local.functions) {
            add_row(local.points, functions);
        }
        const auto dim = static_cast<size_t>(dim_);
        for (size_t k = 0; k < local.residual.size(); ++k) {
            const double *const row = local.jacobian.data() + k * width;
            const auto at =
                static_cast<size_t>(std::find_if(row, row + width, [](double x) { return x != 0; }) - row);
            row_of_.push_back(first + at / dim);
            along_.insert(along_.end(), row + at / dim * dim, row + at / dim * dim + dim);
        }
        values_only_ = values_only_ && local.functions.size() == 1 && local.residual.size() == dim;
    }

    // Scaled to length 1.
    void add_row(const std::vector<int64_t> &points, const std::vector<double> &functions) {
        count_work(4 * unknowns_);
        rows_.resize(rows_.size() + static_cast<size_t>(unknowns_), 0.0);
        double *const row = rows_.data() + (rows_.size() - static_cast<size_t>(unknowns_));
        for (size_t i = 0; i < points.size(); ++i) {
            if (const int64_t column = columns_.points[static_cast<size_t>(points[i])]; column >= 0) {
                row[column] += functions[i] / std::sqrt(columns_.point_costs[static_cast<size_t>(column)]);
            }
        }
        const double size = norm(row, static_cast<int>(unknowns_));
        size_of_.push_back(size > 0 ? size : 1);
        std::transform(row, row + unknowns_, row, [&](double x) { return x / size_of_.back(); });
    }

    [[nodiscard]] std::vector<double> reduced_rows() const {
        std::vector<double> rows;
        rows.reserve(row_of_.size() * static_cast<size_t>(space_->size() * dim_));
        for (size_t k = 0; k < row_of_.size(); ++k) {
            count_work(4 * space_->size() * dim_);
            for (int64_t j = 0; j < space_->size(); ++j) {
                const double value = space_->coordinate(static_cast<int64_t>(row_of_[k]), j);
                for (int c = 0; c < dim_; ++c) {
                    rows.push_back(value * along_[k * static_cast<size_t>(dim_) + static_cast<size_t>(c)]);
                }
            }
        }
        return rows;
    }

    int dim_;
    const Columns &columns_;
    int64_t unknowns_;
    bool values_only_ = true; // equation dim * j + c is coordinate c of row j
    std::vector<double> rows_;
    std::vector<double> size_of_;
    std::vector<size_t> row_of_; // by equations
    std::vector<double> along_;  // [equations][dim]
    std::unique_ptr<RowSpace> space_;
    std::unique_ptr<MinimumNorm> solver_;
};

} // namespace

Constrained solve_linear(NetState &state, const std::vector<Condition> &conditions, double tolerance) {
    constexpr int rounds = 3; // residuals are those of the rounded control points
    const int dim = state.start().dim();
    std::vector<LocalEquations> all = all_equations(state, conditions, tolerance);
    check_influence(state, all);
    const LinearSystem system(state, all);
    std::vector<double> solution, moves;
    for (int round = 0; round < rounds; ++round) {
        const std::vector<double> more = system.solve(all);
        solution.resize(more.size(), 0.0);
        std::transform(solution.begin(), solution.end(), more.begin(), solution.begin(), std::plus<>());
        moves = system.moves(solution);
        divide_by_root(moves, state.columns().point_costs, static_cast<size_t>(dim));
        state.set(moves, {});
        all = all_equations(state, conditions, tolerance);
    }
    if (worst_missed(all) >= 0) {
        fail_missed(Status::contradiction, all);
    }
    return {state.spline(), lengths(all), system.rank(), largest_move(moves, dim),
            system.optimality(solution)};
}

} // namespace nrb::modify
