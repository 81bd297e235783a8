// SPDX-License-Identifier: MIT
// Splines by simpler ones.
#pragma once

#include "spline/spline.h"

#include <vector>

namespace nrb::fit {

struct Approximation {
    SplinePtr spline;
    double bound; // of the distance at equal parameters, proven
};

// A polynomial spline of the given degrees with few control points, at most max_count if that can be, that is proven to be
// within the tolerance of g over the whole domain; else the closest one that was met. Samples of g are fitted
// (fit_tolerance.h), and the result is compared with g (bounds/deviation.h). Corners are those of g bit for bit, jumps and
// kinks stay where they are, periodic axes stay periodic. A polynomial g of no higher degree is taken itself where it has fewer
// control points, or where nothing else is near enough. At a limit of work, a usual one unless the caller has set one, the
// closest one that was met by then is taken. Throws Status::not_representable, and what the comparison does.
Approximation approximate(const SplinePtr &g, const std::vector<int> &degrees, double tolerance,
                          int64_t max_count);

} // namespace nrb::fit
