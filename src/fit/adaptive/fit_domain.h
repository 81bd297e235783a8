// SPDX-License-Identifier: MIT
// The domain of a fit, and knots over it.
#pragma once

#include "base/limits.h"
#include "basis/knot_vector.h"

#include <array>
#include <vector>

namespace nrb::fit {

// A break: a knot where polynomials of a degree meet. Its multiplicity is the degree at a kink, and one more
// at a jump.
struct Break {
    double param;
    int multiplicity;
};

// The degrees and the domain of a fit to a tolerance.
struct FitDomain {
    std::vector<int> degrees;
    std::vector<Interval> domains;
    std::array<bool, max_axes> periodic{};
    bool find_breaks = true;                           // kinks and jumps of curves become multiple knots
    std::array<std::vector<Break>, max_axes> breaks{}; // known ones; kept if there is room
    std::array<int, max_axes> seams{1, 1, 1};          // multiplicities of the ends of periodic axes
};

// The knots of an axis with those inside given: clamped or periodic.
KnotVectorPtr axis_over(const FitDomain &domain, size_t k, const std::vector<Break> &inner);
// Axes of one span each.
std::vector<KnotVectorPtr> simplest_axes(const FitDomain &domain);

} // namespace nrb::fit
