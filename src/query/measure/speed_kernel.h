// |C'| at the nodes of a rule.
#pragma once

#include "query/measure/nested_rule.h"

namespace nrb {

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

// The sums of `count` values, a multiple of 8, times each of seven rows of factors.
void rule_sums(const double *const *rows, const double *values, int count, double *sums) noexcept;

} // namespace nrb
