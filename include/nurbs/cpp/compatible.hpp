/* SPDX-License-Identifier: MIT */
/// \file compatible.hpp
/// \brief Near-equal knots made equal, and sets of splines brought to one form.
#ifndef NURBS_CPP_COMPATIBLE_HPP
#define NURBS_CPP_COMPATIBLE_HPP

#include <nurbs/cpp/list.hpp>
#include <nurbs/cpp/spline.hpp>

#include <cstdint>
#include <span>
#include <vector>

namespace libnurbs {
inline namespace NURBS_CPP_POLICY {

/// A spline, and a proved bound of how far its shape moved.
struct Snapped {
    Spline spline;
    double deviation;
};

/// Knots within `tolerance` of the domain's length of each other become one.
inline Returned<Snapped> snap_knots(const Spline &g, std::int32_t axis, double tolerance) {
    nurbs *out = nullptr;
    double deviation = 0;
    detail::call(nurbs_snap_knots, g.get(), axis, tolerance, &deviation, &out);
    return Snapped{Spline(out), deviation};
}

/// The splines in their order, and the largest bound.
struct Compatible {
    List splines;
    double deviation;
};

/// Splines brought to one degree, domain and knot vector on every axis.
inline Returned<Compatible> make_compatible(std::span<const Spline> splines, double tolerance = 0,
                                            std::uint32_t flags = 0) {
    const std::vector<const nurbs *> handles = detail::handle_list(splines);
    nurbs_list *list = nullptr;
    double deviation = 0;
    detail::call(nurbs_make_compatible, detail::length(handles), handles.data(), tolerance, flags, &deviation,
                 &list);
    return Compatible{List(list), deviation};
}

} // namespace NURBS_CPP_POLICY
} // namespace libnurbs

#endif // NURBS_CPP_COMPATIBLE_HPP
