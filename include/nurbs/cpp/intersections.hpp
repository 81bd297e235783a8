/* SPDX-License-Identifier: MIT */
/* Generated from include/nurbs/nurbs.h and capi/bindings/table by: python3 cmake/interface/generate.py . - do not edit. */
/// \file intersections.hpp
/// \brief Where shapes meet; every answer says whether it is complete.
#ifndef NURBS_CPP_INTERSECTIONS_HPP
#define NURBS_CPP_INTERSECTIONS_HPP

#include <nurbs/cpp/spline.hpp>

#include <cstdint>
#include <vector>

namespace libnurbs {
inline namespace NURBS_CPP_POLICY {

/// Kinds of hits.
inline constexpr std::int32_t hit_crossing = NURBS_HIT_CROSSING;
inline constexpr std::int32_t hit_tangent = NURBS_HIT_TANGENT;
inline constexpr std::int32_t hit_contact = NURBS_HIT_CONTACT;
inline constexpr std::int32_t hit_overlap = NURBS_HIT_OVERLAP;
inline constexpr std::int32_t hit_jump = NURBS_HIT_JUMP;
inline constexpr std::int32_t hit_undecided = NURBS_HIT_UNDECIDED;

/// Parameters in rising order, one hit_ constant each, and ranges [n][2] of parameters outside of which there
/// is no solution.
struct Hits {
    std::vector<double> params;      ///< In rising order.
    std::vector<std::int32_t> kinds; ///< One of the hit_ constants each.
    std::vector<double> ranges;      ///< [n] of lower and upper ends, outside of which there is no solution.
    bool complete;                   ///< Whether none of them is undecided.
};

/// Where a scalar curve has a value: its roots, with proof that there are no others.
inline Returned<Hits> roots(const Spline &g, double value = 0, double tolerance = 0) {
    Hits found{};
    std::int32_t complete = 0;
    std::int64_t count = 0;
    const auto ask = [&](std::int64_t cap) {
        detail::call(nurbs_roots, g.get(), value, tolerance, cap, found.params.data(), found.kinds.data(),
                     found.ranges.data(), &count, &complete);
    };
    ask(0);
    found.params = detail::room(count);
    found.kinds = detail::room<std::int32_t>(count);
    found.ranges = detail::room(count, 2);
    ask(count);
    found.complete = complete != 0;
    return found;
}
/// The same; `call` can watch and end it.
inline Returned<Hits> roots(const Spline &g, double value, double tolerance, const CallOptions &call) {
    Hits found{};
    const detail::Watch watch(call);
    std::int32_t complete = 0;
    std::int64_t count = 0;
    const auto ask = [&](std::int64_t cap) {
        detail::call(nurbs_roots_with, g.get(), value, tolerance, cap, found.params.data(),
                     found.kinds.data(), found.ranges.data(), &count, &complete, watch.get());
    };
    ask(0);
    found.params = detail::room(count);
    found.kinds = detail::room<std::int32_t>(count);
    found.ranges = detail::room(count, 2);
    ask(count);
    found.complete = complete != 0;
    return found;
}

/// Where a curve meets a line, a plane, a conic, a quadric or another set on which a polynomial of a degree
/// is 0; its coefficients are those of products x_i x_j ... with i <= j <= ..., in lexicographic order, where
/// x_dim stands for 1.
inline Returned<Hits> curve_level(const Spline &g, std::int32_t degree, View<double> coefficients,
                                  double tolerance = 0) {
    detail::require(coefficients, detail::monomials(detail::dimension(g.get()), degree), "coefficients");
    Hits found{};
    std::int32_t complete = 0;
    std::int64_t count = 0;
    const auto ask = [&](std::int64_t cap) {
        detail::call(nurbs_curve_level, g.get(), degree, coefficients.data(), tolerance, cap,
                     found.params.data(), found.kinds.data(), found.ranges.data(), &count, &complete);
    };
    ask(0);
    found.params = detail::room(count);
    found.kinds = detail::room<std::int32_t>(count);
    found.ranges = detail::room(count, 2);
    ask(count);
    found.complete = complete != 0;
    return found;
}
/// The same; `call` can watch and end it.
inline Returned<Hits> curve_level(const Spline &g, std::int32_t degree, View<double> coefficients,
                                  double tolerance, const CallOptions &call) {
    detail::require(coefficients, detail::monomials(detail::dimension(g.get()), degree), "coefficients");
    Hits found{};
    const detail::Watch watch(call);
    std::int32_t complete = 0;
    std::int64_t count = 0;
    const auto ask = [&](std::int64_t cap) {
        detail::call(nurbs_curve_level_with, g.get(), degree, coefficients.data(), tolerance, cap,
                     found.params.data(), found.kinds.data(), found.ranges.data(), &count, &complete,
                     watch.get());
    };
    ask(0);
    found.params = detail::room(count);
    found.kinds = detail::room<std::int32_t>(count);
    found.ranges = detail::room(count, 2);
    ask(count);
    found.complete = complete != 0;
    return found;
}

} // namespace NURBS_CPP_POLICY
} // namespace libnurbs

#endif // NURBS_CPP_INTERSECTIONS_HPP
