// SPDX-License-Identifier: MIT
// The density of knots with which a spline approximates another one best.
#pragma once

#include "spline/spline.h"

#include <vector>

namespace nrb::fit {

// On an interval of length h a spline of degree p deviates from f by about |D^(p+1) f| h^(p+1). The errors on
// all intervals are therefore alike if each interval holds an equal part of the integral of
// |D^(p+1) f|^(1/(p+1)) (C. de Boor, "A practical guide to splines", 2001, chapter XII; R. Yeh, Y. Nashed, T.
// Peterka, X. Tricoche, "Fast automatic knot placement method for accurate B-spline curve fitting", CAD 128
// (2020)). For a spline f of degree p, that derivative is estimated from the jumps of the derivative of order
// p; across the other axes the largest estimate counts.
class KnotDensity {
public:
    // Multiple knots of `fine` stay as they are; the jumps there do not count.
    KnotDensity(const SplinePtr &fine, int axis);

    // The integral over the whole domain; it does not depend on the unit of the parameter.
    [[nodiscard]] double content() const noexcept { return sums_.back(); }
    // `count` increasing knots inside the domain; fewer where there are not so many doubles. The intervals
    // between them and the ends of the domain hold equal parts of the integral.
    [[nodiscard]] std::vector<double> knots(int64_t count) const;

private:
    std::vector<double> breaks_;
    std::vector<double> sums_; // of the density up to each break
};

} // namespace nrb::fit
