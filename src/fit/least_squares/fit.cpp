// SPDX-License-Identifier: MIT
#include "fit/least_squares/fit.h"

#include "base/error.h"
#include "base/representable.h"
#include "base/watch.h"
#include "fit/least_squares/clamped_axes.h"
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

int highest_degree(const Axes &axes) noexcept {
    int highest = 0;
    for (const KnotVectorPtr &axis : axes) {
        highest = std::max(highest, axis->degree());
    }
    return highest;
}

// None without smoothing, and for a constant, which pays nothing.
std::optional<StencilMatrix> penalty_for(const Axes &axes, const FitWishes &wishes) {
    if (wishes.smoothing == Smoothing::none) {
        return std::nullopt;
    }
    if (const int highest = highest_degree(axes); wishes.penalty_order > highest) {
        fail(Status::order, "options: penalty_order = %d, expected at most %d, the highest degree",
             wishes.penalty_order, highest);
    }
    std::optional<StencilMatrix> form = penalty(axes, wishes.penalty_order);
    if (!(form->trace().high > 0)) {
        form.reset();
    }
    return form;
}

// The minimum of the data alone that has the smallest penalty, from factors of G + lambda P for a small lambda: steps to the
// former leave what the data do not tell as the first one found it.
PenalisedSystem::Numbers settled(const NormalEquations &equations, PenalisedSystem &system) {
    constexpr double enough = 0x1p-56;
    constexpr int most = 60;
    PenalisedSystem::Numbers x(equations.right.size()), rest = equations.right;
    for (int step = 0; step < most; ++step) {
        const PenalisedSystem::Numbers change = system.solve(rest, equations.dim);
        double size = 0, moved = 0;
        for (size_t i = 0; i < x.size(); ++i) {
            x[i] = x[i] + change[i];
            size = std::max(size, std::abs(x[i].high));
            moved = std::max(moved, std::abs(change[i].high));
        }
        if (!(moved > enough * size)) {
            break;
        }
        rest = system.missing(x);
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

// What is known after the control points.
void complete(PenalisedSystem &system, const Conditions &conditions, int dim, Smoothed &found) {
    found.residual = system.relative_residual(found.x);
    if (!conditions.empty()) {
        conditions.impose(system, dim, found.x);
    }
    found.squares = system.remaining_squares(found.x);
}

Smoothed solved(const NormalEquations &equations, const StencilMatrix *form, const FitWishes &wishes,
                const Conditions &conditions) {
    PenalisedSystem system(equations, form);
    Smoothed found;
    if (form != nullptr) {
        LambdaSearch search(equations, *form, system, free_unknowns(equations.axes, wishes.penalty_order));
        found = search.choose(wishes.smoothing, wishes.value);
    } else {
        system.factorise(0);
        found.x = system.solve(equations.right, equations.dim);
        found.freedom = static_cast<double>(equations.matrix.size());
    }
    complete(system, conditions, equations.dim, found);
    return found;
}

// The penalty of the highest order that decides, if the data do not: that of values always does.
Smoothed regularised(const NormalEquations &equations, const FitWishes &wishes,
                     const Conditions &conditions) {
    constexpr double part = 0x1p-30;
    PenalisedSystem alone(equations, nullptr);
    if (alone.try_factorise(0) < 0) {
        Smoothed found;
        found.x = alone.solve(equations.right, equations.dim);
        found.freedom = static_cast<double>(equations.matrix.size());
        complete(alone, conditions, equations.dim, found);
        return found;
    }
    const double trace = equations.matrix.trace().high, scale = part * (trace > 0 ? trace : 1);
    Smoothed found;
    for (int order = std::min(wishes.penalty_order, highest_degree(equations.axes)); order >= 0; --order) {
        const StencilMatrix form = penalty(equations.axes, order);
        const double size = form.trace().high;
        PenalisedSystem system(equations, &form);
        if (size > 0 && system.try_factorise(scale / size) < 0) {
            found.x = settled(equations, system);
            found.freedom = system.freedom();
            complete(system, conditions, equations.dim, found);
            found.residual = 0;
            return found;
        }
    }
    fail(Status::rank, "the data do not determine the control points, whatever is penalised");
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

Fitted fit(const Statistics &statistics, const Axes &wanted, const FitWishes &given) {
    const StatisticsForm &units = statistics.form();
    const Axes axes = clamped_axes(wanted);
    const FitWishes wishes = scaled(given, units);
    const std::optional<StencilMatrix> form = penalty_for(axes, wishes);
    const NormalEquations data = normal_equations(statistics, axes);
    const Conditions conditions(axes, wishes.conditions);
    std::optional<NormalEquations> with_conditions;
    if (!conditions.empty()) {
        conditions.add_squares(with_conditions.emplace(data));
    }
    const NormalEquations &equations = with_conditions ? *with_conditions : data;
    const Smoothed found = wishes.regularise && wishes.smoothing == Smoothing::none
                               ? regularised(equations, wishes, conditions)
                               : solved(equations, form ? &*form : nullptr, wishes, conditions);
    Fitted result{};
    result.spline = over_axes(spline_of(data, found.x, units.value_exponent), wanted);
    result.weight = std::ldexp(data.weight.high, units.weight_exponent);
    result.squares = std::ldexp(found.squares, units.weight_exponent + 2 * units.value_exponent);
    result.lambda = std::ldexp(found.lambda, units.weight_exponent);
    result.freedom = found.freedom;
    result.residual = found.residual;
    result.reached = found.reached;
    return result;
}

} // namespace nrb::fit
