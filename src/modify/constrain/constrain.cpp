// SPDX-License-Identifier: MIT
#include "modify/constrain/constrain.h"

#include "base/watch.h"
#include "modify/constrain/equations.h"
#include "modify/constrain/linear_constraints.h"
#include "modify/constrain/programming.h"
#include "spline/near_one.h"

#include <algorithm>
#include <cmath>

namespace nrb::modify {

namespace {

// The conditions of a curve, restated for the same curve multiplied by powers of two.
class ScaledConditions {
public:
    ScaledConditions(const Spline &curve, const std::vector<Condition> &conditions, const Powers &powers)
        : size_(powers.size(curve)), knots_(powers.knots[0]), dim_(curve.dim()),
          numbers_(conditions.size() * static_cast<size_t>(1 + dim_)) {
        double *at = numbers_.data();
        for (const Condition &condition : conditions) {
            const double *const param = at;
            *at++ = std::ldexp(*condition.param(), knots_);
            const bool direction =
                condition.kind() == constrain_direction || condition.kind() == constrain_normal;
            for (int c = 0; c < dim_; ++c) {
                at[c] = std::ldexp(condition.target()[c], direction ? 0 : power(condition));
            }
            scaled_.emplace_back(condition.kind(), condition.derivatives()[0], param, at, 1, dim_);
            at += dim_;
        }
    }

    [[nodiscard]] const std::vector<Condition> &conditions() const noexcept { return scaled_; }
    // The power of two by which the left side of a condition is multiplied.
    [[nodiscard]] int power(const Condition &condition) const noexcept {
        return condition.kind() == constrain_curvature ? -size_
                                                       : size_ - knots_ * condition.derivatives()[0][0];
    }

private:
    int size_;
    int knots_;
    int dim_;
    std::vector<double> numbers_;
    std::vector<Condition> scaled_;
};

Constrained constrained(const Spline &spline, const std::vector<Condition> &conditions,
                        const Columns &columns, double tolerance) {
    NetState state(spline, columns);
    if (columns.point_costs.empty() && columns.weight_costs.empty()) {
        check_influence(state, all_equations(state, conditions, tolerance)); // throws: nothing may change
    }
    const bool linear = std::all_of(conditions.begin(), conditions.end(),
                                    [](const Condition &condition) { return condition.linear(); });
    return linear && columns.weight_costs.empty() ? solve_linear(state, conditions, tolerance)
                                                  : solve_by_programming(state, conditions, tolerance);
}

// The control points that act on the conditions of a curve, for which scaling matters; others may be of any
// size.
std::vector<int64_t> seen_places(const Spline &curve, const std::vector<Condition> &conditions) {
    std::vector<int64_t> places;
    const KnotVector &axis = curve.axis(0);
    for (const Condition &condition : conditions) {
        const int64_t span = axis.find_span(*condition.param(), false);
        for (int64_t i = span - axis.degree(); i <= span; ++i) {
            if (curve.weight(i) != 0) {
                places.push_back(i);
            }
        }
    }
    return places;
}

} // namespace

Constrained constrain(const Spline &spline, const std::vector<Condition> &conditions, const ChangeRule &rule,
                      double tolerance) {
    const UsualLimit usual(usual_work(spline.point_count() + std::ssize(conditions), 200000));
    const Columns columns = make_columns(spline, conditions, rule);
    // Curvatures, which occur for curves only, contain squares of lengths; these curves are brought near 1 in
    // size. That is not possible if weights may change, because moves and changes of weights have no common
    // scale.
    const bool squares = std::any_of(conditions.begin(), conditions.end(),
                                     [](const Condition &condition) { return !condition.linear(); });
    const Powers powers = squares && columns.weight_costs.empty()
                              ? powers_near_one(spline, 1, seen_places(spline, conditions))
                              : Powers{};
    if (powers == Powers{}) {
        return constrained(spline, conditions, columns, tolerance);
    }
    const int size = powers.size(spline);
    const ScaledConditions scaled_conditions(spline, conditions, powers);
    const SplinePtr near = near_one(spline, powers);
    Constrained made =
        constrained(*near, scaled_conditions.conditions(), columns, std::ldexp(tolerance, size));
    made.spline = scaled_back(*made.spline, *near, spline, powers);
    made.moved = std::ldexp(made.moved, -size);
    for (size_t i = 0; i < conditions.size(); ++i) {
        made.residuals[i] = std::ldexp(made.residuals[i], -scaled_conditions.power(conditions[i]));
    }
    return made;
}

} // namespace nrb::modify
