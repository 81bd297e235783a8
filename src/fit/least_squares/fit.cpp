// SPDX-License-Identifier: MIT
#include "fit/least_squares/fit.h"

#include "base/error.h"
#include "base/representable.h"
#include "fit/constraints/shaped_fit.h"
#include "fit/least_squares/clamped_axes.h"
#include "fit/least_squares/penalty.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>

namespace nrb::fit {

namespace {

using Axes = std::vector<KnotVectorPtr>;

// Nothing without smoothing, and where the penalty vanishes because the spline can only be constant.
std::optional<StencilMatrix> penalty_for(const Axes &axes, const FitWishes &wishes, const Index &reach) {
    if (wishes.smoothing == Smoothing::none) {
        return std::nullopt;
    }
    if (const int highest = highest_degree(axes); wishes.penalty_order > highest) {
        fail(Status::order, "options: penalty_order = %d, expected at most %d, the highest degree",
             wishes.penalty_order, highest);
    }
    std::optional<StencilMatrix> form = penalty(axes, wishes.penalty_order, reach);
    if (!(form->trace().high > 0)) {
        form.reset();
    }
    return form;
}

// The minimum of the data term alone that has the smallest penalty, by iterated Tikhonov regularisation with
// factors of G + lambda P for a small lambda: the steps converge to a minimum of the data term, and leave
// what the data do not determine as the first solution has it.
PenalisedSystem::Numbers settled(const NormalEquations &equations, PenalisedSystem &system) {
    constexpr double enough = 0x1p-56;
    constexpr int64_t many = 500;
    const int most = equations.matrix.size() > many ? 4 : 20;
    PenalisedSystem::Numbers x(equations.right.size()), rest = equations.right;
    for (int step = 0; step < most; ++step) {
        const PenalisedSystem::Numbers change = system.solve(rest, equations.dim);
        std::transform(x.begin(), x.end(), change.begin(), x.begin(), std::plus<>());
        if (!(largest_of(change) > enough * largest_of(x))) {
            break;
        }
        rest = system.missing(x);
    }
    return x;
}

SplinePtr spline_of(const NormalEquations &equations, const std::vector<DoubleDouble> &x, int exponent) {
    const auto dim = static_cast<size_t>(equations.dim);
    Index counts{1, 1, 1};
    for (size_t k = 0; k < equations.axes.size(); ++k) {
        counts[k] = equations.axes[k]->count();
    }
    std::vector<double> points;
    for_each_index({}, counts, [&](const Index &layer) {
        const auto unknown = static_cast<size_t>(equations.matrix.unknown(layer));
        for (size_t c = 0; c < dim; ++c) {
            points.push_back(std::ldexp(x[unknown * dim + c].high, exponent));
        }
    });
    require_representable(points, "control points");
    return make_result(equations.axes, equations.dim, Form::polynomial, std::move(points));
}

// What can be computed once the control points are known.
void complete(PenalisedSystem &system, const Conditions &conditions, int dim, Smoothed &found) {
    found.residual = system.relative_residual(found.x);
    if (!conditions.empty()) {
        found.freedom = std::max(0.0, found.freedom - conditions.impose(system, dim, found.x));
    }
    found.squares = system.remaining_squares(found.x);
}

Smoothed plain(const NormalEquations &equations, const Conditions &conditions) {
    PenalisedSystem system(equations, nullptr);
    Smoothed found;
    system.factorise(0);
    found.x = system.solve(equations.right, equations.dim);
    found.freedom = static_cast<double>(equations.matrix.size());
    complete(system, conditions, equations.dim, found);
    return found;
}

// What is asked of a fit besides its data.
struct Question {
    const FitWishes &wishes;
    const Conditions &conditions;
    Index reach; // of the shape constraints
};

Smoothed solved(const NormalEquations &equations, const StencilMatrix *form, const Question &asked,
                int64_t lacking) {
    if (form == nullptr && lacking < 0) {
        return plain(equations, asked.conditions);
    }
    PenalisedSystem system(equations, form);
    if (form == nullptr) {
        system.fail_rank(lacking);
    }
    LambdaSearch search(equations, *form, asked.wishes.penalty_order, system);
    Smoothed found = search.choose(asked.wishes.smoothing, asked.wishes.value);
    complete(system, asked.conditions, equations.dim, found);
    return found;
}

// Nothing where the equations do not determine the solution, which may show only while they are solved.
template <class Solve>
std::optional<Smoothed> if_determined(Solve &&solve) {
    try {
        return solve();
    } catch (const Error &error) {
        if (error.status() != Status::rank) {
            throw;
        }
        return std::nullopt;
    }
}

// A factor so small that the penalty decides only what the data leave open; 0 for a penalty that vanishes.
double small_factor(const NormalEquations &equations, const StencilMatrix &form) noexcept {
    constexpr double part = 0x1p-20;
    const double trace = equations.matrix.trace().high, size = form.trace().high;
    return size > 0 ? part * (trace > 0 ? trace : 1) / size : 0;
}

Smoothed least_penalty(const NormalEquations &equations, const Question &asked, int order) {
    const StencilMatrix form = penalty(equations.axes, order, asked.reach);
    const double factor = small_factor(equations, form);
    PenalisedSystem system(equations, &form);
    const int64_t unsure = factor > 0 ? system.try_factorise_surely(factor) : 0;
    if (unsure >= 0) {
        system.fail_rank(unsure);
    }
    Smoothed found;
    found.decided_by = order;
    found.x = settled(equations, system);
    found.freedom = std::round(system.freedom().value); // trace of a projection but for the small penalty
    complete(system, asked.conditions, equations.dim, found);
    found.residual = 0;
    return found;
}

// If the data do not determine the control points, the penalty of the highest order that does decides; that
// of values (order 0) always does.
Smoothed regularised(const NormalEquations &equations, const Question &asked, int64_t lacking) {
    std::optional<Smoothed> found;
    if (lacking < 0) {
        found = if_determined([&] { return plain(equations, asked.conditions); });
    }
    const int highest = std::min(asked.wishes.penalty_order, highest_degree(equations.axes));
    for (int order = highest; !found && order >= 0; --order) {
        found = if_determined([&] { return least_penalty(equations, asked, order); });
    }
    if (found) {
        return std::move(*found);
    }
    fail(Status::rank, "the data do not determine the control points, whatever is penalised");
}

// For a curve, the first control point that is left without a datum if each control point in turn takes the
// first free datum in its support. This is the Schoenberg-Whitney condition, as far as the numbers of data in
// the cells show (data of equal parameters count as different ones). For other splines only the total number
// of data is compared. -1: none.
int64_t first_without_datum(const Statistics &statistics, const NormalEquations &equations) {
    const Axes &axes = equations.axes;
    if (axes.size() > 1 || axes[0]->periodic()) {
        return statistics.data_count() < equations.matrix.size() ? 0 : -1;
    }
    const KnotVector &axis = *axes[0], &breaks = *statistics.form().breaks[0];
    size_t cell = 0;
    int64_t taken = 0; // of the data in that cell
    const auto cells = statistics.cells();
    for (int64_t i = 0; i < axis.count(); ++i) {
        while (cell < cells.size() &&
               (taken == statistics.counts()[cell] || breaks[cells[cell] + 1] <= axis[i])) {
            ++cell;
            taken = 0;
        }
        if (cell == cells.size() || breaks[cells[cell]] >= axis[i + axis.degree() + 1]) {
            return i;
        }
        ++taken;
    }
    return -1;
}

// The smallest penalty decides what the data leave open, where that is wanted.
Smoothed wanted_fit(const NormalEquations &equations, const StencilMatrix *form, const Question &asked,
                    int64_t lacking) {
    const bool regularise = asked.wishes.regularise;
    if (regularise && asked.wishes.smoothing == Smoothing::none) {
        return regularised(equations, asked, lacking);
    }
    try {
        return solved(equations, form, asked, lacking);
    } catch (const Error &error) {
        if (!regularise || error.status() != Status::rank) {
            throw;
        }
        return regularised(equations, asked, lacking);
    }
}

// Among the minima of the data term that have the shape, one with a small penalty, by the proximal point
// method. It penalises the change from the last solution until that change is 0, and so decides without any
// cost for the data term (R. Rockafellar, "Monotone operators and the proximal point algorithm", SIAM J.
// Control Optim. 14 (1976)).
void shape_decided(const NormalEquations &data, const NormalEquations &equations, const StencilMatrix &form,
                   const Question &asked, Smoothed &found) {
    constexpr double small = 0x1p-20; // beside the factor that factorisations need
    constexpr double enough = 0x1p-48;
    constexpr int most = 4;
    const double factor = small * small_factor(equations, form);
    NormalEquations from = equations;
    PenalisedSystem penalty(equations, nullptr);
    penalty.set_matrix(form);
    for (int step = 0; step < most; ++step) {
        std::vector<DoubleDouble> change = found.x;
        impose_shape(data, from, &form, factor, asked.conditions.rows(), asked.wishes.shape, found);
        std::transform(found.x.begin(), found.x.end(), change.begin(), change.begin(), std::minus<>());
        found.settled = step > 0 && !(largest_of(change) > enough * largest_of(found.x));
        if (found.settled) {
            break;
        }
        const std::vector<DoubleDouble> pull =
            penalty.product(found.x, equations.dim); // towards the last solution
        for (size_t i = 0; i < pull.size(); ++i) {
            from.right[i] = equations.right[i] + DoubleDouble(factor) * pull[i];
        }
    }
    found.freedom = std::round(found.freedom * equations.dim) / equations.dim; // of projections
}

// Imposes the shape, with the penalty that decided where the data alone do not decide.
void shape(const NormalEquations &data, const NormalEquations &equations, const StencilMatrix *form,
           const Question &asked, Smoothed &found) {
    if (found.decided_by < 0) {
        impose_shape(data, equations, form, found.lambda, asked.conditions.rows(), asked.wishes.shape, found);
        return;
    }
    const StencilMatrix deciding = penalty(equations.axes, found.decided_by, asked.reach);
    shape_decided(data, equations, deciding, asked, found);
}

// The wishes in units of the scales, which are those of the equations.
FitWishes scaled(FitWishes wishes, const StatisticsForm &form) {
    wishes.value = std::ldexp(wishes.value, wishes.smoothing == Smoothing::discrepancy
                                                ? -form.weight_exponent - 2 * form.value_exponent
                                                : -form.weight_exponent);
    const auto scale = [&form](std::vector<double> &values) {
        for (double &value : values) {
            value = std::ldexp(value, -form.value_exponent);
        }
    };
    for (FitCondition &condition : wishes.conditions) {
        scale(condition.target);
    }
    scale(wishes.shape.lower);
    scale(wishes.shape.upper);
    return wishes;
}

} // namespace

Fitted fit(const Statistics &statistics, const Axes &wanted, const FitWishes &given) {
    const StatisticsForm &units = statistics.form();
    const Axes axes = clamped_axes(wanted);
    check_shape(axes, units.dim, given.shape);
    const FitWishes wishes = scaled(given, units);
    const Index reach = shape_reach(axes, wishes.shape);
    const std::optional<StencilMatrix> form = penalty_for(axes, wishes, reach);
    const NormalEquations data = normal_equations(statistics, axes, reach);
    Conditions conditions(axes, wishes.conditions);
    std::optional<NormalEquations> with_conditions;
    if (!conditions.empty()) {
        conditions.add_squares(with_conditions.emplace(data));
    }
    const NormalEquations &equations = with_conditions ? *with_conditions : data;
    const int64_t lacking = conditions.empty() ? first_without_datum(statistics, data) : -1;
    const Question asked{wishes, conditions, reach};
    Smoothed found = wanted_fit(equations, form ? &*form : nullptr, asked, lacking);
    if (!wishes.shape.empty()) {
        shape(data, equations, form ? &*form : nullptr, asked, found);
    }
    Fitted result{};
    result.spline = over_axes(spline_of(data, found.x, units.value_exponent), wanted);
    result.misfit = {data.weight.high, found.squares, units.weight_exponent, units.value_exponent};
    result.lambda = std::ldexp(found.lambda, units.weight_exponent);
    result.freedom = found.freedom;
    result.residual = found.residual;
    result.reached = found.reached;
    result.settled = found.settled;
    return result;
}

} // namespace nrb::fit
