/* SPDX-License-Identifier: MIT */
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
    double at_least;
    double at_most;
};

/// Of two splines over the same domain.
inline Returned<Deviation> deviation(const Spline &f, const Spline &g) {
    Deviation result{};
    detail::call(nurbs_deviation, f.get(), g.get(), &result.at_least, &result.at_most);
    return result;
}

/// A spline, how often a knot was removed, and a bound of the distance to what was given.
struct KnotRemoval {
    Spline spline;
    std::int32_t removed;
    double bound;
};

/// Copies of a knot removed, as many as the tolerance allows.
inline Returned<KnotRemoval> remove_knot(const Spline &g, std::int32_t axis, double knot, std::int32_t times,
                                         double tolerance) {
    nurbs *made = nullptr;
    std::int32_t removed = 0;
    double bound = 0;
    detail::call(nurbs_remove_knot, g.get(), axis, knot, times, tolerance, &removed, &bound, &made);
    return KnotRemoval{Spline(made), removed, bound};
}

/// A spline within `bound` of the one it was made from.
struct Reduced {
    Spline spline;
    double bound;
};

/// As few knots as the tolerance allows, on one axis or on every one (-1).
inline Returned<Reduced> reduce_knots(const Spline &g, std::int32_t axis, double tolerance) {
    nurbs *made = nullptr;
    double bound = 0;
    detail::call(nurbs_reduce_knots, g.get(), axis, tolerance, &bound, &made);
    return Reduced{Spline(made), bound};
}

/// The closest spline of lower degree.
inline Returned<Reduced> reduce_degree(const Spline &g, std::int32_t axis, std::int32_t times) {
    nurbs *made = nullptr;
    double bound = 0;
    detail::call(nurbs_reduce_degree, g.get(), axis, times, &bound, &made);
    return Reduced{Spline(made), bound};
}

/// The simplest spline within the tolerance.
inline Returned<Reduced> simplify(const Spline &g, double tolerance) {
    nurbs *made = nullptr;
    double bound = 0;
    detail::call(nurbs_simplify, g.get(), tolerance, &bound, &made);
    return Reduced{Spline(made), bound};
}

} // namespace NURBS_CPP_POLICY
} // namespace libnurbs

#endif // NURBS_CPP_REDUCE_HPP
