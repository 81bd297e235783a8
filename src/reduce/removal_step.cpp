// SPDX-License-Identifier: MIT
#include "reduce/removal_step.h"

#include <algorithm>
#include <cmath>

namespace nrb::reduce {

namespace {

// n_(i+1) = -n_i alpha_i / (1 - alpha_(i+1)), divided by sum |n_i|; then the coefficients of the fixed
// layers.
void fill_functional(RemovalStep &step) noexcept {
    double *null = step.functional + 1;
    null[0] = 1;
    double sum = 1;
    for (int i = 0; i + 1 < step.rows; ++i) {
        null[i + 1] = -null[i] * (step.alpha[i] / step.beta[i + 1]);
        sum += std::abs(null[i + 1]);
    }
    std::for_each_n(null, step.rows, [sum](double &n) { n /= sum; });
    step.functional[0] = -step.beta[0] * null[0];
    null[step.rows] = -step.alpha[step.rows - 1] * null[step.rows - 1];
}

// Rows before the skipped one are solved from the left, dividing by alpha; rows after it from the right,
// dividing by 1 - alpha.
int skipped_row(const RemovalStep &step) noexcept {
    int row = 0;
    while (row < step.rows && step.alpha[row] >= 0.5) {
        ++row;
    }
    if (row == step.rows) {
        return row - 1;
    }
    return row > 0 && step.beta[row] > step.alpha[row - 1] ? row - 1 : row;
}

// target = (target - sign * gap - factor * known) / divisor
void solve_row(double *target, double sign, const double *gap, double factor, const double *known,
               double divisor, int64_t width) noexcept {
    for (int64_t c = 0; c < width; ++c) {
        target[c] = ((target[c] - sign * gap[c]) - factor * known[c]) / divisor;
    }
}

} // namespace

RemovalStep removal_step(const double *last, int degree, int multiplicity) noexcept {
    RemovalStep step{};
    step.rows = degree - multiplicity + 1;
    for (int i = 0; i < step.rows; ++i) {
        const auto [alpha, beta] = divide_in_ratio(1.0, last[i - degree], *last, last[i + 1]);
        step.alpha[i] = alpha;
        step.beta[i] = beta;
    }
    fill_functional(step);
    step.skipped = skipped_row(step);
    return step;
}

void removal_gap(const RemovalStep &step, RemovalWindow window, int64_t width, double *gap) noexcept {
    std::fill_n(gap, width, 0.0);
    for (int i = 0; i < step.rows + 2; ++i) {
        for (int64_t c = 0; c < width; ++c) {
            gap[c] += step.functional[i] * window[i][c];
        }
    }
}

void remove_layer(const RemovalStep &step, RemovalWindow window, int64_t width, const double *gap) noexcept {
    for (int row = 0; row < step.skipped; ++row) {
        solve_row(window[row + 1], row % 2 == 0 ? 1 : -1, gap, step.beta[row], window[row], step.alpha[row],
                  width);
    }
    for (int row = step.rows - 1; row > step.skipped; --row) {
        solve_row(window[row + 1], row % 2 == 0 ? 1 : -1, gap, step.alpha[row], window[row + 2],
                  step.beta[row], width);
    }
}

} // namespace nrb::reduce
