// SPDX-License-Identifier: MIT
// Where a spline that approximates another one needs its knots.
#pragma once

#include "spline/spline.h"

#include <vector>

namespace nrb::fit {

// Over an interval of length h a spline of degree p is off by about |D^(p+1) f| h^(p+1), so that the errors of all intervals
// are alike if each holds as much of the integral of |D^(p+1) f|^(1/(p+1)) as the others (C. de Boor, "A practical guide to
// splines", 2001, chapter XII; R. Yeh, Y. Nashed, T. Peterka, X. Tricoche, "Fast automatic knot placement method for accurate
// B-spline curve fitting", CAD 128 (2020)). Of a spline f of degree p that derivative is estimated from the jumps of the one
// of order p; across the other axes the largest one counts.
class KnotDensity {
public:
    // Knots of `fine` that are multiple stay as they are, and what jumps there does not count.
    KnotDensity(const SplinePtr &fine, int axis);

    // The whole integral, which does not depend on the unit of the parameter.
    [[nodiscard]] double content() const noexcept { return sums_.back(); }
    // Inside the domain, increasing; fewer where there are not so many doubles. The ends of the intervals between them hold
    // equal parts.
    [[nodiscard]] std::vector<double> knots(int64_t count) const;

private:
    std::vector<double> breaks_;
    std::vector<double> sums_; // of the density up to each break
};

} // namespace nrb::fit
