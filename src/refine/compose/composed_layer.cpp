// SPDX-License-Identifier: MIT
#include "refine/compose/composed_layer.h"

#include "base/watch.h"
#include "numeric/binomial.h"
#include "spline/contract.h"

#include <algorithm>
#include <functional>
#include <numeric>

namespace nrb::refine {

namespace {

constexpr int64_t work_of_a_term = 100; // for each component: arguments, contractions, a compensated sum

} // namespace

ComposedLayer::ComposedLayer(const Spline &g, const Spline &f, const std::vector<CurvePiece> &pieces,
                             const Spline::Axes &axes)
    : g_(g), f_(f), pieces_(pieces), axes_(axes), weighted_(f.rational()) {
    int64_t length = g.width();
    for (int k = g.axes(); k-- > 0;) {
        lengths_[static_cast<size_t>(k)] = length;
        parts_[static_cast<size_t>(k)].resize(static_cast<size_t>(length));
        length *= g.axis(k).degree() + 1;
    }
    sums_.resize(static_cast<size_t>(g.width()));
    record_.resize(static_cast<size_t>(g.width()));
}

const std::vector<double> &ComposedLayer::make(const CommonKnots::Window &window,
                                               std::span<const double> knots, const SpanCell &cell,
                                               const double *block) {
    cell_ = &cell;
    window_size_ = window.size;
    left_ = window.copies;
    list_choices(window, knots);
    std::ranges::fill(sums_, CompensatedSum{});
    total_ = {};
    terms_ = 0;
    next_axis(0, block, 1);
    for (size_t c = 0; c < sums_.size(); ++c) {
        record_[c] = terms_ == 1 ? only_weight_ * only_[c] : sums_[c].value() / total_.value();
    }
    return record_;
}

void ComposedLayer::list_choices(const CommonKnots::Window &window, std::span<const double> knots) {
    choices_.clear();
    if (window.size == 0 && f_.axis(0).degree() > 0) { // g is of degree 0 and takes no arguments
        return;
    }
    for_each_choice(window, f_.axis(0).degree(),
                    [&](const int *chosen, double) { choices_.push_back(choice_of(chosen, knots)); });
    for (size_t k = 0; k < static_cast<size_t>(g_.axes()); ++k) {
        order_choices(k);
    }
}

// A value of f at a knot may be a knot of g.
ComposedLayer::Choice ComposedLayer::choice_of(const int *chosen,
                                               std::span<const double> knots) const noexcept {
    Choice choice{{}, {}, 1};
    std::array<double, max_basis> arguments{};
    double *end = arguments.data();
    int distinct = 0;
    for (size_t i = 0; i < knots.size(); ++i) {
        choice.copies[i] = chosen[i];
        end = std::fill_n(end, chosen[i], knots[i]);
        distinct += chosen[i] > 0 ? 1 : 0;
    }
    const std::span<const double> given(arguments.data(), end);
    const CurvePiece &piece = pieces_[cell_->piece];
    choice.weight = weighted_ ? piece.polar_weight(given) : 1;
    for (int k = 0; k < g_.axes(); ++k) {
        const auto at = static_cast<size_t>(k);
        const double value = piece.polar_value(k, given);
        choice.values[at] =
            distinct == 1 ? snapped_value(*axes_[at], value, pieces_, cell_->piece, k, given[0]) : value;
    }
    return choice;
}

void ComposedLayer::order_choices(size_t k) {
    AxisChoices &ordered = of_axis_[k];
    const KnotVector &axis = *axes_[k];
    const auto around = axis.knots().subspan(static_cast<size_t>(cell_->spans[k] - axis.degree() + 1),
                                             2 * static_cast<size_t>(axis.degree()));
    ordered.all.clear();
    for (const bool knots : {true, false}) {
        for (const Choice &choice : choices_) {
            if ((std::ranges::find(around, choice.values[k]) != around.end()) == knots) {
                ordered.all.push_back(&choice);
            }
        }
        ordered.knots = knots ? ordered.all.size() : ordered.knots;
    }
    ordered.most.resize(ordered.all.size());
    std::array<int, max_basis> most{};
    for (size_t i = ordered.all.size(); i-- > 0;) {
        std::ranges::transform(most, ordered.all[i]->copies, most.begin(),
                               [](int a, int b) { return std::max(a, b); });
        ordered.most[i] = most;
    }
}

// In how many ways its knots can be picked; 0: there are not so many left.
double ComposedLayer::ways_of(const Choice &choice) const noexcept {
    double ways = 1;
    for (size_t i = 0; i < static_cast<size_t>(window_size_) && ways > 0; ++i) {
        if (const int wanted = choice.copies[i]; wanted > 0) {
            ways = wanted > left_[i] ? 0 : ways * binomials(left_[i])[wanted];
        }
    }
    return ways;
}

// Whether arguments may use as many knots as they need, with at most so many copies of each in one of them.
bool ComposedLayer::are_enough(const std::array<int, max_basis> &most, int arguments) const noexcept {
    int usable = 0;
    for (size_t i = 0; i < static_cast<size_t>(window_size_); ++i) {
        usable += std::min(left_[i], arguments * most[i]);
    }
    return usable >= arguments * f_.axis(0).degree();
}

void ComposedLayer::take(const Choice &choice, int times) noexcept {
    for (size_t i = 0; i < static_cast<size_t>(window_size_); ++i) {
        left_[i] -= times * choice.copies[i];
    }
}

// Adds the values of G for all ways to distribute the remaining knots, from axis k on.
void ComposedLayer::next_axis(int k, const double *points, double times) {
    if (k < g_.axes()) {
        return next_argument(k, 0, 0, 0, nullptr, points, times);
    }
    count_work(work_of_a_term * std::ssize(sums_));
    double share = times;
    if (weighted_) {
        only_weight_ = product_of_weights();
        share *= only_weight_;
    }
    for (size_t c = 0; c < sums_.size(); ++c) {
        sums_[c].add(share * points[c]);
    }
    total_.add(times);
    only_ = points;
    ++terms_;
}

// The same for all arguments.
double ComposedLayer::product_of_weights() const noexcept {
    double product = 1;
    for (int k = 0; k < g_.axes(); ++k) {
        const double *weights = weights_[static_cast<size_t>(k)].data();
        product = std::accumulate(weights, weights + g_.axis(k).degree(), product, std::multiplies<>());
    }
    return product;
}

// The order of the arguments of an axis does not matter, so only orders that do not go back in the list of choices, from `place`
// on, are visited. A choice that occurs n times has 1 / n! as many orders as n different choices. row: of the arguments so far, null
// while all of them are knots.
void ComposedLayer::next_argument(int k, int number, size_t place, int run, const OpenRow *row,
                                  const double *points, double times) {
    const auto at = static_cast<size_t>(k), own = static_cast<size_t>(number);
    const auto arguments = std::span(arguments_[at]).first(own);
    const int missing = g_.axis(k).degree() - number;
    if (missing == 0) {
        row != nullptr ? contract_axis(k, *row, points)
                       : contract_axis(k, OpenRow(*axes_[at], cell_->spans[at], arguments), points);
        return next_axis(k + 1, parts_[at].data(), times);
    }
    const AxisChoices &choices = of_axis_[at];
    OpenRow begun;
    for (size_t next = place; next < choices.all.size(); ++next) {
        const Choice &choice = *choices.all[next];
        const bool is_knot = next < choices.knots;
        if ((!is_knot && choice.copies[0] * missing > left_[0]) || !are_enough(choices.most[next], missing)) {
            break; // the choices after this one have no fewer copies of the first knot
        }
        const double ways = ways_of(choice);
        if (ways == 0) {
            continue;
        }
        const int again = next == place ? run + 1 : 1;
        arguments_[at][own] = choice.values[at];
        weights_[at][own] = choice.weight;
        if (!is_knot) {
            if (row == nullptr) {
                begun = OpenRow(*axes_[at], cell_->spans[at], arguments);
                row = &begun;
            }
            rows_[at][own].append_to(*row, choice.values[at]);
        }
        take(choice, 1);
        next_argument(k, number + 1, next, again, is_knot ? nullptr : &rows_[at][own], points,
                      times * ways / again);
        take(choice, -1);
    }
}

void ComposedLayer::contract_axis(int k, const OpenRow &row, const double *points) noexcept {
    const auto at = static_cast<size_t>(k);
    const int64_t span = cell_->spans[at], length = lengths_[at];
    const std::span<const double> coefficients = row.coefficients();
    contract(coefficients.data(), static_cast<int>(coefficients.size()),
             points + (row.first() - span + g_.axis(k).degree()) * length, length, length, parts_[at].data());
}

} // namespace nrb::refine
