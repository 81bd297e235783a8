// SPDX-License-Identifier: MIT
// |C'| at the nodes of a rule.
#pragma once

#include "numeric/nested_rule.h"

#include <cstdint>

namespace nrb::measure {

// The speed of a piece of a curve over u in [0, 1] as |N(u)| / w(u)^2: N has `dim` components of degree
// `degree`, w follows as one more row of degree `weight_degree` if the curve is rational (-1: it is not).
struct SpeedForm {
    int dim = 1;
    int degree = 0;
    int weight_degree = -1;
    const double *basis = nullptr;        // rule_basis(degree)
    const double *weight_basis = nullptr; // rule_basis(weight_degree)

    [[nodiscard]] int size() const noexcept { return dim * (degree + 1) + weight_degree + 1; }
};

// Speeds at nodes [first, first + count), multiples of 8, into their places in out.
void speeds(const SpeedForm &form, const double *net, int first, int count, double *out) noexcept;
// The same at the nodes of a level in storage, those before `first` being there already, and what they tell.
RuleDecay speed_decay(const SpeedForm &form, const double *net, int first, int level,
                      double *values) noexcept;
// The sum over `count` nets of the speeds at the first 8 nodes times factors.
double sum_of_speeds(const SpeedForm &form, const double *nets, int64_t count,
                     const double *factors) noexcept;

// What any values at the nodes of a level >= 1 in storage tell.
RuleDecay rule_decay(int level, const double *values) noexcept;

} // namespace nrb::measure
