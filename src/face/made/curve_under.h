// SPDX-License-Identifier: MIT
// Curves of a face that are not given: in the domain under an edge, and in space over a curve of the domain.
#pragma once

#include "face/covering.h"
#include "face/made/effort.h"
#include "face/nearest_place.h"
#include "spline/spline.h"

namespace nrb::face {

// A curve of the other kind over the same parameters.
struct MadeCurve {
    SplinePtr curve;
    double distance; // of the two in space at equal parameters, at most if `proven`, else the largest seen
    bool proven;
};

// What a curve that is made may miss between the places that are looked at is left to the rest of the tolerance.
inline constexpr double share_of_fit = 0.5;

// How far an edge may be from the surface, how much farther from the image of the curve that is made, and whether that is to be
// proven where it is possible.
struct UnderRule {
    double tolerance;
    double precision;
    bool prove;
    NearestPlace nearest{}; // of the surface, if it is known
};

// The curve in the plane that covers the domain which the surface maps to an edge. On a bilinear surface that is a plane
// parallelogram exactly, from the control points of the edge; elsewhere through the nearest points to places of the edge, as many
// as the precision takes. Throws Status::gap if the edge is farther from the surface than the tolerance, not_converged.
MadeCurve curve_under(const SplinePtr &surface, const Covering &covering, const SplinePtr &edge,
                      const UnderRule &rule, Effort &effort);

// A proven bound on the distance in space of a curve in the domain and an edge at equal parameters, the same as when curve_under()
// made it; infinite if there is none.
double proven_distance(const SplinePtr &surface, const Covering &covering, const SplinePtr &curve,
                       const Spline &edge);

// The surface composed with a curve in its domain, on a plane parallelogram of the degree of the curve; null where the degree would be above
// max_degree, or the curve leaves the domain.
SplinePtr composed_edge(const SplinePtr &surface, const Covering &covering, const SplinePtr &curve);

// The curve in space that a curve in the plane is mapped to: composed exactly, between seams that it passes, where its degree is
// at most max_degree and it stays in the plane, else through as many places as the tolerance takes.
MadeCurve edge_over(const SplinePtr &surface, const Covering &covering, const SplinePtr &curve,
                    double tolerance);

} // namespace nrb::face
