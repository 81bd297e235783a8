/* SPDX-License-Identifier: MIT */
/* Generated from include/nurbs/nurbs.h and capi/bindings/table by: python3 cmake/interface/generate.py . - do not edit. */
/// \file frames.hpp
/// \brief Frames and curvature of curves and surfaces.
#ifndef NURBS_CPP_FRAMES_HPP
#define NURBS_CPP_FRAMES_HPP

#include <nurbs/cpp/spline.hpp>

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace libnurbs {
inline namespace NURBS_CPP_POLICY {

/// Bits of the status of a point.
inline constexpr std::int32_t frame_limit = NURBS_FRAME_LIMIT;
inline constexpr std::int32_t frame_normal_limit = NURBS_FRAME_NORMAL_LIMIT;
inline constexpr std::int32_t frame_rule = NURBS_FRAME_RULE;
inline constexpr std::int32_t frame_undefined = NURBS_FRAME_UNDEFINED;

/// Vectors [n][3], and the status of each point.
struct SurfaceFrames {
    std::vector<double> points;       ///< Points [n][3].
    std::vector<double> du;           ///< Derivatives along the first axis, [n][3].
    std::vector<double> dv;           ///< Derivatives along the second axis, [n][3].
    std::vector<double> normals;      ///< Unit normals [n][3].
    std::vector<std::int32_t> status; ///< Sums of frame_ bits, [n].
};

/// Where they are written. An output without elements is not wanted.
struct SurfaceFrameOutputs {
    Output points{};
    Output du{};
    Output dv{};
    Output normals{};
    std::span<std::int32_t> status{};
};

/// Points, derivatives and unit normals of a surface at parameters [n][2].
inline Returned<void> surface_frames(const Spline &g, Input params, const SurfaceFrameOutputs &out,
                                     std::uint32_t flags = 0) {
    const std::int64_t n = detail::records(params, 2, "params");
    detail::require_wanted(out.points, n, 3, "points");
    detail::require_wanted(out.du, n, 3, "du");
    detail::require_wanted(out.dv, n, 3, "dv");
    detail::require_wanted(out.normals, n, 3, "normals");
    detail::require_given(out.status, n, "status");
    return detail::call(nurbs_surface_eval_frames, g.get(), n, params.data(), params.stride(),
                        params.component_stride(), detail::pointer(out.points), out.points.stride(),
                        out.points.component_stride(), detail::pointer(out.du), out.du.stride(),
                        out.du.component_stride(), detail::pointer(out.dv), out.dv.stride(),
                        out.dv.component_stride(), detail::pointer(out.normals), out.normals.stride(),
                        out.normals.component_stride(), detail::pointer(out.status), flags);
}
/// The same, as vectors.
[[nodiscard]] inline Returned<SurfaceFrames> surface_frames(const Spline &g, Input params,
                                                            std::uint32_t flags = 0) {
    const std::int64_t n = detail::records(params, 2, "params");
    SurfaceFrames found{detail::room(n, 3), detail::room(n, 3), detail::room(n, 3), detail::room(n, 3),
                        detail::room<std::int32_t>(n)};
    detail::run([&] {
        return surface_frames(g, params, {found.points, found.du, found.dv, found.normals, found.status},
                              flags);
    });
    return found;
}

/// The same on the grid of the given parameters, one vector for each axis.
inline Returned<void> surface_grid_frames(const Spline &g, View<std::int64_t> counts, View<double> params,
                                          const SurfaceFrameOutputs &out, std::uint32_t flags = 0) {
    detail::require(counts, 2, "counts");
    detail::require_unless_negative(params, detail::sum(counts), "params");
    const std::int64_t net_size = detail::product<std::int64_t>(counts);
    detail::require_wanted(out.points, net_size, 3, "points");
    detail::require_wanted(out.du, net_size, 3, "du");
    detail::require_wanted(out.dv, net_size, 3, "dv");
    detail::require_wanted(out.normals, net_size, 3, "normals");
    detail::require_given(out.status, net_size, "status");
    return detail::call(nurbs_surface_eval_grid_frames, g.get(), counts.data(), params.data(),
                        detail::pointer(out.points), out.points.stride(), out.points.component_stride(),
                        detail::pointer(out.du), out.du.stride(), out.du.component_stride(),
                        detail::pointer(out.dv), out.dv.stride(), out.dv.component_stride(),
                        detail::pointer(out.normals), out.normals.stride(), out.normals.component_stride(),
                        detail::pointer(out.status), flags);
}
/// The same, as vectors.
[[nodiscard]] inline Returned<SurfaceFrames> surface_grid_frames(const Spline &g, View<std::int64_t> counts,
                                                                 View<double> params,
                                                                 std::uint32_t flags = 0) {
    detail::require(counts, 2, "counts");
    detail::require_unless_negative(params, detail::sum(counts), "params");
    const std::int64_t net_size = detail::product<std::int64_t>(counts);
    SurfaceFrames found{detail::room(net_size, 3), detail::room(net_size, 3), detail::room(net_size, 3),
                        detail::room(net_size, 3), detail::room<std::int32_t>(net_size)};
    detail::run([&] {
        return surface_grid_frames(g, counts, params,
                                   {found.points, found.du, found.dv, found.normals, found.status}, flags);
    });
    return found;
}

/// Curvatures of a surface, and the status of each point.
struct Curvatures {
    std::vector<double> principal;    ///< The larger first, [n][2].
    std::vector<double> directions;   ///< Their directions, [n][2][3].
    std::vector<double> mean;         ///< [n]
    std::vector<double> gaussian;     ///< [n]
    std::vector<std::int32_t> status; ///< Sums of frame_ bits, [n].
};

/// Where they are written. An output without elements is not wanted.
struct CurvatureOutputs {
    Output principal{};
    Output directions{};
    Output mean{};
    Output gaussian{};
    std::span<std::int32_t> status{};
};

/// Principal curvatures and directions, mean and Gaussian curvature of a surface at parameters [n][2].
inline Returned<void> surface_curvatures(const Spline &g, Input params, const CurvatureOutputs &out,
                                         std::uint32_t flags = 0) {
    const std::int64_t n = detail::records(params, 2, "params");
    detail::require_wanted(out.principal, n, 2, "principal");
    detail::require_wanted(out.directions, n, 6, "directions");
    detail::require_wanted(out.mean, n, 1, "mean");
    detail::require_wanted(out.gaussian, n, 1, "gaussian");
    detail::require_given(out.status, n, "status");
    return detail::call(nurbs_surface_eval_curvatures, g.get(), n, params.data(), params.stride(),
                        params.component_stride(), detail::pointer(out.principal), out.principal.stride(),
                        out.principal.component_stride(), detail::pointer(out.directions),
                        out.directions.stride(), out.directions.component_stride(), detail::pointer(out.mean),
                        out.mean.step(), detail::pointer(out.gaussian), out.gaussian.step(),
                        detail::pointer(out.status), flags);
}
/// The same, as vectors.
[[nodiscard]] inline Returned<Curvatures> surface_curvatures(const Spline &g, Input params,
                                                             std::uint32_t flags = 0) {
    const std::int64_t n = detail::records(params, 2, "params");
    Curvatures found{detail::room(n, 2), detail::room(n, 2, 3), detail::room(n), detail::room(n),
                     detail::room<std::int32_t>(n)};
    detail::run([&] {
        return surface_curvatures(
            g, params, {found.principal, found.directions, found.mean, found.gaussian, found.status}, flags);
    });
    return found;
}

/// Vectors [n][dim], the others [n]; in the plane binormals and torsions are empty.
struct CurveFrames {
    std::vector<double> points;       ///< Points [n][dim].
    std::vector<double> tangents;     ///< Unit tangents [n][dim].
    std::vector<double> normals;      ///< Principal normals [n][dim].
    std::vector<double> binormals;    ///< [n][3], in space only.
    std::vector<double> curvatures;   ///< [n]
    std::vector<double> torsions;     ///< [n], in space only.
    std::vector<std::int32_t> status; ///< Sums of frame_ bits, [n].
};

/// Where they are written. An output without elements is not wanted.
struct CurveFrameOutputs {
    Output points{};
    Output tangents{};
    Output normals{};
    Output binormals{};
    Output curvatures{};
    Output torsions{};
    std::span<std::int32_t> status{};
};

/// Frenet frames, curvatures and torsions of a curve at parameters [n].
inline Returned<void> curve_frames(const Spline &g, Input params, const CurveFrameOutputs &out,
                                   std::uint32_t flags = 0) {
    const std::int64_t n = detail::records(params, 1, "params");
    const std::int64_t dim = detail::dimension(g.get());
    detail::require_wanted(out.points, n, dim, "points");
    detail::require_wanted(out.tangents, n, dim, "tangents");
    detail::require_wanted(out.normals, n, dim, "normals");
    detail::require_wanted(out.binormals, n, 3, "binormals");
    detail::require_wanted(out.curvatures, n, 1, "curvatures");
    detail::require_wanted(out.torsions, n, 1, "torsions");
    detail::require_given(out.status, n, "status");
    return detail::call(nurbs_curve_eval_frames, g.get(), n, params.data(), params.step(),
                        detail::pointer(out.points), out.points.stride(), out.points.component_stride(),
                        detail::pointer(out.tangents), out.tangents.stride(), out.tangents.component_stride(),
                        detail::pointer(out.normals), out.normals.stride(), out.normals.component_stride(),
                        detail::pointer(out.binormals), out.binormals.stride(),
                        out.binormals.component_stride(), detail::pointer(out.curvatures),
                        out.curvatures.step(), detail::pointer(out.torsions), out.torsions.step(),
                        detail::pointer(out.status), flags);
}
/// The same, as vectors.
[[nodiscard]] inline Returned<CurveFrames> curve_frames(const Spline &g, Input params,
                                                        std::uint32_t flags = 0) {
    const std::int64_t n = detail::records(params, 1, "params");
    const std::int64_t dim = detail::dimension(g.get());
    CurveFrames found{detail::room(n, dim),
                      detail::room(n, dim),
                      detail::room(n, dim),
                      detail::room(dim == 3 ? n : 0, 3),
                      detail::room(n),
                      detail::room(dim == 3 ? n : 0),
                      detail::room<std::int32_t>(n)};
    detail::run([&] {
        return curve_frames(g, params,
                            {found.points, found.tangents, found.normals, found.binormals, found.curvatures,
                             found.torsions, found.status},
                            flags);
    });
    return found;
}

/// Vectors [n][3], and the status of each point.
struct MinimalFrames {
    std::vector<double> points;       ///< Points [n][3].
    std::vector<double> tangents;     ///< Unit tangents [n][3].
    std::vector<double> normals;      ///< [n][3]
    std::vector<double> binormals;    ///< [n][3]
    std::vector<std::int32_t> status; ///< Sums of frame_ bits, [n].
};

/// Where they are written. An output without elements is not wanted.
struct MinimalFrameOutputs {
    Output points{};
    Output tangents{};
    Output normals{};
    Output binormals{};
    std::span<std::int32_t> status{};
};

/// Frames along a sequence of parameters [n] that turn as little as possible.
inline Returned<void>
rotation_minimizing_frames(const Spline &g, Input params, const MinimalFrameOutputs &out,
                           const std::optional<std::array<double, 3>> &first_normal = {},
                           std::uint32_t flags = 0) {
    const std::int64_t n = detail::records(params, 1, "params");
    detail::require_wanted(out.points, n, 3, "points");
    detail::require_wanted(out.tangents, n, 3, "tangents");
    detail::require_wanted(out.normals, n, 3, "normals");
    detail::require_wanted(out.binormals, n, 3, "binormals");
    detail::require_given(out.status, n, "status");
    return detail::call(nurbs_curve_rotation_minimizing_frames, g.get(), n, params.data(), params.step(),
                        first_normal ? first_normal->data() : nullptr, detail::pointer(out.points),
                        out.points.stride(), out.points.component_stride(), detail::pointer(out.tangents),
                        out.tangents.stride(), out.tangents.component_stride(), detail::pointer(out.normals),
                        out.normals.stride(), out.normals.component_stride(), detail::pointer(out.binormals),
                        out.binormals.stride(), out.binormals.component_stride(), detail::pointer(out.status),
                        flags);
}
/// The same, as vectors.
[[nodiscard]] inline Returned<MinimalFrames>
rotation_minimizing_frames(const Spline &g, Input params,
                           const std::optional<std::array<double, 3>> &first_normal = {},
                           std::uint32_t flags = 0) {
    const std::int64_t n = detail::records(params, 1, "params");
    MinimalFrames found{detail::room(n, 3), detail::room(n, 3), detail::room(n, 3), detail::room(n, 3),
                        detail::room<std::int32_t>(n)};
    detail::run([&] {
        return rotation_minimizing_frames(
            g, params, {found.points, found.tangents, found.normals, found.binormals, found.status},
            first_normal, flags);
    });
    return found;
}

} // namespace NURBS_CPP_POLICY
} // namespace libnurbs

#endif // NURBS_CPP_FRAMES_HPP
