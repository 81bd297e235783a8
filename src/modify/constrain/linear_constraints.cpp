// SPDX-License-Identifier: MIT
#include "modify/constrain/linear_constraints.h"

#include "modify/constrain/scaling.h"
#include "numeric/solvers/sparse/minimum_norm.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>

namespace nrb::modify {

namespace {

// The linear equations for fixed weights, in the scaled moves. If all conditions are values, a row holds the
// basis functions and serves all coordinates; otherwise each equation has a row of its own over all
// coordinates.
class LinearSystem {
public:
    LinearSystem(const NetState &state, const std::vector<LocalEquations> &all)
        : dim_(state.start().dim()), columns_(state.columns()) {
        const auto is_value = [this](const LocalEquations &local) {
            return local.functions.size() == 1 && std::ssize(local.residual) == dim_;
        };
        width_ = std::all_of(all.begin(), all.end(), is_value) ? dim_ : 1;
        SparseRows rows;
        for (const LocalEquations &local : all) {
            if (width_ == dim_) {
                add_row(local, nullptr, rows);
            } else {
                add_rows(local, rows);
            }
        }
        const int64_t points = std::ssize(columns_.point_costs), unknowns = points * dim_ / width_;
        solver_ = std::make_unique<MinimumNorm>(rows, unknowns,
                                                pivot_threshold(state.start(), lengths_.size(), points));
    }

    [[nodiscard]] int64_t rank() const noexcept { return solver_->rank() * width_; }
    // The shortest scaled moves [columns][dim] that cancel the residuals.
    [[nodiscard]] std::vector<double> solve(const std::vector<LocalEquations> &all) const {
        std::vector<double> right;
        for (const LocalEquations &local : all) {
            for (const double residual : local.residual) {
                right.push_back(-residual / lengths_[right.size() / static_cast<size_t>(width_)]);
            }
        }
        return solver_->solve(right, width_);
    }
    // The part of the moves that is no combination of the equations: |x - A^T lambda| / |x| for the closest
    // lambda.
    [[nodiscard]] double optimality(const std::vector<double> &moves) const {
        const auto width = static_cast<size_t>(width_);
        double rest = 0;
        std::vector<double> component(moves.size() / width);
        for (size_t c = 0; c < width; ++c) {
            for (size_t i = 0; i < component.size(); ++i) {
                component[i] = moves[i * width + c];
            }
            rest = std::hypot(rest, solver_->multipliers(component).rest);
        }
        return rest == 0 ? 0 : rest / length_of(moves);
    }

private:
    // A row for each equation of a condition; each is linear in one derivative.
    void add_rows(const LocalEquations &local, SparseRows &rows) {
        const size_t width = local.functions.size() * static_cast<size_t>(dim_);
        for (size_t k = 0; k < local.residual.size(); ++k) {
            add_row(local, local.jacobian.data() + k * width, rows);
        }
    }

    // `jacobian` is [derivatives][dim] of the equation; null: a row of the functions themselves.
    void add_row(const LocalEquations &local, const double *jacobian, SparseRows &rows) {
        for (const std::vector<double> &functions : local.functions) {
            for (size_t i = 0; i < local.points.size(); ++i) {
                const int64_t column = columns_.points[static_cast<size_t>(local.points[i])];
                if (column < 0) {
                    continue;
                }
                const double value =
                    functions[i] / std::sqrt(columns_.point_costs[static_cast<size_t>(column)]);
                for (int c = 0; jacobian != nullptr && c < dim_; ++c) {
                    rows.add(column * dim_ + c, value * jacobian[c]);
                }
                if (jacobian == nullptr) {
                    rows.add(column, value);
                }
            }
            jacobian = jacobian == nullptr ? nullptr : jacobian + dim_;
        }
        const double length = rows.end_row();
        lengths_.push_back(length > 0 ? length : 1);
    }

    int dim_;
    const Columns &columns_;
    int width_ = 1;               // coordinates that share a row
    std::vector<double> lengths_; // of the rows
    std::unique_ptr<MinimumNorm> solver_;
};

} // namespace

Constrained solve_linear(NetState &state, const std::vector<Condition> &conditions, double tolerance) {
    constexpr int rounds = 3; // residuals are computed from the rounded control points
    const int dim = state.start().dim();
    std::vector<LocalEquations> all = all_equations(state, conditions, tolerance);
    check_influence(state, all);
    const LinearSystem system(state, all);
    std::vector<double> scaled, moves;
    for (int round = 0; round < rounds; ++round) {
        const std::vector<double> more = system.solve(all);
        scaled.resize(more.size(), 0.0);
        std::transform(scaled.begin(), scaled.end(), more.begin(), scaled.begin(), std::plus<>());
        moves = scaled;
        divide_by_root(moves, state.columns().point_costs, static_cast<size_t>(dim));
        state.set(moves, {});
        all = all_equations(state, conditions, tolerance);
    }
    if (worst_missed(all) >= 0) {
        fail_missed(Status::contradiction, all);
    }
    return {state.spline(), lengths(all), system.rank(), largest_move(moves, dim), system.optimality(scaled)};
}

} // namespace nrb::modify
