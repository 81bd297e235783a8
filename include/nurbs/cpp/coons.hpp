/* SPDX-License-Identifier: MIT */
/* Generated from include/nurbs/nurbs.h and capi/bindings/table by: python3 cmake/interface/generate.py . - do not edit. */
/// \file coons.hpp
/// \brief Surfaces and volumes from their boundaries.
#ifndef NURBS_CPP_COONS_HPP
#define NURBS_CPP_COONS_HPP

#include <nurbs/cpp/list.hpp>
#include <nurbs/cpp/spline.hpp>

#include <array>
#include <cstdint>
#include <optional>

namespace libnurbs {
inline namespace NURBS_CPP_POLICY {

/// Twists of coons_hermite().
inline constexpr std::int32_t twist_compatible = NURBS_TWIST_COMPATIBLE;
inline constexpr std::int32_t twist_average = NURBS_TWIST_AVERAGE;
inline constexpr std::int32_t twist_given = NURBS_TWIST_GIVEN;
inline constexpr std::int32_t twist_zero = NURBS_TWIST_ZERO;
inline constexpr std::int32_t twist_bilinear = NURBS_TWIST_BILINEAR;
inline constexpr std::int32_t twist_adini = NURBS_TWIST_ADINI;

/// Four curves: at the start and the end of axis 0, then of axis 1.
using FourCurves = std::array<Spline, 4>;

/// Six surfaces: at the start and the end of axis 0, then of axes 1 and 2.
using SixFaces = std::array<Spline, 6>;

/// The four curves of a surface, or the six faces of a volume.
inline Returned<List> boundaries(const Spline &g) {
    return detail::made<List>(nurbs_boundaries, g.get());
}

/// The bilinear blend of four curves.
inline Returned<Spline> coons(const FourCurves &boundaries, double tolerance = 0) {
    return detail::made<Spline>(nurbs_surface_coons, detail::handle_list(boundaries).data(), tolerance);
}

/// The surface, and the largest difference between its twists and those of the cross tangents.
struct HermiteCoons {
    Spline spline; ///< The surface.
    double bound;  ///< The largest difference between its twists and those of the cross tangents.
};

/// The bicubic blend of four curves, derivatives across them (or none), and twists [4][dim] for twist_given.
inline Returned<HermiteCoons> coons_hermite(const FourCurves &boundaries,
                                            const std::optional<FourCurves> &cross, std::int32_t twist,
                                            double tolerance = 0, View<double> twists = {}) {
    detail::require_given(twists, 4 * detail::dimension(boundaries[0].get()), "vector");
    HermiteCoons made{};
    made.spline = detail::made<Spline>(nurbs_surface_coons_hermite, detail::handle_list(boundaries).data(),
                                       detail::pointer(detail::handle_list(cross)), twist,
                                       detail::pointer(twists), tolerance, &made.bound);
    return made;
}

/// What does not meet at the corners (u0, v0), (u0, v1), (u1, v0), (u1, v1); tangents by u, then by v.
struct CoonsGaps {
    std::array<double, 4> positions;               ///< Of the corners.
    std::array<std::array<double, 2>, 4> tangents; ///< Of the tangents at each corner.
    std::array<double, 4> twists;                  ///< Of the twists at each corner.
};

/// The differences at the corners of a surface to be.
inline Returned<CoonsGaps> coons_gaps(const FourCurves &boundaries,
                                      const std::optional<FourCurves> &cross = {}) {
    CoonsGaps found{};
    detail::call(nurbs_coons_gaps, detail::handle_list(boundaries).data(),
                 detail::pointer(detail::handle_list(cross)), found.positions.data(),
                 detail::flat(found.tangents), found.twists.data());
    return found;
}

/// The linear blend of six faces.
inline Returned<Spline> coons_volume(const SixFaces &faces, double tolerance = 0) {
    return detail::made<Spline>(nurbs_volume_coons, detail::handle_list(faces).data(), tolerance);
}

} // namespace NURBS_CPP_POLICY
} // namespace libnurbs

#endif // NURBS_CPP_COONS_HPP
