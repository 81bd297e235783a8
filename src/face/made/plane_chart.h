// SPDX-License-Identifier: MIT
// Plane parallelograms: surfaces whose parameters are affine functions of the point in space.
#pragma once

#include "face/made/curve_under.h"

#include <optional>
#include <vector>

namespace nrb::face {

class PlaneChart {
public:
    // Of a bilinear surface of equal weights, not degenerate, whose fourth corner is where the other three
    // put it, to rounding; none for others.
    static std::optional<PlaneChart> of(const Spline &surface);

    // The curve whose control points are those of the edge projected orthogonally to the plane, with the same
    // knots and weights. Its distance is that of the farthest control point from the plane (convex hull
    // property). Throws Status::gap if that exceeds the tolerance. Precondition: no negative weights, no
    // infinite control points.
    [[nodiscard]] MadeCurve curve_under(const Spline &edge, double tolerance) const;
    // The curve in space over a curve of the domain, from its control points, with its knots and weights.
    // Control points at corners of the domain become the corners of the surface bit for bit.
    [[nodiscard]] SplinePtr edge_over(const Spline &curve) const;
    // A bound on the distance in space of a curve in the domain and an edge at equal parameters; infinite if
    // their knots or weights differ.
    [[nodiscard]] double distance_between(const Spline &curve, const Spline &edge) const;

private:
    PlaneChart() = default;
    [[nodiscard]] Point2 place(const double *point) const noexcept;
    [[nodiscard]] double distance_of(const double *point, const Point2 &place) const noexcept;

    std::vector<double> corners_;     // all four, v fastest
    Point2 origin_{}, far_{};         // parameters of the first and the last corner
    std::vector<double> by_u_, by_v_; // the derivatives of the surface
    std::vector<double> to_u_, to_v_; // the rows of their pseudoinverse
};

} // namespace nrb::face
