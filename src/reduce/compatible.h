// SPDX-License-Identifier: MIT
// A set of splines brought to one degree and one knot vector on every axis.
#pragma once

#include "spline/spline.h"

#include <span>

namespace nrb::reduce {

struct Compatible {
    std::vector<SplinePtr> splines;
    double deviation; // largest bound for one spline; 0 if no knot moved
};

// See nurbs_make_compatible(). Throws Status::tolerance, incompatible (numbers of axes, domains unless
// map_domains), multiplicity, and what reparametrize(), elevate() and refining throw. Every table is made
// once for all splines that share its knots. Cost: linear in the points of the result, and the sorting of the
// distinct knot vectors.
Compatible make_compatible(std::span<const SplinePtr> splines, double tolerance, bool map_domains);

} // namespace nrb::reduce
