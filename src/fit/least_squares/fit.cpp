// SPDX-License-Identifier: MIT
#include "fit/least_squares/fit.h"

#include "base/error.h"
#include "base/representable.h"
#include "base/watch.h"
#include "fit/least_squares/penalty.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace nrb::fit {

namespace {

using Axes = std::vector<KnotVectorPtr>;

// How many unknowns no penalty determines: on each axis those of the polynomials below its order, of a periodic one constants.
double free_unknowns(const Axes &axes, int order) noexcept {
    double free = 1;
    for (const KnotVectorPtr &axis : axes) {
        free *= order > axis->degree() ? static_cast<double>(axis->distinct_layers())
                : axis->periodic()     ? 1
                                       : order;
    }
    return free;
}

std::optional<StencilMatrix> penalty_for(const Axes &axes, const FitWishes &wishes) {
    int highest = 0;
    for (const KnotVectorPtr &axis : axes) {
        highest = std::max(highest, axis->degree());
    }
    if (wishes.smoothing == Smoothing::none && !wishes.regularise) {
        return std::nullopt;
    }
    if (wishes.smoothing != Smoothing::none && wishes.penalty_order > highest) {
        fail(Status::order, "penalty_order = %d, expected at most %d, the highest degree", wishes.penalty_order,
             highest);
    }
    const int order = std::min(wishes.penalty_order, highest);
    std::optional<StencilMatrix> form;
    if (order > 0 && !(form.emplace(penalty(axes, order)).trace().high > 0)) {
        form.reset(); // a constant
    }
    return form;
}

// The minimum with the smallest penalty: with factors of G + lambda P for a small lambda, steps to the minimum of the data
// alone leave what the data do not tell as the first one found it.
std::vector<DoubleDouble> regularised(const NormalEquations &equations, const StencilMatrix &penalty,
                                      PenalisedSystem &system) {
    constexpr double part = 0x1p-30, enough = 0x1p-56;
    constexpr int most = 60;
    const double trace = equations.matrix.trace().high;
    system.factorise(part * (trace > 0 ? trace : 1) / penalty.trace().high);
    std::vector<DoubleDouble> x(equations.right.size()), residual = equations.right;
    for (int step = 0; step < most; ++step) {
        const std::vector<DoubleDouble> change = system.solve(residual, equations.dim);
        double size = 0, moved = 0;
        for (size_t i = 0; i < x.size(); ++i) {
            x[i] = x[i] + change[i];
            size = std::max(size, std::abs(x[i].high));
            moved = std::max(moved, std::abs(change[i].high));
        }
        if (!(moved > enough * size)) {
            break;
        }
        residual = system.missing(x);
    }
    return x;
}

SplinePtr spline_of(const NormalEquations &equations, const std::vector<DoubleDouble> &x, int exponent) {
    const auto dim = static_cast<size_t>(equations.dim);
    Index end{1, 1, 1}, layer{};
    for (size_t k = 0; k < equations.axes.size(); ++k) {
        end[k] = equations.axes[k]->count();
    }
    std::vector<double> points;
    for (layer[0] = 0; layer[0] < end[0]; ++layer[0]) {
        for (layer[1] = 0; layer[1] < end[1]; ++layer[1]) {
            for (layer[2] = 0; layer[2] < end[2]; ++layer[2]) {
                const auto unknown = static_cast<size_t>(equations.matrix.unknown(layer));
                for (size_t c = 0; c < dim; ++c) {
                    points.push_back(std::ldexp(x[unknown * dim + c].high, exponent));
                }
            }
        }
    }
    require_representable(points, "control points");
    return make_result(equations.axes, equations.dim, Form::polynomial, std::move(points));
}

Smoothed solved(const NormalEquations &equations, const StencilMatrix *form, const FitWishes &wishes,
                const Conditions &conditions) {
    PenalisedSystem system(equations, form);
    Smoothed found;
    if (form != nullptr && wishes.smoothing != Smoothing::none) {
        LambdaSearch search(equations, *form, system, free_unknowns(equations.axes, wishes.penalty_order));
        found = search.choose(wishes.smoothing, wishes.value);
    } else if (form != nullptr) {
        found.x = regularised(equations, *form, system);
        found.freedom = static_cast<double>(equations.matrix.size());
    } else {
        system.factorise(0);
        found.x = system.solve(equations.right, equations.dim);
        found.freedom = static_cast<double>(equations.matrix.size());
    }
    found.residual = form != nullptr && wishes.smoothing == Smoothing::none ? 0 : system.relative_residual(found.x);
    if (!conditions.empty()) {
        conditions.impose(system, equations.dim, found.x);
    }
    found.squares = system.remaining_squares(found.x);
    return found;
}

// In units of the scales, as equations are.
FitWishes scaled(FitWishes wishes, const StatisticsForm &form) {
    wishes.value = std::ldexp(wishes.value, wishes.smoothing == Smoothing::discrepancy
                                                ? -form.weight_exponent - 2 * form.value_exponent
                                                : -form.weight_exponent);
    for (FitCondition &condition : wishes.conditions) {
        for (double &target : condition.target) {
            target = std::ldexp(target, -form.value_exponent);
        }
    }
    return wishes;
}

} // namespace

Fitted fit(const Statistics &statistics, const Axes &axes, const FitWishes &given) {
    const StatisticsForm &units = statistics.form();
    const FitWishes wishes = scaled(given, units);
    const std::optional<StencilMatrix> form = penalty_for(axes, wishes);
    const NormalEquations data = normal_equations(statistics, axes);
    const Conditions conditions(axes, wishes.conditions);
    std::optional<NormalEquations> with_conditions;
    if (!conditions.empty()) {
        conditions.add_squares(with_conditions.emplace(data));
    }
    const NormalEquations &equations = with_conditions ? *with_conditions : data;
    const Smoothed found = solved(equations, form ? &*form : nullptr, wishes, conditions);
    Fitted result{};
    result.spline = spline_of(data, found.x, units.value_exponent);
    result.weight = std::ldexp(data.weight.high, units.weight_exponent);
    result.squares = std::ldexp(found.squares, units.weight_exponent + 2 * units.value_exponent);
    result.lambda = std::ldexp(found.lambda, units.weight_exponent);
    result.freedom = found.freedom;
    result.residual = found.residual;
    result.reached = found.reached;
    return result;
}

} // namespace nrb::fit
