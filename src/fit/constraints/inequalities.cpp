// SPDX-License-Identifier: MIT
#include "fit/constraints/inequalities.h"

#include "base/error.h"
#include "base/watch.h"
#include "fit/constraints/interior_point.h"

#include <algorithm>
#include <cmath>

namespace nrb::fit {

namespace {

constexpr double stronger = 16; // by which the factor f is raised or lowered

DoubleDouble dot(const std::vector<DoubleDouble> &a, const std::vector<DoubleDouble> &b) noexcept {
    DoubleDouble sum;
    for (size_t i = 0; i < a.size(); ++i) {
        sum = sum + a[i] * b[i];
    }
    return sum;
}

std::vector<DoubleDouble> difference(const std::vector<DoubleDouble> &a, const std::vector<DoubleDouble> &b) {
    std::vector<DoubleDouble> result(a.size());
    for (size_t i = 0; i < a.size(); ++i) {
        result[i] = a[i] - b[i];
    }
    return result;
}

} // namespace

Inequalities::Inequalities(NormalEquations equations, std::vector<LinearRow> rows, size_t equal)
    : equations_(std::move(equations)), rows_(std::move(rows)), equal_(equal), plain_(equations_, nullptr),
      stiff_(equations_, nullptr), multipliers_(rows_.size()) {
    constexpr double first_factor = 0x1p20, largest_growth = 0x1p30;
    mean_ = equations_.matrix.mean().high;
    factor_ = first_factor * mean_;
    strongest_ = largest_growth * factor_;
}

std::vector<DoubleDouble> Inequalities::left_sides(const Numbers &x) const {
    Numbers sides;
    sides.reserve(rows_.size());
    for (const LinearRow &row : rows_) {
        sides.push_back(left_side(row, x, 1, 0));
    }
    count_work(16 * std::ssize(rows_));
    return sides;
}

std::vector<DoubleDouble> Inequalities::forces(const Numbers &x) const {
    Numbers all = left_sides(x);
    for (size_t i = 0; i < all.size(); ++i) {
        all[i] = multipliers_[i] + DoubleDouble(factor_) * (DoubleDouble(rows_[i].target[0]) - all[i]);
        if (!equation(i) && !(all[i].high > 0)) {
            all[i] = {};
        }
    }
    return all;
}

std::vector<bool> Inequalities::counting(const Numbers &x) const {
    const Numbers all = forces(x);
    std::vector<bool> result(all.size());
    for (size_t i = 0; i < all.size(); ++i) {
        result[i] = equation(i) || all[i].high > 0;
    }
    return result;
}

int64_t Inequalities::try_factorise(const std::vector<bool> &counting, double factor) {
    StencilMatrix matrix = equations_.matrix;
    for (size_t i = 0; i < rows_.size(); ++i) {
        if (counting[i]) {
            add_square(rows_[i], DoubleDouble(factor), matrix);
        }
    }
    stiff_.set_matrix(matrix);
    return stiff_.try_factorise(0);
}

// Lowers the factor f where the matrix is too ill-conditioned to be factorised.
void Inequalities::factorise(const std::vector<bool> &counting) {
    for (int64_t bad = try_factorise(counting, factor_); bad >= 0; bad = try_factorise(counting, factor_)) {
        if (factor_ < mean_) {
            stiff_.fail_rank(bad);
        }
        factor_ /= stronger;
        strongest_ = factor_;
    }
    factorised_ = counting;
    factor_of_factors_ = factor_;
}

// The minimum of the quadratic function in which exactly these rows count.
std::vector<DoubleDouble> Inequalities::newton_step(const std::vector<bool> &counting) {
    if (counting != factorised_ || factor_ != factor_of_factors_) {
        factorise(counting);
    }
    Numbers right = equations_.right;
    for (size_t i = 0; i < rows_.size(); ++i) {
        if (counting[i]) {
            const DoubleDouble pull =
                multipliers_[i] + DoubleDouble(factor_) * DoubleDouble(rows_[i].target[0]);
            add_multiple(rows_[i], pull, 1, 0, right);
        }
    }
    return stiff_.solve(right, 1);
}

// Exact line search: where along the step from x the derivative vanishes. Its value at x + t step is
// step^T (A (x + t step) - r) minus the sum of forces times C step over the rows that count, and increases
// with t. At the end of the step, A x - r is the sum of the forces there over the rows that were factorised,
// whatever their signs.
double Inequalities::best_part(const Numbers &x, const Numbers &end, const Numbers &step) const {
    constexpr int halvings = 40;
    const Numbers from = left_sides(x), to = left_sides(end);
    DoubleDouble slope_at_end;
    for (size_t i = 0; i < rows_.size(); ++i) {
        if (factorised_[i]) {
            const DoubleDouble force =
                multipliers_[i] + DoubleDouble(factor_) * (DoubleDouble(rows_[i].target[0]) - to[i]);
            slope_at_end = slope_at_end + force * (to[i] - from[i]);
        }
    }
    const DoubleDouble curvature = dot(step, plain_.product(step, 1)), factor = factor_;
    const auto slope = [&](double t) { // of large terms that cancel
        DoubleDouble sum = slope_at_end - DoubleDouble(1 - t) * curvature;
        for (size_t i = 0; i < rows_.size(); ++i) {
            const DoubleDouble change = to[i] - from[i];
            const DoubleDouble force = multipliers_[i] + factor * (DoubleDouble(rows_[i].target[0]) -
                                                                   (from[i] + DoubleDouble(t) * change));
            sum = equation(i) || force.high > 0 ? sum - force * change : sum;
        }
        return sum.high;
    };
    double lower = 0, upper = 1;
    if (!(slope(1) > 0)) {
        return 1;
    }
    for (int i = 0; i < halvings; ++i) {
        const double middle = (lower + upper) / 2;
        (slope(middle) > 0 ? upper : lower) = middle;
    }
    return lower;
}

void Inequalities::minimise(Numbers &x) {
    constexpr int most = 200;
    constexpr double rounding = 0x1p-60;
    for (int i = 0; i < most; ++i) {
        const std::vector<bool> rows = counting(x);
        const Numbers end = newton_step(rows);
        if (counting(end) == rows) {
            x = end;
            return;
        }
        const Numbers step = difference(end, x);
        const double part = best_part(x, end, step), size = largest_of(end);
        for (size_t j = 0; j < x.size(); ++j) {
            x[j] = part == 1 ? end[j] : x[j] + DoubleDouble(part) * step[j];
        }
        if (!(part * largest_of(step) > rounding * size)) {
            return;
        }
    }
}

double Inequalities::missed(const Numbers &x) const {
    const Numbers sides = left_sides(x);
    double most = 0;
    for (size_t i = 0; i < rows_.size(); ++i) {
        const double miss = (DoubleDouble(rows_[i].target[0]) - sides[i]).high;
        most = std::max(most, equation(i) ? std::abs(miss)
                                          : std::abs(std::max(miss, -multipliers_[i].high / factor_)));
    }
    return most;
}

std::vector<DoubleDouble> Inequalities::minimum(Numbers x) {
    constexpr int most = 60;
    constexpr double enough = 0x1p-54, possible = 0x1p-40;
    const double size = size_of(x, rows_, equal_);
    InteriorPoint::Point inside = InteriorPoint(equations_, rows_, equal_).from(x);
    x = std::move(inside.x);
    multipliers_ = std::move(inside.multipliers);
    double miss = 0, before = 0;
    Steps steps(most);
    for (int i = 0; i < most; ++i, steps.next()) {
        minimise(x);
        miss = missed(x);
        multipliers_ = forces(x);
        if (!(miss > enough * size)) {
            return x;
        }
        if (i > 0 && miss > before / stronger && factor_ < strongest_) {
            factor_ *= stronger;
        }
        before = miss;
    }
    if (miss > possible * size) {
        fail(Status::contradiction,
             "no spline over the knots has this shape: one inequality or condition is "
             "missed by %s",
             Number(miss).text);
    }
    return x;
}

double Inequalities::freedom(const StencilMatrix &data) {
    const std::vector<bool> rows = factorised_;
    double factor = 0x1p60 * mean_; // the stiffer, the closer the rows are to equations
    while (factor > factor_ && try_factorise(rows, factor) >= 0) {
        factor /= stronger * stronger;
    }
    if (!(factor > factor_)) {
        factorise(rows);
    }
    return stiff_.trace_with(data);
}

} // namespace nrb::fit
