// SPDX-License-Identifier: MIT
#include "fit/constraints/interior_point.h"

#include "base/watch.h"

#include <algorithm>
#include <cmath>

namespace nrb::fit {

namespace {

constexpr double stiffness_of_equations = 0x1p20; // relative to the diagonal of A

} // namespace

InteriorPoint::InteriorPoint(const NormalEquations &equations, const std::vector<LinearRow> &rows,
                             size_t equal)
    : equations_(equations), rows_(rows), equal_(equal), plain_(equations, nullptr),
      stiff_(equations, nullptr) {
    mean_ = equations.matrix.mean().high;
}

// The slacks are at least a part of the size of x, and at least the largest violation of an inequality.
void InteriorPoint::start(const Numbers &x) {
    constexpr double part = 0x1p-6;
    x_ = x;
    size_ = size_of(x, rows_, equal_);
    double missed = 0;
    slacks_.assign(rows_.size(), {});
    for (size_t i = 0; i < rows_.size(); ++i) {
        slacks_[i] = left_side(rows_[i], x_, 1, 0) - DoubleDouble(rows_[i].target[0]);
        missed = i < equal_ ? missed : std::max(missed, -slacks_[i].high);
    }
    const double least = std::max(missed, part * size_);
    for (DoubleDouble &slack : slacks_) {
        slack = std::max(slack.high, least);
    }
    // Multipliers of second differences are double sums of gradients, and so grow with the square of the
    // length.
    double longest = 1;
    for (const KnotVectorPtr &axis : equations_.axes) {
        longest = std::max(longest, static_cast<double>(axis->distinct_layers()));
    }
    multipliers_.assign(rows_.size(), DoubleDouble(mean_ * least * longest * longest));
    std::fill_n(multipliers_.begin(), equal_, DoubleDouble{});
}

void InteriorPoint::measure() {
    gradient_ = plain_.product(x_, 1);
    for (size_t i = 0; i < gradient_.size(); ++i) {
        gradient_[i] = gradient_[i] - equations_.right[i];
    }
    missed_.assign(rows_.size(), {});
    double sum = 0;
    for (size_t i = 0; i < rows_.size(); ++i) {
        const bool equation = i < equal_;
        add_multiple(rows_[i], -multipliers_[i], 1, 0, gradient_);
        missed_[i] = left_side(rows_[i], x_, 1, 0) - DoubleDouble(rows_[i].target[0]);
        missed_[i] = equation ? missed_[i] : missed_[i] - slacks_[i];
        sum += equation ? 0 : slacks_[i].high * multipliers_[i].high;
    }
    product_ = sum / static_cast<double>(std::max<size_t>(1, rows_.size() - equal_));
}

bool InteriorPoint::factorise() {
    StencilMatrix matrix = equations_.matrix;
    for (size_t i = 0; i < rows_.size(); ++i) {
        add_square(rows_[i],
                   i < equal_ ? DoubleDouble(stiffness_of_equations * mean_) : multipliers_[i] / slacks_[i],
                   matrix);
    }
    stiff_.set_matrix(matrix);
    return stiff_.try_factorise(0) < 0;
}

// With q = products / s - z, the step solves
//     (A + C^T (z / s) C) dx = -gradient + C^T (q - (z / s) missed)
//     ds = C dx + missed
//     dz = q - (z / s) ds
// Equations are treated as stiff springs.
InteriorPoint::Step InteriorPoint::step_to(const Numbers &products) {
    Numbers right(gradient_.size()), pull(rows_.size()), stiffness(rows_.size());
    for (size_t i = 0; i < right.size(); ++i) {
        right[i] = -gradient_[i];
    }
    for (size_t i = 0; i < rows_.size(); ++i) {
        const bool equation = i < equal_;
        stiffness[i] = equation ? DoubleDouble(stiffness_of_equations * mean_) : multipliers_[i] / slacks_[i];
        pull[i] = equation ? DoubleDouble{} : products[i] / slacks_[i] - multipliers_[i];
        add_multiple(rows_[i], pull[i] - stiffness[i] * missed_[i], 1, 0, right);
    }
    Step step{stiff_.solve(right, 1), Numbers(rows_.size()), Numbers(rows_.size())};
    for (size_t i = 0; i < rows_.size(); ++i) {
        step.slacks[i] = left_side(rows_[i], step.x, 1, 0) + missed_[i];
        step.multipliers[i] = pull[i] - stiffness[i] * step.slacks[i];
    }
    return step;
}

double InteriorPoint::allowed(const Step &step) const noexcept {
    double part = 1;
    for (size_t i = equal_; i < rows_.size(); ++i) {
        for (const auto &[value, change] : {std::pair(slacks_[i].high, step.slacks[i].high),
                                            std::pair(multipliers_[i].high, step.multipliers[i].high)}) {
            part = change < 0 ? std::min(part, -value / change) : part;
        }
    }
    return part;
}

double InteriorPoint::mean_product(const Step &step, double part) const noexcept {
    double sum = 0;
    for (size_t i = equal_; i < rows_.size(); ++i) {
        sum += (slacks_[i].high + part * step.slacks[i].high) *
               (multipliers_[i].high + part * step.multipliers[i].high);
    }
    return sum / static_cast<double>(std::max<size_t>(1, rows_.size() - equal_));
}

void InteriorPoint::take(const Step &step, double part) noexcept {
    for (size_t i = 0; i < x_.size(); ++i) {
        x_[i] = x_[i] + DoubleDouble(part) * step.x[i];
    }
    for (size_t i = 0; i < rows_.size(); ++i) {
        slacks_[i] = slacks_[i] + DoubleDouble(part) * step.slacks[i];
        multipliers_[i] = multipliers_[i] + DoubleDouble(part) * step.multipliers[i];
    }
}

InteriorPoint::Point InteriorPoint::from(const Numbers &x) {
    constexpr int most = 60;
    constexpr double enough = 0x1p-90, inside = 0.995, least = 0x1p-10;
    start(x);
    const double goal = enough * mean_ * size_ * size_;
    for (int i = 0; i < most; ++i) {
        measure();
        if (!(product_ > goal) || !factorise()) {
            break;
        }
        count_work(64 * std::ssize(rows_));
        Numbers products(rows_.size());
        const Step straight = step_to(products);
        const double reached = mean_product(straight, allowed(straight)) / product_;
        for (size_t r = 0; r < products.size(); ++r) {
            products[r] = DoubleDouble(reached * reached * reached * product_) -
                          straight.slacks[r] * straight.multipliers[r];
        }
        const Step step = step_to(products);
        const double part = std::min(1.0, inside * allowed(step));
        if (!(part > least)) {
            break;
        }
        take(step, part);
    }
    return {std::move(x_), std::move(multipliers_)};
}

} // namespace nrb::fit
