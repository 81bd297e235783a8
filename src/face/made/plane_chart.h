// SPDX-License-Identifier: MIT
// Surfaces that are plane parallelograms, whose parameters are affine functions of space.
#pragma once

#include "face/made/curve_under.h"

#include <optional>
#include <vector>

namespace nrb::face {

class PlaneChart {
public:
    // Of a bilinear surface of equal weights whose fourth corner is where the other three put it, to rounding; else none.
    static std::optional<PlaneChart> of(const Spline &surface);

    // From the control points of the edge, with its weights; the distance is that of the farthest of them from the plane. Throws
    // Status::gap if it exceeds the tolerance.
    [[nodiscard]] MadeCurve curve_under(const Spline &edge, double tolerance) const;
    // The curve in space over one of the domain, from its control points, with its knots and weights: on corners of the surface to the bit.
    [[nodiscard]] SplinePtr edge_over(const Spline &curve) const;
    // A bound on the distance in space of a curve in the domain and an edge at equal parameters; infinite if their knots or
    // weights differ.
    [[nodiscard]] double distance_between(const Spline &curve, const Spline &edge) const;

private:
    PlaneChart() = default;
    [[nodiscard]] Point2 place(const double *point) const noexcept;
    [[nodiscard]] double distance_of(const double *point, const Point2 &place) const noexcept;

    std::vector<double> corners_;     // all four, v first
    Point2 origin_{}, far_{};         // places of the first and the last of them
    std::vector<double> by_u_, by_v_; // what a unit of each parameter adds
    std::vector<double> to_u_, to_v_; // the rows of the inverse
};

} // namespace nrb::face
