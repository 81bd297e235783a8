// SPDX-License-Identifier: MIT
#include "fit/least_squares/smoothing.h"

#include "base/watch.h"
#include "numeric/golden_section.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace nrb::fit {

namespace {

constexpr double lowest = -10; // decimal exponent of the smallest lambda, in units of tr G / tr P

// The number of unknowns that the penalty does not determine, the dimension of its null space: on each axis
// that of the polynomials below its order, on a periodic axis that of constants, and all if the order is
// above the degree.
double free_unknowns(const std::vector<KnotVectorPtr> &axes, int order) noexcept {
    double free = 1;
    for (const KnotVectorPtr &axis : axes) {
        free *= order > axis->degree() ? static_cast<double>(axis->distinct_layers())
                : axis->periodic()     ? 1
                                       : order;
    }
    return free;
}

} // namespace

LambdaSearch::LambdaSearch(const NormalEquations &equations, const StencilMatrix &penalty, int penalty_order,
                           PenalisedSystem &system)
    : equations_(equations), system_(system), free_unknowns_(free_unknowns(equations.axes, penalty_order)),
      scale_(equations.matrix.trace().high / penalty.trace().high), widest_(6) {
    // The smoothest functions with a penalty have one of about 1, the others up to the trace.
    const double unknowns = static_cast<double>(equations.matrix.size());
    widest_ += std::max(0.0, std::log10(penalty.trace().high / unknowns));
}

double LambdaSearch::lambda_of(double exponent) const noexcept {
    return scale_ * std::pow(10, exponent);
}

Smoothed LambdaSearch::at(double lambda) {
    Smoothed result;
    if (const int64_t unsure = system_.try_factorise_surely(lambda); unsure >= 0) {
        if (system_.try_factorise(0) >= 0) { // the data do not determine it either
            system_.fail_rank(unsure);
        }
        system_.factorise(lambda);
    }
    result.lambda = lambda;
    result.x = system_.solve(equations_.right, equations_.dim);
    result.squares = system_.remaining_squares(result.x);
    result.freedom = freedom();
    return result;
}

double LambdaSearch::freedom() const {
    const double most = static_cast<double>(std::min(equations_.data_count, equations_.matrix.size()));
    return std::clamp(system_.freedom().value, 0.0, most);
}

double LambdaSearch::squares_at(double exponent) {
    system_.factorise(lambda_of(exponent));
    return system_.remaining_squares(system_.estimate());
}

double LambdaSearch::gcv(double squares) const {
    constexpr double least = 0x1p-10, sure = 0x1p-6;
    const auto [t, error] = system_.freedom();
    const double n = static_cast<double>(equations_.data_count), left = n - t;
    const double unknowns = static_cast<double>(equations_.matrix.size());
    const bool told = t > -error && error < sure * left && left > (unknowns < n ? 0 : least * n);
    return told ? n * squares / (left * left) : std::numeric_limits<double>::infinity();
}

double LambdaSearch::reml(const PenalisedSystem::Numbers &x, double lambda, double log_squares,
                          double log_weights) const {
    DoubleDouble paid; // R + lambda P: s - x^T r
    for (const DoubleDouble &square : equations_.squares) {
        paid = paid + square;
    }
    const double all = paid.high;
    for (size_t i = 0; i < x.size(); ++i) {
        paid = paid - x[i] * equations_.right[i];
    }
    const double n = static_cast<double>(equations_.data_count),
                 unknowns = static_cast<double>(equations_.matrix.size());
    return (n - free_unknowns_) * (std::log(std::max(paid.high, all * 0x1p-100)) + log_squares) +
           system_.log_determinant() + unknowns * log_weights -
           (unknowns - free_unknowns_) * (std::log(lambda) + log_weights);
}

double LambdaSearch::criterion(Smoothing rule, double lambda) {
    const PenalisedSystem::Numbers x = system_.estimate();
    return rule == Smoothing::gcv ? gcv(system_.remaining_squares(x)) : reml(x, lambda);
}

Criteria LambdaSearch::criteria(double lambda, int weight_exponent, int square_exponent) {
    const Smoothed found = at(lambda);
    const int exponent = weight_exponent + square_exponent;
    return {std::ldexp(found.squares, exponent), found.freedom, std::ldexp(gcv(found.squares), exponent),
            reml(found.x, lambda, (weight_exponent + square_exponent) * std::numbers::ln2,
                 weight_exponent * std::numbers::ln2)};
}

// The best of a coarse grid, then golden section search beside it.
Smoothed LambdaSearch::smallest(Smoothing rule) {
    constexpr int sections = 12;
    const int steps = static_cast<int>(std::ceil(widest_ - lowest));
    Steps progress(steps + sections + 3);
    const auto value_at = [&](double exponent) {
        progress.next();
        return system_.try_factorise(lambda_of(exponent)) < 0 ? criterion(rule, lambda_of(exponent))
                                                              : std::numeric_limits<double>::infinity();
    };
    double best = lowest, least = std::numeric_limits<double>::infinity();
    for (int i = 0; i <= steps; ++i) {
        if (const double value = value_at(lowest + i); value < least) {
            least = value;
            best = lowest + i;
        }
    }
    return at(lambda_of(golden_section(best - 1, best + 1, sections, value_at)));
}

// Bisection: the squares that are left grow with lambda.
Smoothed LambdaSearch::within(double target) {
    constexpr int halvings = 40;
    constexpr double close = 1e-9;
    double a = lowest, b = widest_;
    while (a < b && system_.try_factorise(lambda_of(a)) >= 0) {
        ++a;
    }
    if (squares_at(b) <= target) {
        return at(lambda_of(b));
    }
    double squares = squares_at(a);
    const bool reached = squares <= target;
    Steps progress(halvings);
    for (int i = 0; reached && i < halvings && squares < target * (1 - close); ++i, progress.next()) {
        const double middle = (a + b) / 2, there = squares_at(middle);
        if (there <= target) {
            a = middle;
            squares = there;
        } else {
            b = middle;
        }
    }
    Smoothed found = at(lambda_of(a));
    found.reached = reached;
    return found;
}

Smoothed LambdaSearch::choose(Smoothing rule, double value) {
    return rule == Smoothing::given         ? at(system_.limited(value))
           : rule == Smoothing::discrepancy ? within(value)
                                            : smallest(rule);
}

} // namespace nrb::fit
