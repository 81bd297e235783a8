// SPDX-License-Identifier: MIT
// What the coefficients of a speed tell without a node, and their halves.
#pragma once

#include "measure/length/speed_kernel.h"

namespace nrb::measure {

// What the coefficients of a net tell of features that are narrower than the nodes are apart: peaks where the
// weights differ much, dips and zeros where the curve turns sharply.
struct NetShape {
    // The weights have one sign, all coefficients of N are within 75 degrees of their sum, and weights and
    // coefficients differ by a factor of at most 64. Dips of relative width 1e-8 are ignored: they change a
    // length by 1e-16 of it.
    bool even;
    double square; // of the longest coefficient of N, at most; infinite if the sum overflows
    double weight; // the smallest one if all have one sign, else not positive

    // Of the length; infinite if nothing is known.
    [[nodiscard]] double bound() const noexcept;
};
NetShape net_shape(const SpeedForm &form, const double *net) noexcept;

// N of a rational curve w C of degree p whose coefficients are `a` of one coordinate and `w` of the weight:
// A' w - A w', which is the sum over i < j of (j - i) C(p, i) C(p, j) (a_j w_i - a_i w_j) t^(i + j - 1)
// (1 - t)^(2 p - 1 - i - j). Writes 2 p - 1 coefficients. Precondition: p > 0.
void wronskian(int p, const double *a, const double *w, double *out) noexcept;

// Both halves of a net, of half the speed: the upper one in its place.
void halve_net(const SpeedForm &form, double *net, double *lower) noexcept;

} // namespace nrb::measure
