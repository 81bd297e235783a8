// SPDX-License-Identifier: MIT
// Splines sampled at the same places of every span, and control points from samples.
#pragma once

#include "spline/spline.h"

#include <array>
#include <vector>

namespace nrb::fit {

// Places in a span, from 0 to 1, at which polynomials of a degree are interpolated: Chebyshev's points with
// the ends, so that splines meet at knots; the middle for degree 0.
class LocalNodes {
public:
    explicit LocalNodes(int degree);

    [[nodiscard]] const std::vector<double> &nodes() const noexcept { return nodes_; }
    // The nodes, and between them, one fewer, the places at which interpolation errs most. All are in rising
    // order: node i is number 2 i.
    [[nodiscard]] const std::vector<double> &with_checks() const noexcept { return all_; }

private:
    std::vector<double> nodes_;
    std::vector<double> all_;
};

// The values, as control points, at places of each non-empty span of the domain, places[k] on axis k:
// [..][width()], last axis fastest, each from the polynomial piece of its span. Throws Status::not_representable, overflow.
// Precondition: polynomial.
using Places = std::array<std::vector<double>, max_axes>;
SplinePtr sampled(const Spline &spline, const Places &places);

// The control points [..][width] over the axes of the spline from values at nodes[k] of each span on axis k.
// They are found by least squares along one axis after the other, by orthogonal rotations, so that a spline
// is reproduced to rounding. All spans count the same. The condition of the triangular factor then depends
// only on the degree, since a control point is bounded by the spline on the largest span of its support (C.
// de Boor, "A practical guide to splines", 2001, chapter XI). So the error of the image is a multiple of the
// error of the best one (S. Demko, "Inverses of band matrices and local convergence of spline projections",
// SIAM J. Numer. Anal. 14 (1977)). If each control point were taken from one span, the norm over even knots
// would be 10^5 at degree 7 and 10^11 at degree 12. Values at knots of multiplicity degree, where the shape
// may have a corner or an end, are met. Control points that act too little in the domain to be found, as at
// ends that are not clamped, are drawn to a value nearby. Cost: of the order of (degree + 1)^2 (degree + 1 +
// values along the other axes) for each span.
SplinePtr control_points(const Spline &spline, const std::vector<LocalNodes> &nodes,
                         std::vector<double> samples, int width);

// The same along axis k alone, from values [..][width] at the places of with_checks() on that axis and at the
// nodes of the others: the values of the projected spline there.
SplinePtr projected_along(const Spline &spline, int k, const std::vector<LocalNodes> &nodes,
                          std::vector<double> samples, int width);

} // namespace nrb::fit
