/* SPDX-License-Identifier: MIT */
/* Generated from include/nurbs/nurbs.h and capi/bindings/table by: python3 cmake/interface/generate.py . - do not edit. */
/// \file continuation.hpp
/// \brief Splines beyond their ends: extension, unclamped and periodic forms.
#ifndef NURBS_CPP_CONTINUATION_HPP
#define NURBS_CPP_CONTINUATION_HPP

#include <nurbs/cpp/spline.hpp>

#include <cstdint>

namespace libnurbs {
inline namespace NURBS_CPP_POLICY {

/// A spline extended beyond an end (start_of_axis or end_of_axis) by a Taylor polynomial.
inline Returned<Spline> extend(const Spline &g, std::int32_t axis, std::int32_t end, double amount,
                               std::int32_t order) {
    return detail::made<Spline>(nurbs_extend, g.get(), axis, end, amount, order);
}

/// The same shape with unclamped ends; with homogeneous_records also where weights do not stay positive.
inline Returned<Spline> unclamp(const Spline &g, std::int32_t axis,
                                std::uint32_t flags = NURBS_FORM_CLAMPED_START | NURBS_FORM_CLAMPED_END) {
    return detail::made<Spline>(nurbs_unclamp, g.get(), axis, flags);
}

/// A periodic spline, a proved bound of how far the shape moved, and the order of its seam.
struct PeriodicForm {
    Spline spline;      ///< The periodic spline.
    double deviation;   ///< How far its shape moved.
    std::int32_t order; ///< The order of continuity at the seam.
};

/// A closed spline made periodic.
inline Returned<PeriodicForm> make_periodic(const Spline &g, std::int32_t axis, double tolerance) {
    PeriodicForm made{};
    made.spline =
        detail::made<Spline>(nurbs_make_periodic, g.get(), axis, tolerance, &made.deviation, &made.order);
    return made;
}

/// Whether knots and points of an axis repeat.
inline Returned<bool> detect_periodic(const Spline &g, std::int32_t axis) {
    return detail::result_of<std::int32_t>(
               [&](auto *v) { return nurbs_detect_periodic(g.get(), axis, v); }) != 0;
}

} // namespace NURBS_CPP_POLICY
} // namespace libnurbs

#endif // NURBS_CPP_CONTINUATION_HPP
