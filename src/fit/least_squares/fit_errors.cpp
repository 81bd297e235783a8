// SPDX-License-Identifier: MIT
#include "fit/least_squares/fit_errors.h"

#include "base/watch.h"
#include "basis/bspline.h"
#include "fit/least_squares/clamped_axes.h"
#include "fit/least_squares/penalty.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace nrb::fit {

namespace {

// An element of the inverse for each pair of functions that overlap.
class ErrorForm {
public:
    ErrorForm(std::vector<KnotVectorPtr> axes, const StencilMatrix &numbers, const PenalisedSystem &system)
        : axes_(std::move(axes)), numbers_(numbers), system_(system), inverse_(system.inverse()) {
        for (size_t k = 0; k < axes_.size(); ++k) {
            functions_[k] = axes_[k]->degree() + 1;
            along_[k].resize(static_cast<size_t>(functions_[k]));
        }
        places_.resize(static_cast<size_t>(functions_[0] * functions_[1] * functions_[2]));
        values_.resize(places_.size());
    }

    // Of parameters in the domain, each in a span. Allocates nothing.
    [[nodiscard]] double at(const Index &spans, const std::array<double, max_axes> &t) noexcept {
        Index first{};
        for (size_t k = 0; k < axes_.size(); ++k) {
            const int p = axes_[k]->degree();
            basis_values(axes_[k]->knots().data(), p, spans[k], t[k], along_[k].data());
            first[k] = spans[k] - p;
        }
        size_t i = 0;
        for_each_index(first, functions_, [&](const Index &layer) {
            places_[i] = system_.place_of(numbers_.unknown(layer));
            double value = 1;
            for (size_t k = 0; k < layer.size(); ++k) {
                value *= along_[k][static_cast<size_t>(layer[k] - first[k])];
            }
            values_[i++] = value;
        });
        return std::sqrt(std::max(0.0, form()));
    }

private:
    [[nodiscard]] double form() const noexcept {
        double sum = 0;
        for (size_t i = 0; i < places_.size(); ++i) {
            sum += values_[i] * values_[i] * inverse_.element(places_[i], places_[i]);
            for (size_t j = 0; j < i; ++j) {
                sum += 2 * values_[i] * values_[j] * inverse_.element(places_[i], places_[j]);
            }
        }
        return sum;
    }

    std::vector<KnotVectorPtr> axes_;
    const StencilMatrix &numbers_;
    const PenalisedSystem &system_;
    SelectedInverse inverse_;
    Index functions_{1, 1, 1};
    std::array<std::vector<double>, max_axes> along_{std::vector<double>{1}, {1}, {1}};
    std::vector<int64_t> places_; // of the functions that do not vanish, last axis fastest
    std::vector<double> values_;
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
    if (const int64_t unsure = system.try_factorise_surely(std::ldexp(lambda, -exponent)); unsure >= 0) {
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
