/* SPDX-License-Identifier: MIT */
/// \file coons.hpp
/// \brief Surfaces and volumes from their boundaries.
#ifndef NURBS_CPP_COONS_HPP
#define NURBS_CPP_COONS_HPP

#include <nurbs/cpp/list.hpp>
#include <nurbs/cpp/placement.hpp>

#include <array>
#include <cstddef>
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

namespace detail {

template <std::size_t n>
std::array<const nurbs *, n> handles_of(const std::array<Spline, n> &splines) noexcept {
    std::array<const nurbs *, n> handles{};
    for (std::size_t i = 0; i < n; ++i) {
        handles[i] = splines[i].get();
    }
    return handles;
}

// Four handles, or NULL.
struct Cross {
    std::array<const nurbs *, 4> handles{};
    bool given;
    explicit Cross(const std::optional<FourCurves> &curves) : given(curves.has_value()) {
        if (given) {
            handles = handles_of(*curves);
        }
    }
    [[nodiscard]] const nurbs *const *get() const noexcept { return given ? handles.data() : nullptr; }
};

} // namespace detail

/// The four curves of a surface, or the six faces of a volume.
inline Returned<List> boundaries(const Spline &g) {
    nurbs_list *list = nullptr;
    detail::call(nurbs_boundaries, g.get(), &list);
    return List(list);
}

/// The bilinear blend of four curves.
inline Returned<Spline> coons(const FourCurves &boundaries, double tolerance = 0) {
    const auto handles = detail::handles_of(boundaries);
    return detail::spline_of(nurbs_surface_coons, handles.data(), tolerance);
}

/// The surface, and the largest difference between its twists and those of the cross tangents.
struct HermiteCoons {
    Spline spline;
    double bound;
};

/// The bicubic blend of four curves, derivatives across them (or none), and twists [4][dim] for twist_given.
inline Returned<HermiteCoons> coons_hermite(const FourCurves &boundaries,
                                            const std::optional<FourCurves> &cross, std::int32_t twist,
                                            double tolerance = 0, View<double> twists = {}) {
    const auto handles = detail::handles_of(boundaries);
    const detail::Cross across(cross);
    if (!twists.empty()) {
        detail::require_length(4 * detail::dimension(boundaries[0].get()), {twists});
    }
    double bound = 0;
    Spline spline = detail::spline_of(nurbs_surface_coons_hermite, handles.data(), across.get(), twist,
                                      detail::pointer(twists), tolerance, &bound);
    return HermiteCoons{spline, bound};
}

/// What does not meet at the corners (u0, v0), (u0, v1), (u1, v0), (u1, v1); tangents by u, then by v.
struct CoonsGaps {
    std::array<double, 4> positions;
    std::array<std::array<double, 2>, 4> tangents;
    std::array<double, 4> twists;
};

inline Returned<CoonsGaps> coons_gaps(const FourCurves &boundaries,
                                      const std::optional<FourCurves> &cross = {}) {
    const auto handles = detail::handles_of(boundaries);
    const detail::Cross across(cross);
    CoonsGaps gaps{};
    std::array<double, 8> tangents{};
    detail::call(nurbs_coons_gaps, handles.data(), across.get(), gaps.positions.data(), tangents.data(),
                 gaps.twists.data());
    for (std::size_t i = 0; i < tangents.size(); ++i) {
        gaps.tangents[i / 2][i % 2] = tangents[i];
    }
    return gaps;
}

/// The linear blend of six faces.
inline Returned<Spline> coons_volume(const SixFaces &faces, double tolerance = 0) {
    const auto handles = detail::handles_of(faces);
    return detail::spline_of(nurbs_volume_coons, handles.data(), tolerance);
}

} // namespace NURBS_CPP_POLICY
} // namespace libnurbs

#endif // NURBS_CPP_COONS_HPP
