// SPDX-License-Identifier: MIT
// Approximation of splines by simpler ones, with proof.
#pragma once

#include "spline/spline.h"

#include <vector>

namespace nrb::fit {

struct Approximation {
    SplinePtr spline;
    double bound; // of the distance at equal parameters, proven
};

// A polynomial spline of the given degrees with few control points, at most max_count if possible, that is
// proven to be within the tolerance of g over the whole domain; otherwise the closest one that was found.
// Samples of g are fitted (fit_tolerance.h), and the result is compared with g (bounds/deviation.h). Corners
// are those of g bit for bit, jumps and kinks stay where they are, and periodic axes stay periodic. A
// polynomial g of no higher degree is itself the result where it has fewer control points, or where nothing
// else is near enough. At the limit of work, a usual one unless the caller has set one, the closest spline
// found so far is taken. Throws Status::not_representable, not_converged where there is none by then, and
// what the comparison throws.
Approximation approximate(const SplinePtr &g, const std::vector<int> &degrees, double tolerance,
                          int64_t max_count);

} // namespace nrb::fit
