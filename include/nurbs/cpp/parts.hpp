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
#include <vector>

namespace libnurbs {
inline namespace NURBS_CPP_POLICY {

/// The polynomial pieces as Bezier splines over their own domains, last axis fastest.
inline Returned<List> decompose(const Spline &g) {
    return detail::made<List>(nurbs_decompose, g.get());
}

/// The polynomial pieces of a spline as arrays, last axis fastest in pieces and control points.
struct BezierPieces {
    std::vector<double> points;             ///< Control points of each piece.
    std::vector<double> weights;            ///< Their weights.
    std::vector<double> domains;            ///< The ends of the domain of each piece along each axis.
    std::vector<std::int64_t> piece_counts; ///< The number of pieces along each axis.
};

/// The polynomial pieces as arrays: the control points, weights and domains of all in one call.
inline Returned<BezierPieces> bezier_pieces(const Spline &g) {
    BezierPieces found{};
    std::int64_t count = 0;
    const auto ask = [&](std::int64_t cap) {
        detail::call(nurbs_bezier_pieces, g.get(), cap, found.points.data(), found.weights.data(),
                     found.domains.data(), found.piece_counts.data(), &count);
    };
    ask(0);
    found.points = detail::room(count, detail::active(g.get()), detail::dimension(g.get()));
    found.weights = detail::room(count, detail::active(g.get()));
    const std::int64_t axes = detail::axes(g.get());
    found.domains = detail::room(count, axes, 2);
    found.piece_counts = detail::room<std::int64_t>(axes);
    ask(count);
    return found;
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
