// SPDX-License-Identifier: MIT
// Curves of a face that are not given: in the domain under an edge, and in space over a curve of the domain.
#pragma once

#include "face/covering.h"
#include "spline/spline.h"

namespace nrb::face {

// A curve of the other kind over the same parameters.
struct MadeCurve {
    SplinePtr curve;
    double distance; // of the two in space at equal parameters, at most if `proven`, else the largest seen
    bool proven;
};

// The curve in the plane that covers the domain which the surface maps to an edge. On a bilinear surface that is a plane
// parallelogram exactly, from the control points of the edge; elsewhere through the nearest points to places of the edge, as many
// as the tolerance takes. Throws Status::gap if the edge is farther from the surface than the tolerance, not_converged.
// `prove`: whether the distance is to be a bound where that is possible.
MadeCurve curve_under(const SplinePtr &surface, const Covering &covering, const SplinePtr &edge,
                      double tolerance, bool prove);

// The curve in space that a curve in the plane is mapped to: composed exactly where its degree is at most max_degree and it stays
// in the domain, else through as many places as the tolerance takes.
MadeCurve edge_over(const SplinePtr &surface, const Covering &covering, const SplinePtr &curve,
                    double tolerance);

} // namespace nrb::face
