// SPDX-License-Identifier: MIT
#include "numeric/solvers/sparse/conjugate_gradients.h"

#include "base/watch.h"

#include <algorithm>

namespace nrb::inline numeric {

namespace {

std::vector<double> quotients(const std::vector<double> &a, const std::vector<double> &b) {
    std::vector<double> result(a.size());
    std::transform(a.begin(), a.end(), b.begin(), result.begin(),
                   [](double x, double y) { return y > 0 ? x / y : 0; });
    return result;
}

std::vector<double> negated(std::vector<double> values) {
    std::ranges::transform(values, values.begin(), std::negate<>());
    return values;
}

double element_of(const SparseColumns &matrix, int32_t row, int64_t column) noexcept {
    const auto first = matrix.rows.begin() + matrix.starts[static_cast<size_t>(column)],
               end = matrix.rows.begin() + matrix.starts[static_cast<size_t>(column) + 1];
    return matrix.values[static_cast<size_t>(std::lower_bound(first, end, row) - matrix.rows.begin())];
}

} // namespace

ConjugateGradients::ConjugateGradients(SparseColumns matrix, double rho, std::span<const double> diagonal,
                                       const SparseLdlt *factors, int64_t width)
    : matrix_(std::move(matrix)), rho_(rho), diagonal_(diagonal), factors_(factors), width_(width),
      inverse_diagonal_(diagonal.size()) {
    for (size_t j = 0; j < inverse_diagonal_.size(); ++j) {
        inverse_diagonal_[j] = 1 / element_of(matrix_, static_cast<int32_t>(j), static_cast<int64_t>(j));
    }
}

bool ConjugateGradients::solve(std::vector<double> &right, int most,
                               const std::deque<ShiftedSolution> &known) {
    std::vector<double> x = closest_of(known, right), residual = right, conditioned;
    Direction direction{std::vector<double>(x.size(), 0.0), std::vector<double>(x.size(), 0.0), {}};
    const std::vector<double> size = dots(right, right);
    multiply(x, direction.image);
    add(residual, std::vector<double>(size.size(), -1.0), direction.image);
    direction.energy.assign(size.size(), 0.0);
    for (int step = 0; step <= most; ++step) {
        if (is_small(residual, size)) {
            right.swap(x);
            return true;
        }
        conditioned = residual;
        precondition(conditioned);
        const std::vector<double> next = dots(residual, conditioned);
        add(conditioned, quotients(next, direction.energy), direction.step);
        direction.step.swap(conditioned);
        direction.energy = next;
        multiply(direction.step, direction.image);
        const std::vector<double> along = quotients(next, dots(direction.step, direction.image));
        add(x, along, direction.step);
        add(residual, negated(along), direction.image);
    }
    return false;
}

// The combination of known solutions nearest to the solution sought, in the energy norm: by a step along each
// known solution, made conjugate to those before.
std::vector<double> ConjugateGradients::closest_of(const std::deque<ShiftedSolution> &known,
                                                   const std::vector<double> &right) const {
    constexpr double least = 1e-12; // relative to the energy of the solution: less is lost in rounding
    std::vector<double> x(right.size(), 0.0);
    std::vector<Direction> directions;
    for (const ShiftedSolution &solution : known) {
        Direction next = direction_to(solution, right);
        for (const Direction &before : directions) {
            const std::vector<double> part = negated(quotients(dots(next.step, before.image), before.energy));
            add(next.step, part, before.step);
            add(next.image, part, before.image);
        }
        std::vector<double> energy = dots(next.step, next.image);
        for (size_t c = 0; c < energy.size(); ++c) {
            energy[c] = energy[c] > least * next.energy[c] ? energy[c] : 0;
        }
        next.energy = std::move(energy);
        add(x, quotients(dots(next.step, right), next.energy),
            next.step); // conjugate to x: the right-hand side serves as well as the residual
        directions.push_back(std::move(next));
    }
    return x;
}

// If x solves the system for s, then (K + rho D) x = b + (rho - s) D x.
ConjugateGradients::Direction ConjugateGradients::direction_to(const ShiftedSolution &solution,
                                                               const std::vector<double> &right) const {
    Direction direction{solution.x, right, {}};
    for (size_t j = 0, i = 0; j < diagonal_.size(); ++j) {
        const double factor = (rho_ - solution.rho) * diagonal_[j];
        for (int64_t c = 0; c < width_; ++c, ++i) {
            direction.image[i] += factor * solution.x[i];
        }
    }
    direction.energy = dots(direction.step, direction.image);
    return direction;
}

std::vector<double> ConjugateGradients::dots(const std::vector<double> &a,
                                             const std::vector<double> &b) const {
    std::vector<double> sums(static_cast<size_t>(width_), 0.0);
    for (size_t i = 0; i < a.size();) {
        for (double &sum : sums) {
            sum += a[i] * b[i];
            ++i;
        }
    }
    return sums;
}

bool ConjugateGradients::is_small(const std::vector<double> &residual,
                                  const std::vector<double> &size) const {
    constexpr double enough = 1e-10; // of the right-hand side: the energy has its square as error
    const std::vector<double> squares = dots(residual, residual);
    for (size_t c = 0; c < squares.size(); ++c) {
        if (!(squares[c] <= enough * enough * size[c])) {
            return false;
        }
    }
    return true;
}

void ConjugateGradients::add(std::vector<double> &to, const std::vector<double> &part,
                             const std::vector<double> &of) const noexcept {
    for (size_t i = 0; i < to.size();) {
        for (const double factor : part) {
            to[i] += factor * of[i];
            ++i;
        }
    }
}

void ConjugateGradients::precondition(std::vector<double> &x) const {
    if (factors_ != nullptr) {
        factors_->solve(x.data(), width_);
        return;
    }
    for (size_t j = 0, i = 0; j < inverse_diagonal_.size(); ++j) {
        for (int64_t c = 0; c < width_; ++c) {
            x[i++] *= inverse_diagonal_[j];
        }
    }
}

// The columns of a symmetric matrix are its rows.
void ConjugateGradients::multiply(const std::vector<double> &x, std::vector<double> &image) const {
    for (size_t j = 0; j + 1 < matrix_.starts.size(); ++j) {
        double *out = image.data() + static_cast<int64_t>(j) * width_;
        std::fill_n(out, width_, 0.0);
        const int64_t first = matrix_.starts[j], end = matrix_.starts[j + 1];
        count_work(2 * width_ * (end - first));
        for (int64_t p = first; p < end; ++p) {
            const double value = matrix_.values[static_cast<size_t>(p)];
            const double *from = x.data() + int64_t{matrix_.rows[static_cast<size_t>(p)]} * width_;
            for (int64_t c = 0; c < width_; ++c) {
                out[c] += value * from[c];
            }
        }
    }
}

} // namespace nrb::inline numeric
