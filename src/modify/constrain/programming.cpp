// SPDX-License-Identifier: MIT
#include "modify/constrain/programming.h"

#include "base/checked.h"
#include "base/finite.h"
#include "base/watch.h"
#include "modify/constrain/scaling.h"
#include "numeric/norm.h"
#include "numeric/solvers/conjugate_gradients.h"
#include "numeric/solvers/sparse/minimum_norm.h"

#include <algorithm>
#include <cmath>
#include <functional>

namespace nrb::modify {

namespace {

// All equations linearised: rows over the scaled moves and relative changes of weights, each row of length 1.
struct Linearised {
    SparseRows rows;
    std::vector<double> scale; // the factor that gives each row this length
    std::vector<double> residual;
};

class Programming {
public:
    Programming(NetState &state, const std::vector<Condition> &conditions, double tolerance)
        : state_(state), conditions_(conditions), tolerance_(tolerance), columns_(state.columns()),
          dim_(static_cast<size_t>(state.start().dim())), moves_(columns_.point_costs.size() * dim_),
          unknowns_(moves_ + columns_.weight_costs.size()), x_(unknowns_, 0.0) {}

    Constrained run() {
        all_ = all_equations(state_, conditions_, tolerance_);
        check_influence(state_, all_);
        for (int step = 0; step < max_steps; ++step) {
            if (advance()) {
                break;
            }
            check_weights();
        }
        return finish();
    }

private:
    static constexpr int max_steps = 300;
    static constexpr double enough = 1e-10;   // relative length of a negligible step
    static constexpr double vanishing = 1e-9; // part of its first value that a weight must keep
    static constexpr double optimal = 1e-6;   // the optimality required of a minimum

    [[nodiscard]] int64_t equation_count() const noexcept {
        int64_t count = 0;
        for (const Condition &condition : conditions_) {
            count += condition.equations();
        }
        return count;
    }

    [[nodiscard]] Linearised linearised() const {
        Linearised system;
        for (const LocalEquations &local : all_) {
            for (size_t k = 0; k < local.residual.size(); ++k) {
                for_each_element(local, k, [&](size_t column, double value) {
                    system.rows.add(static_cast<int64_t>(column), value);
                });
                const double size = system.rows.end_row(), scale = size > 0 ? 1 / size : 1;
                system.scale.push_back(scale);
                system.residual.push_back(local.residual[k] * scale);
            }
        }
        return system;
    }

    // Calls visit(unknown, value) for the coefficients of equation k of a condition.
    template <class Visit>
    void for_each_element(const LocalEquations &local, size_t k, Visit &&visit) const {
        const size_t derivatives = local.functions.size();
        for (size_t d = 0; d < derivatives; ++d) {
            const double *const along = local.jacobian.data() + (k * derivatives + d) * dim_;
            for (size_t i = 0; i < local.points.size(); ++i) {
                const auto point = static_cast<size_t>(local.points[i]);
                if (const int64_t column = columns_.points[point]; column >= 0) {
                    const auto at = static_cast<size_t>(column);
                    const double scale = local.functions[d][i] / std::sqrt(columns_.point_costs[at]);
                    for (size_t c = 0; c < dim_; ++c) {
                        visit(at * dim_ + c, along[c] * scale);
                    }
                }
                if (const int64_t column = columns_.weights[point]; column >= 0) {
                    const auto at = static_cast<size_t>(column);
                    for (size_t c = 0; c < dim_; ++c) {
                        visit(moves_ + at, along[c] * local.slopes[d][i * dim_ + c] /
                                               std::sqrt(columns_.weight_costs[at]));
                    }
                }
            }
        }
    }

    void split(const std::vector<double> &x, std::vector<double> &moves, std::vector<double> &changes) const {
        moves.assign(x.begin(), x.begin() + static_cast<int64_t>(moves_));
        changes.assign(x.begin() + static_cast<int64_t>(moves_), x.end());
        divide_by_root(moves, columns_.point_costs, dim_);
        divide_by_root(changes, columns_.weight_costs, 1);
    }

    void move_to(const std::vector<double> &x) {
        std::vector<double> moves, changes;
        split(x, moves, changes);
        state_.set(moves, changes);
        all_ = all_equations(state_, conditions_, tolerance_);
    }

    // The largest fraction of a step, at most 1, that leaves every weight at least a tenth of its value.
    [[nodiscard]] double longest_step(const std::vector<double> &step) const {
        std::vector<double> moves, changes, before, old;
        split(step, moves, changes);
        split(x_, before, old);
        double part = 1;
        for (size_t i = 0; i < changes.size(); ++i) {
            if (1 + old[i] + changes[i] < 0.1 * (1 + old[i])) {
                part = std::min(part, 0.9 * (1 + old[i]) / -changes[i]);
            }
        }
        return part;
    }

    // The merit function |x|^2 / 2 + mu |g|_1 at the present state.
    [[nodiscard]] double merit(const std::vector<double> &x, const std::vector<double> &scale) const {
        double sum = 0;
        size_t k = 0;
        for (const LocalEquations &local : all_) {
            for (const double residual : local.residual) {
                sum += std::abs(residual * scale[k++]);
            }
        }
        const double length = length_of(x);
        return length * length / 2 + penalty_ * sum;
    }

    // Makes one step. Returns true, without one, if all conditions are met and the step would be too short to
    // matter.
    bool advance() {
        check_finite(all_);
        const Linearised system = linearised();
        const auto unknowns = static_cast<int64_t>(unknowns_);
        const MinimumNorm solver(system.rows, unknowns,
                                 pivot_threshold(state_.start(), system.residual.size(), unknowns));
        rank_ = solver.rank();
        const std::vector<double> next = solver.solve(right_side(system), 1);
        std::vector<double> step(unknowns_);
        std::transform(next.begin(), next.end(), x_.begin(), step.begin(), std::minus<>());
        const double rest = solver.multipliers(x_).rest;
        optimality_ = rest == 0 ? 0 : rest / length_of(x_);
        if (worst_missed(all_) < 0 && length_of(step) <= enough * length_of(next)) {
            return true;
        }
        const std::vector<double> multipliers = solver.multipliers(next).values;
        const double needed = 2 * largest_magnitude(multipliers); // may decrease (Powell 1978)
        penalty_ = std::max(needed, (penalty_ + needed) / 2);
        const std::vector<double> more = second_order(solver, system, multipliers, step, length_of(next));
        std::transform(step.begin(), step.end(), more.begin(), step.begin(), std::plus<>());
        search(system, step);
        return false;
    }

    // The sum of the multipliers times the gradients of the equations at x, scaled as in a system. Leaves the
    // state at x.
    std::vector<double> weighted_gradient(const std::vector<double> &x, const Linearised &system,
                                          const std::vector<double> &multipliers) {
        std::vector<double> moves, changes, sum(unknowns_, 0.0);
        split(x, moves, changes);
        state_.set(moves, changes);
        size_t k = 0;
        for (const LocalEquations &local : all_equations(state_, conditions_, tolerance_)) {
            for (size_t i = 0; i < local.residual.size(); ++i, ++k) {
                const double factor = multipliers[k] * system.scale[k];
                for_each_element(local, i,
                                 [&](size_t column, double value) { sum[column] += factor * value; });
            }
        }
        return sum;
    }

    // What the second derivatives of the equations add to the step d that the first derivatives make. Let C
    // be the sum of the multipliers times the Hessians of the equations, and P the projection onto the kernel
    // of J. Then it is the z in the kernel with P (1 - C) z = P C d. Products with C are computed as
    // differences of gradients. The result is 0 where 1 - C is not positive definite on the kernel, far from
    // a minimum.
    std::vector<double> second_order(const MinimumNorm &solver, const Linearised &system,
                                     const std::vector<double> &multipliers, const std::vector<double> &d,
                                     double size) {
        constexpr double cube_root_eps = 6e-6, positive = 1e-3;
        constexpr int most = 40;
        const auto curved = [&](const std::vector<double> &v) {
            const double length = length_of(v), h = length > 0 ? cube_root_eps * size / length : 0;
            std::vector<double> difference = weighted_gradient(shifted(h, v), system, multipliers);
            const std::vector<double> other = weighted_gradient(shifted(-h, v), system, multipliers);
            std::transform(difference.begin(), difference.end(), other.begin(), difference.begin(),
                           [h](double x, double y) { return h > 0 ? (x - y) / (2 * h) : 0; });
            return solver.kernel_part(difference);
        };
        const auto product = [&](const std::vector<double> &v) {
            std::vector<double> image = curved(v);
            std::transform(v.begin(), v.end(), image.begin(), image.begin(), std::minus<>());
            return image;
        };
        return conjugate_gradients(product, curved(d), positive, most);
    }

    [[nodiscard]] std::vector<double> shifted(double h, const std::vector<double> &v) const {
        std::vector<double> x(unknowns_);
        std::transform(x_.begin(), x_.end(), v.begin(), x.begin(),
                       [h](double a, double b) { return a + h * b; });
        return x;
    }

    // J x - g, the right side of the linearised equations for the next x.
    [[nodiscard]] std::vector<double> right_side(const Linearised &system) const {
        std::vector<double> right;
        for (size_t k = 0; k < system.residual.size(); ++k) {
            double sum = -system.residual[k];
            const std::span<const int64_t> columns = system.rows.columns(static_cast<int64_t>(k));
            const std::span<const double> values = system.rows.values(static_cast<int64_t>(k));
            for (size_t i = 0; i < columns.size(); ++i) {
                sum += values[i] * x_[static_cast<size_t>(columns[i])];
            }
            right.push_back(sum);
        }
        return right;
    }

    // Line search by halving: goes along a step until the merit function has fallen in proportion to its
    // slope (Armijo).
    void search(const Linearised &system, const std::vector<double> &step) {
        constexpr int halvings = 30;
        constexpr double share = 1e-4, rounding = 1e-14;
        double descent = 0;
        for (size_t i = 0; i < unknowns_; ++i) {
            descent += x_[i] * step[i];
        }
        for (const double residual : system.residual) {
            descent -= penalty_ * std::abs(residual);
        }
        descent = std::min(descent, 0.0);
        const double before = merit(x_, system.scale);
        const std::vector<double> from = x_;
        double part = longest_step(step);
        for (int i = 0; i < halvings; ++i) {
            std::transform(from.begin(), from.end(), step.begin(), x_.begin(),
                           [part](double x, double s) { return x + part * s; });
            move_to(x_);
            if (merit(x_, system.scale) <= before + share * part * descent + rounding * before) {
                return;
            }
            part /= 2;
        }
    }

    [[nodiscard]] Constrained finish() {
        if (worst_missed(all_) >= 0) {
            fail_missed(rank_ < equation_count() ? Status::contradiction : Status::not_converged, all_);
        }
        if (!(optimality_ <= optimal)) {
            fail(Status::not_converged,
                 "the gradient of the Lagrangian is %s after %d steps, expected at most %s",
                 Number(optimality_).text, max_steps, Number(optimal).text);
        }
        std::vector<double> moves, changes;
        split(x_, moves, changes);
        return {state_.spline(), lengths(all_), rank_, largest_move(moves, static_cast<int>(dim_)),
                optimality_};
    }

    // Fails if a weight has shrunk towards 0, which means that positive weights do not suffice.
    void check_weights() const {
        std::vector<double> moves, changes;
        split(x_, moves, changes);
        for (size_t i = 0; i < columns_.weights.size(); ++i) {
            const int64_t column = columns_.weights[i];
            if (column >= 0 && 1 + changes[static_cast<size_t>(column)] < vanishing) {
                fail(Status::weight_sign, "the weight of control point %zu would not be positive", i);
            }
        }
    }

    NetState &state_;
    const std::vector<Condition> &conditions_;
    double tolerance_;
    const Columns &columns_;
    size_t dim_;
    size_t moves_;    // number of scaled coordinates of moves
    size_t unknowns_; // the same, and the number of weights
    std::vector<double> x_;
    std::vector<LocalEquations> all_;
    double penalty_ = 0;
    double optimality_ = 0;
    int64_t rank_ = 0;
};

} // namespace

Constrained solve_by_programming(NetState &state, const std::vector<Condition> &conditions,
                                 double tolerance) {
    return Programming(state, conditions, tolerance).run();
}

} // namespace nrb::modify
