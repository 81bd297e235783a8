/* SPDX-License-Identifier: MIT */
/// \file parts.hpp
/// \brief Splines taken apart into lists, and joined again.
#ifndef NURBS_CPP_PARTS_HPP
#define NURBS_CPP_PARTS_HPP

#include <nurbs/cpp/list.hpp>
#include <nurbs/cpp/spline.hpp>

#include <cstdint>
#include <span>
#include <vector>

namespace libnurbs {
inline namespace NURBS_CPP_POLICY {

/// The polynomial pieces as Bezier splines over their own domains, last axis fastest.
inline Returned<List> decompose(const Spline &g) {
    nurbs_list *list = nullptr;
    detail::call(nurbs_decompose, g.get(), &list);
    return List(list);
}

/// The parts between the knots at which the order of continuity is less than `order`.
inline Returned<List> split_at_knots(const Spline &g, std::int32_t axis, std::int32_t order) {
    nurbs_list *list = nullptr;
    detail::call(nurbs_split_at_knots, g.get(), axis, order, &list);
    return List(list);
}

/// The joined spline, and the largest distance of two ends.
struct Joined {
    Spline spline;
    double gap;
};

/// Splines joined end to end along an axis.
inline Returned<Joined> join(std::span<const Spline> parts, std::int32_t axis, double tolerance = 0,
                             std::uint32_t flags = 0) {
    const std::vector<const nurbs *> handles = detail::handle_list(parts);
    nurbs *joined = nullptr;
    double gap = 0;
    detail::call(nurbs_join, detail::length(handles), handles.data(), axis, tolerance, flags, &gap, &joined);
    return Joined{Spline(joined), gap};
}

} // namespace NURBS_CPP_POLICY
} // namespace libnurbs

#endif // NURBS_CPP_PARTS_HPP
