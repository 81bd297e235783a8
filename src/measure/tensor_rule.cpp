// SPDX-License-Identifier: MIT
#include "measure/tensor_rule.h"

#include "measure/length/speed_kernel.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace nrb::measure {

TensorRule::TensorRule(const Elements &elements, const Integrand &integrand)
    : integrand_(integrand), axes_(elements.axes()), dim_(elements.dim()),
      values_(static_cast<size_t>(integrand.values())), rational_(elements.rational()),
      coefficients_(elements.coefficients()) {
    for (int k = 0; k < axes_; ++k) {
        const auto at = static_cast<size_t>(k);
        degrees_[at] = elements.degree(k);
        const auto size = static_cast<size_t>((degrees_[at] + 1) * rule_capacity);
        basis_[at].resize(size);
        derivatives_[at].resize(size);
        rule_basis(degrees_[at], basis_[at].data());
        rule_basis_derivatives(degrees_[at], derivatives_[at].data());
    }
    place_.resize(static_cast<size_t>(dim_));
    const auto axes = static_cast<size_t>(axes_);
    first_.resize(place_.size() * axes);
    out_.resize(values_);
    across_.resize(axes * values_ * rule_capacity);
    decays_.resize(axes * values_);
    magnitudes_.resize(values_);
}

// Evaluates values and derivatives at all nodes, axis by axis from the last one. The derivative along an axis
// branches off from the values at that axis.
void TensorRule::expand(const double *net, const Levels &levels) {
    const int width = dim_ + (rational_ ? 1 : 0);
    auto &values = nodes_[static_cast<size_t>(axes_)];
    values.resize(std::max(values.size(), static_cast<size_t>(width * coefficients_)));
    std::copy_n(net, width * coefficients_, values.data());
    int64_t outer = width * coefficients_, inner = 1;
    for (int k = axes_; k-- > 0;) {
        const auto at = static_cast<size_t>(k);
        const int terms = degrees_[at] + 1, count = rule_size(levels[at]);
        outer /= terms;
        const auto apply = [&](const std::vector<double> &matrix, const std::vector<double> &from,
                               std::vector<double> &to) {
            work_.resize(std::max(work_.size(), static_cast<size_t>(outer * count * inner)));
            contract(from.data(), outer, terms, inner, matrix.data(), rule_capacity, count, work_.data());
            to.swap(work_);
        };
        for (int l = k + 1; l < axes_; ++l) {
            apply(basis_[at], nodes_[static_cast<size_t>(l)], nodes_[static_cast<size_t>(l)]);
        }
        apply(derivatives_[at], values, nodes_[at]);
        apply(basis_[at], values, values);
        inner *= count;
    }
    node_count_ = inner;
}

// Calls the integrand at one node, with x = A / w and x_k = (A_k - x w_k) / w.
void TensorRule::visit_node(int64_t node, const std::vector<double> &origin) {
    const auto component = [&](size_t slot, int c) {
        return nodes_[slot][static_cast<size_t>(c * node_count_ + node)];
    };
    const auto values = static_cast<size_t>(axes_);
    const double factor = rational_ ? 1 / component(values, dim_) : 1;
    for (int c = 0; c < dim_; ++c) {
        const double x = component(values, c) * factor;
        place_[static_cast<size_t>(c)] = x + origin[static_cast<size_t>(c)];
        for (int k = 0; k < axes_; ++k) {
            const auto at = static_cast<size_t>(k);
            const double slope = rational_ ? x * component(at, dim_) : 0;
            first_[static_cast<size_t>(k * dim_ + c)] = (component(at, c) - slope) * factor;
        }
    }
    integrand_(place_.data(), first_.data(), out_.data());
    const bool change = integrand_.absolute() && out_[0] < 0;
    negative_ = negative_ || change;
    positive_ = positive_ || !change;
    if (change) {
        std::for_each(out_.begin(), out_.end(), [](double &x) { x = -x; });
    }
}

// Adds the nodes of a line along the last axis to the sums across that axis, and computes the weighted sum of
// the line.
void TensorRule::add_line(int64_t first, const Line &line, const std::vector<double> &origin) {
    double *const across = across_.data() + static_cast<size_t>(axes_ - 1) * values_ * rule_capacity;
    std::fill(line_.begin(), line_.end(), 0.0);
    for (int i = 0; i < line.size; ++i) {
        if (line.weights[i] == 0) {
            continue;
        }
        visit_node(first + i, origin);
        for (size_t j = 0; j < values_; ++j) {
            const double value = out_[j], weighted = line.weights[i] * value;
            across[j * rule_capacity + static_cast<size_t>(i)] += line.weight * value;
            line_[j] += weighted;
            line_[values_ + j] += std::abs(weighted);
        }
    }
}

void TensorRule::evaluate(const double *net, const std::vector<double> &origin, const Levels &levels) {
    positive_ = negative_ = false;
    expand(net, levels);
    std::fill(across_.begin(), across_.end(), 0.0);
    std::fill(magnitudes_.begin(), magnitudes_.end(), 0.0);
    line_.resize(2 * values_);
    const int last = axes_ - 1;
    const auto size = [&](int k) { return k < last ? rule_size(levels[static_cast<size_t>(k)]) : 1; };
    const auto weight = [&](int k, int i) {
        return k < last ? rule_weights(levels[static_cast<size_t>(k)])[i] : 1;
    };
    Line line{rule_weights(levels[static_cast<size_t>(last)]), rule_size(levels[static_cast<size_t>(last)]),
              0};
    int64_t node = 0;
    for (int i = 0; i < size(0); ++i) {
        for (int j = 0; j < size(1); ++j, node += line.size) {
            const std::array<double, 2> weights{weight(0, i), weight(1, j)};
            line.weight = weights[0] * weights[1];
            if (line.weight != 0) {
                add_line(node, line, origin);
                add_line_sums({i, j}, weights);
            }
        }
    }
    finish(levels);
}

// Adds the sum of a line to the sums across the other axes.
void TensorRule::add_line_sums(const std::array<int, 2> &at, const std::array<double, 2> &weights) {
    for (size_t k = 0; k + 1 < static_cast<size_t>(axes_); ++k) {
        double *across = across_.data() + k * values_ * rule_capacity + at[k];
        for (size_t j = 0; j < values_; ++j) {
            across[j * rule_capacity] += weights[1 - k] * line_[j];
        }
    }
    for (size_t j = 0; j < values_; ++j) {
        magnitudes_[j] += weights[0] * weights[1] * line_[values_ + j];
    }
}

void TensorRule::finish(const Levels &levels) {
    for (size_t k = 0; k < static_cast<size_t>(axes_); ++k) {
        const int degree = rational_ ? -1 : integrand_.degree(degrees_[k]);
        const bool one_sign = !integrand_.absolute() || !positive_ || !negative_;
        exact_[k] = one_sign && degree >= 0 && degree <= rule_exactness(levels[k]);
        for (size_t j = 0; j < values_; ++j) {
            const size_t at = k * values_ + j;
            decays_[at] = rule_decay(levels[k], across_.data() + at * rule_capacity);
        }
    }
}

double TensorRule::error(int axis, size_t j) const noexcept {
    return exact_[static_cast<size_t>(axis)] ? 0 : decay(axis, j).error(magnitude(j));
}

} // namespace nrb::measure
