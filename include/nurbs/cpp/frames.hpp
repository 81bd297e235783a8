/* SPDX-License-Identifier: MIT */
/// \file frames.hpp
/// \brief Frames and curvature of curves and surfaces.
#ifndef NURBS_CPP_FRAMES_HPP
#define NURBS_CPP_FRAMES_HPP

#include <nurbs/cpp/arrays.hpp>
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

/// Arrays to be filled; those left empty are not wanted.
struct SurfaceFrameOutputs {
    Output points{}, du{}, dv{}, normals{};
    std::span<std::int32_t> status{};
};
struct CurvatureOutputs {
    Output principal{}, directions{}, mean{}, gaussian{};
    std::span<std::int32_t> status{};
};
struct CurveFrameOutputs {
    Output points{}, tangents{}, normals{}, binormals{}, curvatures{}, torsions{};
    std::span<std::int32_t> status{};
};
struct MinimalFrameOutputs {
    Output points{}, tangents{}, normals{}, binormals{};
    std::span<std::int32_t> status{};
};

/// All of them, packed. Binormals and torsions of a curve in the plane are empty.
struct SurfaceFrames {
    std::vector<double> points, du, dv, normals;
    std::vector<std::int32_t> status;
};
struct Curvatures {
    std::vector<double> principal, directions, mean, gaussian;
    std::vector<std::int32_t> status;
};
struct CurveFrames {
    std::vector<double> points, tangents, normals, binormals, curvatures, torsions;
    std::vector<std::int32_t> status;
};
struct MinimalFrames {
    std::vector<double> points, tangents, normals, binormals;
    std::vector<std::int32_t> status;
};

namespace detail {

inline void require_wanted(const Output &out, std::int64_t n, std::int64_t width, const char *what) {
    if (!out.empty()) {
        out.require(n, width, what);
    }
}

inline void require_wanted(std::span<std::int32_t> status, std::int64_t n) {
    if (!status.empty() && length(status) != n) {
        wrong_size("status", status.size(), std::to_string(n));
    }
}

inline std::int64_t number_of(Input params, std::int64_t width) {
    const std::int64_t n = params.count(width, "params");
    params.require(n, width, "params");
    return n;
}

inline void require_wanted(const SurfaceFrameOutputs &out, std::int64_t n) {
    require_wanted(out.points, n, 3, "points");
    require_wanted(out.du, n, 3, "du");
    require_wanted(out.dv, n, 3, "dv");
    require_wanted(out.normals, n, 3, "normals");
    require_wanted(out.status, n);
}

inline SurfaceFrames room_for_frames(std::size_t n) {
    const std::vector<double> vectors(3 * n);
    return {vectors, vectors, vectors, vectors, std::vector<std::int32_t>(n)};
}

inline std::int64_t grid_size(View<std::int64_t> counts, View<double> params) {
    if (counts.size() != 2) {
        wrong_size("counts", counts.size(), "2");
    }
    const std::int64_t total = sum(counts);
    if (total >= 0 && length(params) != total) {
        wrong_size("params", params.size(), std::to_string(total));
    }
    return product<std::int64_t>(counts);
}

} // namespace detail

inline Returned<void> surface_frames(const Spline &g, Input params, const SurfaceFrameOutputs &out,
                                     std::uint32_t flags = 0) {
    const std::int64_t n = detail::number_of(params, 2);
    detail::require_wanted(out, n);
    return detail::call(
        nurbs_surface_eval_frames, g.get(), n, params.data(), params.stride(), params.component_stride(),
        out.points.data(), out.points.stride(), out.points.component_stride(), out.du.data(), out.du.stride(),
        out.du.component_stride(), out.dv.data(), out.dv.stride(), out.dv.component_stride(),
        out.normals.data(), out.normals.stride(), out.normals.component_stride(), out.status.data(), flags);
}
[[nodiscard]] inline Returned<SurfaceFrames> surface_frames(const Spline &g, Input params,
                                                            std::uint32_t flags = 0) {
    SurfaceFrames f = detail::room_for_frames(detail::to_size(detail::number_of(params, 2)));
    detail::run([&] {
        return surface_frames(g, params, {f.points, f.du, f.dv, f.normals, f.status}, flags);
    });
    return f;
}

inline Returned<void> surface_grid_frames(const Spline &g, View<std::int64_t> counts, View<double> params,
                                          const SurfaceFrameOutputs &out, std::uint32_t flags = 0) {
    detail::require_wanted(out, detail::grid_size(counts, params));
    return detail::call(nurbs_surface_eval_grid_frames, g.get(), counts.data(), params.data(),
                        out.points.data(), out.points.stride(), out.points.component_stride(), out.du.data(),
                        out.du.stride(), out.du.component_stride(), out.dv.data(), out.dv.stride(),
                        out.dv.component_stride(), out.normals.data(), out.normals.stride(),
                        out.normals.component_stride(), out.status.data(), flags);
}
[[nodiscard]] inline Returned<SurfaceFrames> surface_grid_frames(const Spline &g, View<std::int64_t> counts,
                                                                 View<double> params,
                                                                 std::uint32_t flags = 0) {
    SurfaceFrames f = detail::room_for_frames(detail::to_size(detail::grid_size(counts, params)));
    detail::run([&] {
        return surface_grid_frames(g, counts, params, {f.points, f.du, f.dv, f.normals, f.status}, flags);
    });
    return f;
}

inline Returned<void> surface_curvatures(const Spline &g, Input params, const CurvatureOutputs &out,
                                         std::uint32_t flags = 0) {
    const std::int64_t n = detail::number_of(params, 2);
    detail::require_wanted(out.principal, n, 2, "principal");
    detail::require_wanted(out.directions, n, 6, "directions");
    detail::require_wanted(out.mean, n, 1, "mean");
    detail::require_wanted(out.gaussian, n, 1, "gaussian");
    detail::require_wanted(out.status, n);
    return detail::call(nurbs_surface_eval_curvatures, g.get(), n, params.data(), params.stride(),
                        params.component_stride(), out.principal.data(), out.principal.stride(),
                        out.principal.component_stride(), out.directions.data(), out.directions.stride(),
                        out.directions.component_stride(), out.mean.data(), out.mean.step(),
                        out.gaussian.data(), out.gaussian.step(), out.status.data(), flags);
}
[[nodiscard]] inline Returned<Curvatures> surface_curvatures(const Spline &g, Input params,
                                                             std::uint32_t flags = 0) {
    const std::size_t n = detail::to_size(detail::number_of(params, 2));
    Curvatures c{std::vector<double>(2 * n), std::vector<double>(6 * n), std::vector<double>(n),
                 std::vector<double>(n), std::vector<std::int32_t>(n)};
    detail::run([&] {
        return surface_curvatures(g, params, {c.principal, c.directions, c.mean, c.gaussian, c.status},
                                  flags);
    });
    return c;
}

inline Returned<void> curve_frames(const Spline &g, Input params, const CurveFrameOutputs &out,
                                   std::uint32_t flags = 0) {
    const std::int64_t n = detail::number_of(params, 1);
    const std::int64_t dim = detail::dimension(g.get());
    detail::require_wanted(out.points, n, dim, "points");
    detail::require_wanted(out.tangents, n, dim, "tangents");
    detail::require_wanted(out.normals, n, dim, "normals");
    detail::require_wanted(out.binormals, n, 3, "binormals");
    detail::require_wanted(out.curvatures, n, 1, "curvatures");
    detail::require_wanted(out.torsions, n, 1, "torsions");
    detail::require_wanted(out.status, n);
    return detail::call(nurbs_curve_eval_frames, g.get(), n, params.data(), params.step(), out.points.data(),
                        out.points.stride(), out.points.component_stride(), out.tangents.data(),
                        out.tangents.stride(), out.tangents.component_stride(), out.normals.data(),
                        out.normals.stride(), out.normals.component_stride(), out.binormals.data(),
                        out.binormals.stride(), out.binormals.component_stride(), out.curvatures.data(),
                        out.curvatures.step(), out.torsions.data(), out.torsions.step(), out.status.data(),
                        flags);
}
[[nodiscard]] inline Returned<CurveFrames> curve_frames(const Spline &g, Input params,
                                                        std::uint32_t flags = 0) {
    const std::size_t n = detail::to_size(detail::number_of(params, 1));
    const std::size_t space = detail::dimension(g.get()) == 3 ? n : 0;
    const std::vector<double> vectors(n * detail::to_size(detail::dimension(g.get())));
    CurveFrames f{vectors,
                  vectors,
                  vectors,
                  std::vector<double>(3 * space),
                  std::vector<double>(n),
                  std::vector<double>(space),
                  std::vector<std::int32_t>(n)};
    detail::run([&] {
        return curve_frames(
            g, params, {f.points, f.tangents, f.normals, f.binormals, f.curvatures, f.torsions, f.status},
            flags);
    });
    return f;
}

inline Returned<void>
rotation_minimizing_frames(const Spline &g, Input params, const MinimalFrameOutputs &out,
                           const std::optional<std::array<double, 3>> &first_normal = {},
                           std::uint32_t flags = 0) {
    const std::int64_t n = detail::number_of(params, 1);
    detail::require_wanted(out.points, n, 3, "points");
    detail::require_wanted(out.tangents, n, 3, "tangents");
    detail::require_wanted(out.normals, n, 3, "normals");
    detail::require_wanted(out.binormals, n, 3, "binormals");
    detail::require_wanted(out.status, n);
    return detail::call(nurbs_curve_rotation_minimizing_frames, g.get(), n, params.data(), params.step(),
                        first_normal ? first_normal->data() : nullptr, out.points.data(), out.points.stride(),
                        out.points.component_stride(), out.tangents.data(), out.tangents.stride(),
                        out.tangents.component_stride(), out.normals.data(), out.normals.stride(),
                        out.normals.component_stride(), out.binormals.data(), out.binormals.stride(),
                        out.binormals.component_stride(), out.status.data(), flags);
}
[[nodiscard]] inline Returned<MinimalFrames>
rotation_minimizing_frames(const Spline &g, Input params,
                           const std::optional<std::array<double, 3>> &first_normal = {},
                           std::uint32_t flags = 0) {
    const std::size_t n = detail::to_size(detail::number_of(params, 1));
    const std::vector<double> vectors(3 * n);
    MinimalFrames f{vectors, vectors, vectors, vectors, std::vector<std::int32_t>(n)};
    detail::run([&] {
        return rotation_minimizing_frames(g, params, {f.points, f.tangents, f.normals, f.binormals, f.status},
                                          first_normal, flags);
    });
    return f;
}

} // namespace NURBS_CPP_POLICY
} // namespace libnurbs

#endif // NURBS_CPP_FRAMES_HPP
