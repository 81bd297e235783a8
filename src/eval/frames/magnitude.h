// SPDX-License-Identifier: MIT
// Models and knots so large or so small that products of derivatives leave the range of double precision:
// they are brought near 1 by powers of two, which changes no bit of what is then computed.
#pragma once

#include "eval/parameters.h"
#include "spline/scaled.h"

#include <functional>
#include <vector>

namespace nrb::eval {

// Whether the largest coordinate of the control points that are active together is 0 or within 2^-64 and 2^64
// everywhere, and every span too. Found once for a spline, by reading all of it. Preconditions of all
// functions here: 1 or 2 axes.
bool usual_magnitude(const Spline &spline);

// The largest |coordinate| of a control point that has influence on the domain; found at the same time.
double active_size(const Spline &spline);

// Parameters of a list, with the spline to evaluate at them instead of the given one. It is a copy of usual
// size, kept with the given spline; if no power of two makes all of the spline usual, it is a copy of the
// part that is active there.
struct MagnitudeRun {
    const Spline &spline;
    const AxisRules &rules;
    ConstRecords params;
    int64_t first; // in the order that is returned
    int size;      // the exponent of the factor by which the copy is larger
};

// Returns the numbers of the parameters in the order in which they were evaluated: span by span where there
// are parts.
std::vector<int64_t> for_each_magnitude(const Spline &spline, const AxisRules &rules, ConstRecords params,
                                        const std::function<void(const MagnitudeRun &)> &body);

} // namespace nrb::eval
