// SPDX-License-Identifier: MIT
#include "fit/least_squares/fit_errors.h"

#include "base/watch.h"
#include "fit/least_squares/active_functions.h"
#include "fit/least_squares/clamped_axes.h"
#include "fit/least_squares/penalty.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace nrb::fit {

namespace {

// The quadratic form of the inverse matrix, of which only the elements for pairs of overlapping functions are
// needed.
class ErrorForm {
public:
    ErrorForm(const std::vector<KnotVectorPtr> &axes, const StencilMatrix &numbers,
              const PenalisedSystem &system)
        : axes_(axes.size()), numbers_(numbers), system_(system), inverse_(system.inverse()),
          functions_(axes), places_(functions_.size()) {}

    // The root of the form at parameters t in the domain, t[k] in span spans[k] of axis k.
    [[nodiscard]] double at(const Index &spans, const std::array<double, max_axes> &t) {
        for (size_t k = 0; k < axes_; ++k) {
            functions_.set(k, spans[k], t[k]);
        }
        functions_.multiply();
        for (size_t i = 0; i < places_.size(); ++i) {
            places_[i] = system_.place_of(numbers_.unknown(functions_.layer(i)));
        }
        return std::sqrt(std::max(0.0, form()));
    }

private:
    [[nodiscard]] double form() const noexcept {
        const std::span<const double> values = functions_.values();
        double sum = 0;
        for (size_t i = 0; i < places_.size(); ++i) {
            sum += values[i] * values[i] * inverse_.element(places_[i], places_[i]);
            for (size_t j = 0; j < i; ++j) {
                sum += 2 * values[i] * values[j] * inverse_.element(places_[i], places_[j]);
            }
        }
        return sum;
    }

    size_t axes_;
    const StencilMatrix &numbers_;
    const PenalisedSystem &system_;
    SelectedInverse inverse_;
    ActiveFunctions functions_;
    std::vector<int64_t> places_; // of the functions, in the order of elimination
};

} // namespace

void standard_errors(const Statistics &statistics, const std::vector<KnotVectorPtr> &wanted,
                     int penalty_order, double lambda, const ConstRecords &params,
                     const eval::AxisRules &rules, const Records &errors) {
    const std::vector<KnotVectorPtr> axes = clamped_axes(wanted);
    const NormalEquations equations = normal_equations(statistics, axes);
    const StencilMatrix form = penalty(axes, penalty_order);
    const int exponent = statistics.form().weight_exponent;
    PenalisedSystem system(equations, &form);
    if (const int64_t unsure = system.try_factorise_surely(system.limited(std::ldexp(lambda, -exponent)));
        unsure >= 0) {
        system.fail_rank(unsure);
    }
    ErrorForm at(axes, equations.matrix, system);
    const double unit = std::sqrt(std::ldexp(1.0, -exponent));
    int64_t pairs = 1;
    for (const KnotVectorPtr &axis : axes) {
        pairs *= (axis->degree() + 1) * (axis->degree() + 1);
    }
    for (int64_t i = 0; i < params.count; ++i) {
        Index spans{};
        std::array<double, max_axes> t{};
        bool inside = true;
        for (size_t k = 0; k < axes.size(); ++k) {
            t[k] = eval::place(params(i, static_cast<int64_t>(k)), rules[k], axes[k]->domain());
            inside = inside && t[k] == t[k];
            spans[k] =
                inside ? axes[k]->find_span(t[k], rules[k].left || t[k] == axes[k]->domain().upper) : 0;
        }
        errors(i, 0) = inside ? unit * at.at(spans, t) : std::numeric_limits<double>::quiet_NaN();
        count_work(8 * pairs);
    }
}

std::vector<Criteria> criteria(const Statistics &statistics, const std::vector<KnotVectorPtr> &wanted,
                               int penalty_order, const std::vector<double> &lambdas) {
    const std::vector<KnotVectorPtr> axes = clamped_axes(wanted);
    const NormalEquations equations = normal_equations(statistics, axes);
    const StencilMatrix form = penalty(axes, penalty_order);
    PenalisedSystem system(equations, &form);
    LambdaSearch search(equations, form, penalty_order, system);
    const StatisticsForm &units = statistics.form();
    std::vector<Criteria> result;
    Steps steps(std::ssize(lambdas));
    for (const double lambda : lambdas) {
        result.push_back(search.criteria(std::ldexp(lambda, -units.weight_exponent), units.weight_exponent,
                                         2 * units.value_exponent));
        steps.next();
    }
    return result;
}

} // namespace nrb::fit
