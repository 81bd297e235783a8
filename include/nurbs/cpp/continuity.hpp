/* SPDX-License-Identifier: MIT */
/// \file continuity.hpp
/// \brief Continuity at knots and between ends.
#ifndef NURBS_CPP_CONTINUITY_HPP
#define NURBS_CPP_CONTINUITY_HPP

#include <nurbs/cpp/spline.hpp>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace libnurbs {
inline namespace NURBS_CPP_POLICY {

/// What counts as no gap: a distance, a part of a derivative, an angle.
struct ContinuityTolerances {
    double position = 0;
    double derivative = 0;
    double angle = 0;
};

/// One row for each place.
struct KnotContinuity {
    std::vector<double> knots;
    std::vector<std::int32_t> knot_orders;
    std::vector<std::int32_t> orders;
    std::vector<std::int32_t> geometric_orders;
    std::vector<double> position_gaps;
    std::vector<double> angles;
    std::vector<double> curvature_gaps;
};

/// Continuity at the knots of an axis and at its seam.
inline Returned<KnotContinuity> continuity(const Spline &g, std::int32_t axis,
                                           const ContinuityTolerances &allowed = {}) {
    std::int64_t count = 0;
    const auto call = [&](std::int64_t cap, KnotContinuity &r) {
        detail::call(nurbs_continuity, g.get(), axis, allowed.position, allowed.derivative, allowed.angle,
                     cap, r.knots.data(), r.knot_orders.data(), r.orders.data(), r.geometric_orders.data(),
                     r.position_gaps.data(), r.angles.data(), r.curvature_gaps.data(), &count);
    };
    KnotContinuity result;
    call(0, result);
    const auto n = static_cast<std::size_t>(count);
    for (auto *values : {&result.knots, &result.position_gaps, &result.angles, &result.curvature_gaps}) {
        values->resize(n);
    }
    for (auto *orders : {&result.knot_orders, &result.orders, &result.geometric_orders}) {
        orders->resize(n);
    }
    call(count, result);
    return result;
}

/// How two ends meet.
struct EndContinuity {
    std::int32_t order;
    std::int32_t geometric;
    double position_gap;
    double angle;
    double curvature_gap;
};

/// Continuity of two curves at one end of each.
inline Returned<EndContinuity> continuity_between(const Spline &a, std::int32_t end_a, const Spline &b,
                                                  std::int32_t end_b,
                                                  const ContinuityTolerances &allowed = {}) {
    EndContinuity r{};
    detail::call(nurbs_continuity_between, a.get(), end_a, b.get(), end_b, allowed.position,
                 allowed.derivative, allowed.angle, &r.order, &r.geometric, &r.position_gap, &r.angle,
                 &r.curvature_gap);
    return r;
}

} // namespace NURBS_CPP_POLICY
} // namespace libnurbs

#endif // NURBS_CPP_CONTINUITY_HPP
