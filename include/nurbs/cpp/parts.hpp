/* SPDX-License-Identifier: MIT */
/* Generated from include/nurbs/nurbs.h and capi/bindings/table by: python3 cmake/interface/generate.py . - do not edit. */
/// \file parts.hpp
/// \brief Splines taken apart into lists, and joined again.
#ifndef NURBS_CPP_PARTS_HPP
#define NURBS_CPP_PARTS_HPP

#include <nurbs/cpp/list.hpp>
#include <nurbs/cpp/spline.hpp>

#include <cstdint>
#include <span>

namespace libnurbs {
inline namespace NURBS_CPP_POLICY {

/// The polynomial pieces as Bezier splines over their own domains, last axis fastest.
inline Returned<List> decompose(const Spline &g) {
    return detail::made<List>(nurbs_decompose, g.get());
}

/// The parts between the knots at which the order of continuity is less than `order`.
inline Returned<List> split_at_knots(const Spline &g, std::int32_t axis, std::int32_t order) {
    return detail::made<List>(nurbs_split_at_knots, g.get(), axis, order);
}

/// The joined spline, and the largest distance of two ends.
struct Joined {
    Spline spline; ///< The joined spline.
    double gap;    ///< The largest distance of two ends.
};

/// Splines joined end to end along an axis.
inline Returned<Joined> join(std::span<const Spline> parts, std::int32_t axis, double tolerance = 0,
                             std::uint32_t flags = 0) {
    Joined made{};
    made.spline = detail::made<Spline>(nurbs_join, detail::length(parts), detail::handle_list(parts).data(),
                                       axis, tolerance, flags, &made.gap);
    return made;
}

} // namespace NURBS_CPP_POLICY
} // namespace libnurbs

#endif // NURBS_CPP_PARTS_HPP
