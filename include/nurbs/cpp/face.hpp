/* SPDX-License-Identifier: MIT */
/* Generated from include/nurbs/nurbs.h and capi/bindings/table by: python3 cmake/interface/generate.py . - do not edit. */
/// \file face.hpp
/// \brief Trimmed faces: the part of a surface that loops of curves bound.
#ifndef NURBS_CPP_FACE_HPP
#define NURBS_CPP_FACE_HPP

#include <nurbs/cpp/bounds.hpp>
#include <nurbs/cpp/intersections.hpp>
#include <nurbs/cpp/measure.hpp>
#include <nurbs/cpp/spline.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace libnurbs {
inline namespace NURBS_CPP_POLICY {

/// An edge of a face.
struct FaceEdge {
    Spline spline;    ///< The curve in space.
    std::int64_t key; ///< Its number, negative if it runs against the loop.
};

/// How far a curve of a loop and its edge are apart.
struct FaceDeviation {
    double distance; ///< The distance.
    bool proven;     ///< Whether it is a bound, not only the largest one seen.
};

/// The points of a face that are nearest to given points.
struct ClosestOnFace {
    std::vector<double> params;       ///< [n][2] on the surface.
    std::vector<double> points;       ///< [n][dim], as evaluation gives them.
    std::vector<double> distances;    ///< From the points that were given.
    std::vector<std::int32_t> status; ///< closest_ bits.
};

/// The smallest distance of two faces: between both bounds, at most that of two points.
struct FaceDistance {
    double at_least;                ///< From below.
    double at_most;                 ///< From above.
    std::array<double, 2> params_a; ///< [2] on the surface of the one.
    std::array<double, 2> params_b; ///< [2] on that of the other one.
    std::int32_t status;            ///< closest_certified, closest_budget.
};

/// How far the farthest point of a face is from another one, and the other way round.
struct FaceHausdorffDistance {
    std::array<double, 2> at_least; ///< [2]: from below.
    std::array<double, 2> at_most;  ///< [2]: from above.
    std::array<double, 2> params_a; ///< [2] of a point that is at_least[0] away.
    std::array<double, 2> params_b; ///< [2] of a point that is at_least[1] away.
    std::int32_t status;            ///< closest_certified, closest_budget.
};

/// Points and weights of a rule inside a face.
struct FaceQuadrature {
    std::vector<double> params;   ///< Parameters of the points.
    std::vector<double> weights;  ///< Weights of the parameters.
    std::vector<double> measures; ///< Weights of areas.
};

/// A trimmed face: a handle that is copied in constant time and freed by its destructor.
class Face : public detail::FaceHandle {
public:
    using FaceHandle::FaceHandle;

    // Trimmed faces: the part of a surface that loops of curves bound

    /// A face of a surface and loops of curves in its domain, edges in space, or both; sizes are the numbers of
    /// curves of the loops. Where a curve or an edge is missing, it is made. Without loops it is the whole
    /// surface.
    [[nodiscard]] static Returned<Face> create(const Spline &surface, View<std::int64_t> sizes,
                                               std::span<const Spline> curves = {},
                                               std::span<const Spline> edges = {},
                                               View<std::int64_t> keys = {}, double tolerance = 0,
                                               std::uint32_t flags = 0) {
        const std::int64_t total = detail::sum(sizes);
        detail::require_given(curves, total, "curves");
        detail::require_given(edges, total, "edges");
        detail::require_given(keys, total, "keys");
        return detail::made<Face>(nurbs_face_create, surface.get(), detail::length(sizes), sizes.data(),
                                  detail::pointer(detail::handle_list(curves)),
                                  detail::pointer(detail::handle_list(edges)), detail::pointer(keys),
                                  tolerance, flags, nullptr);
    }
    /// The same; `call` can watch and end it.
    [[nodiscard]] static Returned<Face> create(const Spline &surface, View<std::int64_t> sizes,
                                               std::span<const Spline> curves, std::span<const Spline> edges,
                                               View<std::int64_t> keys, double tolerance, std::uint32_t flags,
                                               const CallOptions &call) {
        const std::int64_t total = detail::sum(sizes);
        detail::require_given(curves, total, "curves");
        detail::require_given(edges, total, "edges");
        detail::require_given(keys, total, "keys");
        const detail::Watch watch(call);
        return detail::made<Face>(nurbs_face_create_with, surface.get(), detail::length(sizes), sizes.data(),
                                  detail::pointer(detail::handle_list(curves)),
                                  detail::pointer(detail::handle_list(edges)), detail::pointer(keys),
                                  tolerance, flags, nullptr, watch.get());
    }
    /// Its surface.
    [[nodiscard]] Returned<Spline> surface() const { return detail::made<Spline>(nurbs_face_surface, get()); }
    /// The number of curves of each loop.
    [[nodiscard]] Returned<std::vector<std::int64_t>> loops() const {
        std::vector<std::int64_t> values;
        std::int64_t count = 0;
        const auto ask = [&](std::int64_t cap) {
            detail::call(nurbs_face_loops, get(), cap, values.data(), &count);
        };
        ask(0);
        values = detail::room<std::int64_t>(count);
        ask(count);
        return values;
    }
    /// A curve of a loop in the domain of the surface, as it runs with the inside to its left.
    [[nodiscard]] Returned<Spline> curve(std::int64_t loop, std::int64_t index) const {
        return detail::made<Spline>(nurbs_face_curve, get(), loop, index);
    }
    /// The edge in space that belongs to a curve of a loop: the one that was given, or one that is made.
    [[nodiscard]] Returned<FaceEdge> edge(std::int64_t loop, std::int64_t index) const {
        FaceEdge made{};
        made.spline = detail::made<Spline>(nurbs_face_edge, get(), loop, index, &made.key);
        return made;
    }
    /// How far a curve of a loop, mapped by the surface, and its edge are apart.
    [[nodiscard]] Returned<FaceDeviation> deviation(std::int64_t loop, std::int64_t index) const {
        FaceDeviation found{};
        std::int32_t proven = 0;
        detail::call(nurbs_face_deviation, get(), loop, index, &found.distance, &proven);
        found.proven = proven != 0;
        return found;
    }
    /// The tolerance that it was created with.
    [[nodiscard]] Returned<double> tolerance() const {
        return detail::result_of<double>([&](auto *v) { return nurbs_face_tolerance(get(), v); });
    }
    /// On which side of the boundary parameters lie: 1 inside, 0 on the boundary, -1 outside.
    [[nodiscard]] Returned<std::vector<std::int32_t>> classify(Input params, double tolerance = 0) const {
        const std::int64_t n = detail::records(params, 2, "params");
        std::vector<std::int32_t> values = detail::room<std::int32_t>(n);
        detail::call(nurbs_face_classify, get(), n, params.data(), params.stride(), params.component_stride(),
                     tolerance, values.data());
        return values;
    }
    /// The same; `call` can watch and end it.
    [[nodiscard]] Returned<std::vector<std::int32_t>> classify(Input params, double tolerance,
                                                               const CallOptions &call) const {
        const std::int64_t n = detail::records(params, 2, "params");
        const detail::Watch watch(call);
        std::vector<std::int32_t> values = detail::room<std::int32_t>(n);
        detail::call(nurbs_face_classify_with, get(), n, params.data(), params.stride(),
                     params.component_stride(), tolerance, values.data(), watch.get());
        return values;
    }
    /// Where rays meet it first, with proof.
    [[nodiscard]] Returned<Rays> rays(Input origins, Input directions) const {
        const std::int64_t n = detail::records(origins, 3, "origins");
        directions.require(n, 3, "directions");
        Rays found{detail::room(n, 2), detail::room(n), detail::room<std::int32_t>(n)};
        detail::call(nurbs_face_rays, get(), n, origins.data(), origins.stride(), origins.component_stride(),
                     directions.data(), directions.stride(), directions.component_stride(),
                     found.params.data(), found.distances.data(), found.status.data());
        return found;
    }
    /// The same; `call` can watch and end it.
    [[nodiscard]] Returned<Rays> rays(Input origins, Input directions, const CallOptions &call) const {
        const std::int64_t n = detail::records(origins, 3, "origins");
        directions.require(n, 3, "directions");
        Rays found{detail::room(n, 2), detail::room(n), detail::room<std::int32_t>(n)};
        const detail::Watch watch(call);
        detail::call(nurbs_face_rays_with, get(), n, origins.data(), origins.stride(),
                     origins.component_stride(), directions.data(), directions.stride(),
                     directions.component_stride(), found.params.data(), found.distances.data(),
                     found.status.data(), watch.get());
        return found;
    }
    /// Its points that are nearest to given points, with proof.
    [[nodiscard]] Returned<ClosestOnFace> closest_points(Input points, double tolerance = 0) const {
        const std::int64_t dim = detail::dimension(get());
        const std::int64_t n = detail::records(points, dim, "points");
        ClosestOnFace found{detail::room(n, 2), detail::room(n, dim), detail::room(n),
                            detail::room<std::int32_t>(n)};
        detail::call(nurbs_face_closest_points, get(), n, points.data(), points.stride(),
                     points.component_stride(), tolerance, found.params.data(), found.points.data(),
                     found.distances.data(), found.status.data());
        return found;
    }
    /// The same; `call` can watch and end it.
    [[nodiscard]] Returned<ClosestOnFace> closest_points(Input points, double tolerance,
                                                         const CallOptions &call) const {
        const std::int64_t dim = detail::dimension(get());
        const std::int64_t n = detail::records(points, dim, "points");
        ClosestOnFace found{detail::room(n, 2), detail::room(n, dim), detail::room(n),
                            detail::room<std::int32_t>(n)};
        const detail::Watch watch(call);
        detail::call(nurbs_face_closest_points_with, get(), n, points.data(), points.stride(),
                     points.component_stride(), tolerance, found.params.data(), found.points.data(),
                     found.distances.data(), found.status.data(), watch.get());
        return found;
    }
    /// The smallest distance to another face, with proof; the points are at_most apart.
    [[nodiscard]] Returned<FaceDistance> distance(const Face &other, double tolerance = 0) const {
        FaceDistance found{};
        detail::call(nurbs_face_distance, get(), other.get(), tolerance, &found.at_least, &found.at_most,
                     found.params_a.data(), found.params_b.data(), &found.status);
        return found;
    }
    /// The same; `call` can watch and end it.
    [[nodiscard]] Returned<FaceDistance> distance(const Face &other, double tolerance,
                                                  const CallOptions &call) const {
        FaceDistance found{};
        const detail::Watch watch(call);
        detail::call(nurbs_face_distance_with, get(), other.get(), tolerance, &found.at_least, &found.at_most,
                     found.params_a.data(), found.params_b.data(), &found.status, watch.get());
        return found;
    }
    /// How far the points that are farthest from another face are from it, and the other way round.
    [[nodiscard]] Returned<FaceHausdorffDistance> hausdorff_distance(const Face &other,
                                                                     double tolerance) const {
        FaceHausdorffDistance found{};
        detail::call(nurbs_face_hausdorff_distance, get(), other.get(), tolerance, found.at_least.data(),
                     found.at_most.data(), found.params_a.data(), found.params_b.data(), &found.status);
        return found;
    }
    /// The same; `call` can watch and end it.
    [[nodiscard]] Returned<FaceHausdorffDistance> hausdorff_distance(const Face &other, double tolerance,
                                                                     const CallOptions &call) const {
        FaceHausdorffDistance found{};
        const detail::Watch watch(call);
        detail::call(nurbs_face_hausdorff_distance_with, get(), other.get(), tolerance, found.at_least.data(),
                     found.at_most.data(), found.params_a.data(), found.params_b.data(), &found.status,
                     watch.get());
        return found;
    }
    /// Its area.
    [[nodiscard]] Returned<Measured> area(double relative_tolerance = 0) const {
        Measured found{};
        detail::call(nurbs_face_area, get(), relative_tolerance, &found.value, &found.error);
        return found;
    }
    /// The same; `call` can watch and end it.
    [[nodiscard]] Returned<Measured> area(double relative_tolerance, const CallOptions &call) const {
        Measured found{};
        const detail::Watch watch(call);
        detail::call(nurbs_face_area_with, get(), relative_tolerance, &found.value, &found.error,
                     watch.get());
        return found;
    }
    /// Area, centroid and inertia about the centroid.
    [[nodiscard]] Returned<Moments> moments(double relative_tolerance = 0) const {
        const std::int64_t dim = detail::dimension(get());
        Moments found{0, detail::room(dim), detail::room(dim, dim), 0};
        detail::call_moments(
            [&](double *centroid, double *inertia) {
                return nurbs_face_moments(get(), relative_tolerance, &found.content, centroid, inertia,
                                          &found.error);
            },
            found.centroid, found.inertia);
        return found;
    }
    /// The same; `call` can watch and end it.
    [[nodiscard]] Returned<Moments> moments(double relative_tolerance, const CallOptions &call) const {
        const std::int64_t dim = detail::dimension(get());
        Moments found{0, detail::room(dim), detail::room(dim, dim), 0};
        const detail::Watch watch(call);
        detail::call_moments(
            [&](double *centroid, double *inertia) {
                return nurbs_face_moments_with(get(), relative_tolerance, &found.content, centroid, inertia,
                                               &found.error, watch.get());
            },
            found.centroid, found.inertia);
        return found;
    }
    /// Points and weights for integrals of any function over it: so many nodes along each axis of a cell, 0 for
    /// one more than the degree.
    [[nodiscard]] Returned<FaceQuadrature> quadrature(std::int32_t nodes = 0) const {
        FaceQuadrature found{};
        std::int64_t count = 0;
        const auto ask = [&](std::int64_t cap) {
            detail::call(nurbs_face_quadrature, get(), nodes, cap, found.params.data(), found.weights.data(),
                         found.measures.data(), &count);
        };
        ask(0);
        found.params = detail::room(count, 2);
        found.weights = detail::room(count);
        found.measures = detail::room(count);
        ask(count);
        return found;
    }
    /// The same; `call` can watch and end it.
    [[nodiscard]] Returned<FaceQuadrature> quadrature(std::int32_t nodes, const CallOptions &call) const {
        FaceQuadrature found{};
        const detail::Watch watch(call);
        std::int64_t count = 0;
        const auto ask = [&](std::int64_t cap) {
            detail::call(nurbs_face_quadrature_with, get(), nodes, cap, found.params.data(),
                         found.weights.data(), found.measures.data(), &count, watch.get());
        };
        ask(0);
        found.params = detail::room(count, 2);
        found.weights = detail::room(count);
        found.measures = detail::room(count);
        ask(count);
        return found;
    }
    /// An axis-aligned box that contains it; no side is farther from it than the tolerance.
    [[nodiscard]] Returned<Box> box(double tolerance = 0) const {
        const std::int64_t dim = detail::dimension(get());
        Box found{detail::room(dim), detail::room(dim), 0};
        detail::call(nurbs_face_box, get(), tolerance, found.lower.data(), found.upper.data(), &found.gap);
        return found;
    }
    /// The same; `call` can watch and end it.
    [[nodiscard]] Returned<Box> box(double tolerance, const CallOptions &call) const {
        const std::int64_t dim = detail::dimension(get());
        Box found{detail::room(dim), detail::room(dim), 0};
        const detail::Watch watch(call);
        detail::call(nurbs_face_box_with, get(), tolerance, found.lower.data(), found.upper.data(),
                     &found.gap, watch.get());
        return found;
    }
    /// The face of what to_bytes() made of it.
    [[nodiscard]] static Returned<Face> from_bytes(std::span<const std::byte> bytes) {
        return detail::made<Face>(nurbs_face_from_bytes, bytes.data(), detail::length(bytes));
    }
};

} // namespace NURBS_CPP_POLICY
} // namespace libnurbs

#endif // NURBS_CPP_FACE_HPP
