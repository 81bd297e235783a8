// SPDX-License-Identifier: MIT
// Bounds and a regularity test from the coefficients of a speed, without evaluation at nodes; and its halves.
#pragma once

#include "measure/length/speed_kernel.h"

namespace nrb::measure {

// Detects features that are narrower than the distance between nodes: peaks where weights differ much, and
// dips and zeros where the curve turns sharply.
struct NetShape {
    // All weights have one sign and differ by a factor of at most 64; all coefficients of N are within 75
    // degrees of their sum, and their lengths differ by a factor of at most 64. Coefficients shorter than
    // 1e-8 of the longest one are ignored: dips of that relative width change a length by 1e-16 of it.
    bool even;
    double square; // upper bound on |N|^2: that of the longest coefficient; infinite if the sum overflows
    double weight; // smallest magnitude of a weight if all have one sign, else not positive

    // An upper bound on the length; infinite if nothing is known.
    [[nodiscard]] double bound() const noexcept;
};
NetShape net_shape(const SpeedForm &form, const double *net) noexcept;

// The numerator N = A' w - A w' of a rational curve A / w of degree p, for one coordinate with coefficients
// `a` and the weight with coefficients `w`. It is the sum over i < j of (j - i) C(p, i) C(p, j)
// (a_j w_i - a_i w_j) t^(i + j - 1) (1 - t)^(2 p - 1 - i - j). Writes 2 p - 1 coefficients. Precondition:
// p > 0.
void wronskian(int p, const double *a, const double *w, double *out) noexcept;

// Halves a net; the derivatives with respect to the parameter of a half have half the speed. The upper half
// replaces the net.
void halve_net(const SpeedForm &form, double *net, double *lower) noexcept;

} // namespace nrb::measure
