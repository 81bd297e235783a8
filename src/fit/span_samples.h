// SPDX-License-Identifier: MIT
// Splines sampled at the same places of every span, and least-squares control points from such samples.
#pragma once

#include "spline/spline.h"

#include <array>
#include <vector>

namespace nrb::fit {

// The places in a span, from 0 to 1, at which polynomials of a degree are interpolated: the Chebyshev-Lobatto
// points, which include the ends so that splines meet at knots; the middle for degree 0.
class LocalNodes {
public:
    explicit LocalNodes(int degree);

    [[nodiscard]] const std::vector<double> &nodes() const noexcept { return nodes_; }
    // The nodes and, between each two of them, the place at which interpolation errs most. All are in rising
    // order: node i is number 2 i.
    [[nodiscard]] const std::vector<double> &with_checks() const noexcept { return all_; }

private:
    std::vector<double> nodes_;
    std::vector<double> all_;
};

// The values at places[k] of each non-empty span of axis k in the domain, each from the polynomial piece of
// its span. They are the control points [..][width()], last axis fastest, of the result. Throws
// Status::not_representable, overflow. Precondition: polynomial.
using Places = std::array<std::vector<double>, max_axes>;
SplinePtr sampled(const Spline &spline, const Places &places);

// The control points [..][width] over the axes of the spline that fit values at nodes[k] of each span of axis
// k. They are found by least squares along one axis after the other, by orthogonal rotations, so that a
// spline is reproduced up to rounding.
// All spans have the same weight. A control point is bounded by the spline on the largest span of its support
// (C. de Boor, "A practical guide to splines", 2001, chapter XI), so that the condition of the triangular
// factor depends only on the degree. The error of the fit is therefore at most a multiple of that of the best
// approximation (S. Demko, "Inverses of band matrices and local convergence of spline projections", SIAM J.
// Numer. Anal. 14 (1977)). If each control point were taken from a single span instead, the norm of the
// projection over uniform knots would be 10^5 at degree 7 and 10^11 at degree 12.
// Values at knots of multiplicity degree, where the shape may have a corner or an end, are interpolated.
// Control points with too little influence in the domain to be determined, as at unclamped ends, are drawn to
// a value nearby. Cost for each span: of the order of (degree + 1)^2 (degree + 1 + values along the other
// axes).
SplinePtr control_points(const Spline &spline, const std::vector<LocalNodes> &nodes,
                         std::vector<double> samples, int width);

// The same along axis k alone, from values [..][width] at the places of with_checks() on that axis and at the
// nodes of the others. The control points are fitted to the nodes; the result has the values of the fitted
// spline at all these places.
SplinePtr projected_along(const Spline &spline, int k, const std::vector<LocalNodes> &nodes,
                          std::vector<double> samples, int width);

} // namespace nrb::fit
