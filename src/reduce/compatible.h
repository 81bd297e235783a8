// SPDX-License-Identifier: MIT
// Makes a set of splines compatible: one degree and one knot vector on every axis.
#pragma once

#include "spline/spline.h"

#include <span>

namespace nrb::reduce {

struct Compatible {
    std::vector<SplinePtr> splines;
    double deviation; // upper bound over the splines; 0 if no knot moved
};

// See nurbs_make_compatible(). Throws Status::tolerance, incompatible (numbers of axes, domains unless
// map_domains), multiplicity, and what reparametrize(), elevate() and refinement throw. Every table is
// computed once for all splines that share its knots. Cost: linear in the points of the result, plus sorting
// the distinct knot vectors.
Compatible make_compatible(std::span<const SplinePtr> splines, double tolerance, bool map_domains);

} // namespace nrb::reduce
