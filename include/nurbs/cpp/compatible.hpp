/* SPDX-License-Identifier: MIT */
/* Generated from include/nurbs/nurbs.h and capi/bindings/table by: python3 cmake/interface/generate.py . - do not edit. */
/// \file compatible.hpp
/// \brief Near-equal knots made equal, and sets of splines brought to one form.
#ifndef NURBS_CPP_COMPATIBLE_HPP
#define NURBS_CPP_COMPATIBLE_HPP

#include <nurbs/cpp/list.hpp>
#include <nurbs/cpp/spline.hpp>

#include <cstdint>
#include <span>

namespace libnurbs {
inline namespace NURBS_CPP_POLICY {

/// A spline, and a proved bound of how far its shape moved.
struct Snapped {
    Spline spline;    ///< The spline.
    double deviation; ///< A proved bound of how far its shape moved.
};

/// Knots within `tolerance` of the domain's length of each other become one.
inline Returned<Snapped> snap_knots(const Spline &g, std::int32_t axis, double tolerance) {
    Snapped made{};
    made.spline = detail::made<Spline>(nurbs_snap_knots, g.get(), axis, tolerance, &made.deviation);
    return made;
}

/// The splines in their order, and the largest bound.
struct Compatible {
    List splines;     ///< In their order.
    double deviation; ///< The largest bound of how far a shape moved.
};

/// Splines brought to one degree, domain and knot vector on every axis.
inline Returned<Compatible> make_compatible(std::span<const Spline> splines, double tolerance = 0,
                                            std::uint32_t flags = 0) {
    Compatible made{};
    made.splines = detail::made<List>(nurbs_make_compatible, detail::length(splines),
                                      detail::handle_list(splines).data(), tolerance, flags, &made.deviation);
    return made;
}

} // namespace NURBS_CPP_POLICY
} // namespace libnurbs

#endif // NURBS_CPP_COMPATIBLE_HPP
