/* SPDX-License-Identifier: MIT */
/* Generated from include/nurbs/nurbs.h and capi/bindings/table by: python3 cmake/interface/generate.py . - do not edit. */
/// \file reduce.hpp
/// \brief Operations that move the shape, each with a proven bound.
#ifndef NURBS_CPP_REDUCE_HPP
#define NURBS_CPP_REDUCE_HPP

#include <nurbs/cpp/spline.hpp>

#include <cstdint>

namespace libnurbs {
inline namespace NURBS_CPP_POLICY {

/// Proven bounds of a largest distance.
struct Deviation {
    double at_least; ///< A lower one.
    double at_most;  ///< An upper one.
};

/// Proven bounds of the largest distance of two splines over the same domain.
inline Returned<Deviation> deviation(const Spline &f, const Spline &g) {
    Deviation found{};
    detail::call(nurbs_deviation, f.get(), g.get(), &found.at_least, &found.at_most);
    return found;
}

/// A spline, how often a knot was removed, and a bound of the distance to what was given.
struct KnotRemoval {
    Spline spline;        ///< The spline.
    std::int32_t removed; ///< How often the knot was removed.
    double bound;         ///< A proven bound of how far it is from the one given.
};

/// Copies of a knot removed, as many as the tolerance allows.
inline Returned<KnotRemoval> remove_knot(const Spline &g, std::int32_t axis, double knot, std::int32_t times,
                                         double tolerance) {
    KnotRemoval made{};
    made.spline = detail::made<Spline>(nurbs_remove_knot, g.get(), axis, knot, times, tolerance,
                                       &made.removed, &made.bound);
    return made;
}

/// A spline within `bound` of the one it was made from.
struct Reduced {
    Spline spline; ///< The spline.
    double bound;  ///< A proven bound of how far it is from the one given.
};

/// As few knots as the tolerance allows, on one axis or on every one (-1).
inline Returned<Reduced> reduce_knots(const Spline &g, std::int32_t axis, double tolerance) {
    Reduced made{};
    made.spline = detail::made<Spline>(nurbs_reduce_knots, g.get(), axis, tolerance, &made.bound);
    return made;
}
/// The same; `call` can watch and end it.
inline Returned<Reduced> reduce_knots(const Spline &g, std::int32_t axis, double tolerance,
                                      const CallOptions &call) {
    Reduced made{};
    const detail::Watch watch(call);
    made.spline =
        detail::made<Spline>(nurbs_reduce_knots_with, g.get(), axis, tolerance, &made.bound, watch.get());
    return made;
}

/// The closest spline of lower degree.
inline Returned<Reduced> reduce_degree(const Spline &g, std::int32_t axis, std::int32_t times) {
    Reduced made{};
    made.spline = detail::made<Spline>(nurbs_reduce_degree, g.get(), axis, times, &made.bound);
    return made;
}
/// The same; `call` can watch and end it.
inline Returned<Reduced> reduce_degree(const Spline &g, std::int32_t axis, std::int32_t times,
                                       const CallOptions &call) {
    Reduced made{};
    const detail::Watch watch(call);
    made.spline =
        detail::made<Spline>(nurbs_reduce_degree_with, g.get(), axis, times, &made.bound, watch.get());
    return made;
}

/// The simplest spline within the tolerance.
inline Returned<Reduced> simplify(const Spline &g, double tolerance) {
    Reduced made{};
    made.spline = detail::made<Spline>(nurbs_simplify, g.get(), tolerance, &made.bound);
    return made;
}
/// The same; `call` can watch and end it.
inline Returned<Reduced> simplify(const Spline &g, double tolerance, const CallOptions &call) {
    Reduced made{};
    const detail::Watch watch(call);
    made.spline = detail::made<Spline>(nurbs_simplify_with, g.get(), tolerance, &made.bound, watch.get());
    return made;
}

/// A polynomial spline of given degrees with few control points, proven to be within the tolerance.
inline Returned<Reduced> approximate(const Spline &g, double tolerance, View<std::int32_t> degrees = {},
                                     std::int64_t max_count = 0) {
    detail::require_given(degrees, detail::axes(g.get()), "degrees");
    Reduced made{};
    made.spline = detail::made<Spline>(nurbs_approximate, g.get(), detail::pointer(degrees), tolerance,
                                       max_count, &made.bound);
    return made;
}
/// The same; `call` can watch and end it.
inline Returned<Reduced> approximate(const Spline &g, double tolerance, View<std::int32_t> degrees,
                                     std::int64_t max_count, const CallOptions &call) {
    detail::require_given(degrees, detail::axes(g.get()), "degrees");
    Reduced made{};
    const detail::Watch watch(call);
    made.spline = detail::made<Spline>(nurbs_approximate_with, g.get(), detail::pointer(degrees), tolerance,
                                       max_count, &made.bound, watch.get());
    return made;
}

} // namespace NURBS_CPP_POLICY
} // namespace libnurbs

#endif // NURBS_CPP_REDUCE_HPP
