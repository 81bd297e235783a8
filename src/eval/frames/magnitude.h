// SPDX-License-Identifier: MIT
// Splines whose points or knots are so large or small that products of derivatives leave the range of double.
// They are brought near 1 by powers of two, which changes no bit of the results computed from them.
#pragma once

#include "eval/parameters.h"
#include "spline/scaled.h"

#include <functional>
#include <vector>

namespace nrb::eval {

// Whether a spline is of usual magnitude: in every window of control points that are active together the
// largest coordinate (and the largest weight of homogeneous records) is 0 or within 2^-64 and 2^64, and so is
// every span; and whether this is so for the spline moved to the origin (spline/at_origin.h). Found once for a
// spline, by reading all of it. Precondition of all functions here: 1 or 2 axes.
bool usual_magnitude(const Spline &spline);

// The largest |coordinate| of a control point that has influence on the domain. Found at the same time.
double active_size(const Spline &spline);

// The same of the spline whose copies or parts the runs below take: the given one or, if that is needed for
// usual magnitude, the one moved to the origin.
double size_of_runs(const Spline &spline);

// Some parameters of a list, with the spline to evaluate there instead of the given one. It is a scaled copy
// of usual magnitude, which is kept with the given spline. If no power of two makes all of the spline usual,
// it is a scaled copy of the part over the spans of these parameters. All runs of a spline, or none, are moved
// to the origin by the same vector.
struct MagnitudeRun {
    const Spline &spline;
    const AxisRules &rules;
    ConstRecords params;
    int64_t first; // place of the first parameter in the returned order
    int size;      // the copy is larger than the given spline by 2^size
};

// Divides the list into runs and calls body(run) for each. Returns the numbers of the parameters in the order
// in which they were evaluated: span by span if there are parts, else as given.
std::vector<int64_t> for_each_magnitude(const Spline &spline, const AxisRules &rules, ConstRecords params,
                                        const std::function<void(const MagnitudeRun &)> &body);

} // namespace nrb::eval
