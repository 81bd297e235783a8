// SPDX-License-Identifier: MIT
// Samples how far cubic curves are from feet, many places at a time (SIMD).
#pragma once

#include "intersect/levels/curves/sample_kernel.h"

namespace nrb::intersect {

// The FeetNets of a piece of the surface and of one of the curve, whose degrees[1] is 0, and the homogeneous
// control points (w x, w y, w z, w) of the piece of the surface.
struct SampledFeet {
    SampledNet surface, curve, records;
};

// The largest values over all samples: |F_0| and |F_1|, |w (X - S)|^2 for the curve X in space, and
// |h^2 - |S - C|^2| w^2 W^2.
struct LargestOfFeet {
    std::array<double, 2> value{};
    double gap = 0, distance = 0;
};

// on: the cubics of (u, v) and of (t, h); space: that of X. work: room for 16 (p + 1) values, p the largest
// degree.
LargestOfFeet largest_of_feet(const SampledFeet &feet, const CubicSamples &samples,
                              const std::array<std::array<std::array<double, 2>, 4>, 2> &on,
                              const std::array<std::array<double, 3>, 4> &space, double *work) noexcept;

} // namespace nrb::intersect
