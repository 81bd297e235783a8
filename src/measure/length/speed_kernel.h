// SPDX-License-Identifier: MIT
// The speed |C'| of a curve at the nodes of a quadrature rule.
#pragma once

#include "numeric/nested_rule.h"

#include <cstdint>

namespace nrb::measure {

// The speed of a piece over u in [0, 1] as |N(u)| / w(u)^2. N has `dim` components of degree `degree`; if the
// curve is rational, w follows as one more row of degree `weight_degree` (-1: not rational).
struct SpeedForm {
    int dim = 1;
    int degree = 0;
    int weight_degree = -1;
    const double *basis = nullptr;        // from rule_basis(degree)
    const double *weight_basis = nullptr; // from rule_basis(weight_degree)

    [[nodiscard]] int size() const noexcept { return dim * (degree + 1) + weight_degree + 1; }
};

// The speeds at nodes [first, first + count), both multiples of 8, stored at their places in out.
void speeds(const SpeedForm &form, const double *net, int first, int count, double *out) noexcept;
// Extends `values` from the first nodes to all nodes of a level, in storage order, and returns the integral
// and its error estimate; the values at nodes before `first` are known.
RuleDecay speed_decay(const SpeedForm &form, const double *net, int first, int level,
                      double *values) noexcept;
// The sum over `count` nets of the speeds at the first 8 nodes times factors.
double sum_of_speeds(const SpeedForm &form, const double *nets, int64_t count,
                     const double *factors) noexcept;

// The integral and its error estimate from any values at the nodes of a level >= 1, in storage order.
RuleDecay rule_decay(int level, const double *values) noexcept;

} // namespace nrb::measure
