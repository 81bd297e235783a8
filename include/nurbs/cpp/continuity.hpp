/* SPDX-License-Identifier: MIT */
/* Generated from include/nurbs/nurbs.h and capi/bindings/table by: python3 cmake/interface/generate.py . - do not edit. */
/// \file continuity.hpp
/// \brief Continuity at knots and between ends.
#ifndef NURBS_CPP_CONTINUITY_HPP
#define NURBS_CPP_CONTINUITY_HPP

#include <nurbs/cpp/spline.hpp>

#include <cstdint>
#include <vector>

namespace libnurbs {
inline namespace NURBS_CPP_POLICY {

/// What counts as no gap: a distance, a part of a derivative, an angle.
struct ContinuityTolerances {
    double position = 0;   ///< Of points.
    double derivative = 0; ///< Of derivatives, relative to their size.
    double angle = 0;      ///< Of directions, in radians.
};

/// One row for each place.
struct KnotContinuity {
    std::vector<double> knots;                  ///< The knots inside the domain, and that of the seam.
    std::vector<std::int32_t> knot_orders;      ///< The orders that their multiplicities promise.
    std::vector<std::int32_t> orders;           ///< Of the derivatives.
    std::vector<std::int32_t> geometric_orders; ///< Of the shape.
    std::vector<double> position_gaps;          ///< The distances of the points.
    std::vector<double> angles;                 ///< The angles between the tangents or normals.
    std::vector<double> curvature_gaps;         ///< The differences of the curvatures.
};

/// Continuity at the knots of an axis and at its seam.
inline Returned<KnotContinuity> continuity(const Spline &g, std::int32_t axis,
                                           const ContinuityTolerances &allowed = {}) {
    KnotContinuity found{};
    std::int64_t count = 0;
    const auto ask = [&](std::int64_t cap) {
        detail::call(nurbs_continuity, g.get(), axis, allowed.position, allowed.derivative, allowed.angle,
                     cap, found.knots.data(), found.knot_orders.data(), found.orders.data(),
                     found.geometric_orders.data(), found.position_gaps.data(), found.angles.data(),
                     found.curvature_gaps.data(), &count);
    };
    ask(0);
    found.knots = detail::room(count);
    found.knot_orders = detail::room<std::int32_t>(count);
    found.orders = detail::room<std::int32_t>(count);
    found.geometric_orders = detail::room<std::int32_t>(count);
    found.position_gaps = detail::room(count);
    found.angles = detail::room(count);
    found.curvature_gaps = detail::room(count);
    ask(count);
    return found;
}

/// How two pieces meet.
struct EndContinuity {
    std::int32_t order;     ///< Of the derivatives.
    std::int32_t geometric; ///< Of the shape.
    double position_gap;    ///< The distance of the points.
    double angle;           ///< The angle between the tangents or normals.
    double curvature_gap;   ///< The difference of the curvatures.
};

/// Continuity of two curves at one end of each.
inline Returned<EndContinuity> continuity_between(const Spline &a, std::int32_t end_a, const Spline &b,
                                                  std::int32_t end_b,
                                                  const ContinuityTolerances &allowed = {}) {
    EndContinuity found{};
    detail::call(nurbs_continuity_between, a.get(), end_a, b.get(), end_b, allowed.position,
                 allowed.derivative, allowed.angle, &found.order, &found.geometric, &found.position_gap,
                 &found.angle, &found.curvature_gap);
    return found;
}

} // namespace NURBS_CPP_POLICY
} // namespace libnurbs

#endif // NURBS_CPP_CONTINUITY_HPP
