/* SPDX-License-Identifier: MIT */
/// \file continuation.hpp
/// \brief Splines beyond their ends: extension, unclamped and periodic forms.
#ifndef NURBS_CPP_CONTINUATION_HPP
#define NURBS_CPP_CONTINUATION_HPP

#include <nurbs/cpp/spline.hpp>

#include <cstdint>

namespace libnurbs {
inline namespace NURBS_CPP_POLICY {

/// A spline extended beyond an end (NURBS_START or NURBS_END) by a Taylor polynomial.
inline Returned<Spline> extend(const Spline &g, std::int32_t axis, std::int32_t end, double amount,
                               std::int32_t order) {
    return detail::spline_of(nurbs_extend, g.get(), axis, end, amount, order);
}

/// The same shape with unclamped ends; with homogeneous_records also where weights do not stay positive.
inline Returned<Spline> unclamp(const Spline &g, std::int32_t axis,
                                std::uint32_t flags = NURBS_FORM_CLAMPED_START | NURBS_FORM_CLAMPED_END) {
    return detail::spline_of(nurbs_unclamp, g.get(), axis, flags);
}

/// A periodic spline, a proved bound of how far the shape moved, and the order of its seam.
struct PeriodicForm {
    Spline spline;
    double deviation;
    std::int32_t order;
};

/// A closed spline made periodic.
inline Returned<PeriodicForm> make_periodic(const Spline &g, std::int32_t axis, double tolerance) {
    nurbs *out = nullptr;
    double deviation = 0;
    std::int32_t order = 0;
    detail::call(nurbs_make_periodic, g.get(), axis, tolerance, &deviation, &order, &out);
    return PeriodicForm{Spline(out), deviation, order};
}

/// Whether knots and points of an axis repeat.
inline Returned<bool> detect_periodic(const Spline &g, std::int32_t axis) {
    std::int32_t repeats = 0;
    detail::call(nurbs_detect_periodic, g.get(), axis, &repeats);
    return repeats != 0;
}

} // namespace NURBS_CPP_POLICY
} // namespace libnurbs

#endif // NURBS_CPP_CONTINUATION_HPP
