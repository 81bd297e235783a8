// SPDX-License-Identifier: MIT
// Where a fit is wanted, and knots over it.
#pragma once

#include "base/limits.h"
#include "basis/knot_vector.h"

#include <array>
#include <vector>

namespace nrb::fit {

// A knot where polynomials of a degree meet: its multiplicity is the degree at a kink, one more at a jump.
struct Break {
    double param;
    int multiplicity;
};

// What a fit to a tolerance is over.
struct FitDomain {
    std::vector<int> degrees;
    std::vector<Interval> domains;
    std::array<bool, max_axes> periodic{};
    bool find_breaks = true;                           // kinks and jumps of curves become multiple knots
    std::array<std::vector<Break>, max_axes> breaks{}; // that are known; kept if there is room
    std::array<int, max_axes> seams{1, 1, 1};          // multiplicities of the ends of periodic axes
};

// Knots of an axis with those inside: clamped or periodic.
KnotVectorPtr axis_over(const FitDomain &domain, size_t k, const std::vector<Break> &inner);
// Of one span.
std::vector<KnotVectorPtr> simplest_axes(const FitDomain &domain);

} // namespace nrb::fit
