// SPDX-License-Identifier: MIT
// Curves of a face that are not given, made from their counterparts: in the domain under an edge (its
// preimage), and in space over a curve of the domain (its image).
#pragma once

#include "face/covering.h"
#include "face/made/effort.h"
#include "face/nearest_place.h"
#include "spline/spline.h"

namespace nrb::face {

// A curve of the other kind over the same parameters. distance: that of the two in space at equal parameters.
// It is a bound if `proven`, else the largest distance seen, which for curve_under() is what exceeds twice
// the distance of the edge from the surface.
struct MadeCurve {
    SplinePtr curve;
    double distance;
    bool proven;
};

// The share of a tolerance that the errors at samples of a curve that is made may take. The rest is left to
// errors between the samples.
inline constexpr double share_of_fit = 0.5;

// How far an edge may be from the surface (tolerance), how much farther than that from the image of the curve
// that is made (precision), and whether a bound is to be proven where that is possible.
struct UnderRule {
    double tolerance;
    double precision;
    bool prove;
    NearestPlace nearest{}; // of the surface, if it is known
};

// The curve in the plane that covers the domain which the surface maps to an edge. On a bilinear surface that
// is a plane parallelogram it is exact, made from the control points of the edge, if none of these is
// infinite or has a negative weight. Otherwise it interpolates foot points of as many places of the edge as
// the precision takes. Throws Status::gap if the edge is farther from the surface than the tolerance,
// not_converged.
MadeCurve curve_under(const SplinePtr &surface, const Covering &covering, const SplinePtr &edge,
                      const UnderRule &rule, Effort &effort);

// A proven bound on the distance in space of a curve in the domain and an edge at equal parameters; infinite
// if there is none. For a curve that curve_under() made it is the bound that was proven then.
double proven_distance(const SplinePtr &surface, const Covering &covering, const SplinePtr &curve,
                       const Spline &edge);

// The surface composed with a curve in its domain; on a plane parallelogram the result has the degree of the
// curve. Null where the degree of the curve times the sum of those of another surface is above max_degree, or
// where a control point of the curve is outside the domain.
SplinePtr composed_edge(const SplinePtr &surface, const Covering &covering, const SplinePtr &curve);

// The curve in space to which the surface maps a curve in the plane that covers the domain. It is composed
// exactly, part by part between the seams that it crosses, where composed_edge() exists for all parts and
// these meet to rounding; else it interpolates as many places as the tolerance takes.
MadeCurve edge_over(const SplinePtr &surface, const Covering &covering, const SplinePtr &curve,
                    double tolerance);

} // namespace nrb::face
