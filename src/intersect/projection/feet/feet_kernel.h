// SPDX-License-Identifier: MIT
// How far cubic curves are from feet, at many places at once.
#pragma once

#include "intersect/levels/curves/sample_kernel.h"

namespace nrb::intersect {

// Pieces of a surface and of a curve: FeetNet of both, degrees[1] of the curve's is 0, and records (w x, w y, w z, w) of the
// surface.
struct SampledFeet {
    SampledNet surface, curve, records;
};

// The largest |F_0|, |F_1|, |w (X - S)|^2, and |h^2 - |S - C|^2| w^2 W^2.
struct LargestOfFeet {
    std::array<double, 2> value{};
    double gap = 0, distance = 0;
};

// Of curves of (u, v), of (t, h), and of X. work: 16 (p + 1) values for the largest degree p.
LargestOfFeet largest_of_feet(const SampledFeet &feet, const CubicSamples &samples,
                              const std::array<std::array<std::array<double, 2>, 4>, 2> &on,
                              const std::array<std::array<double, 3>, 4> &space, double *work) noexcept;

} // namespace nrb::intersect
