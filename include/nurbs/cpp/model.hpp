/* SPDX-License-Identifier: MIT */
/* Generated from include/nurbs/nurbs.h and capi/bindings/table by: python3 cmake/interface/generate.py . - do not edit. */
/// \file model.hpp
/// \brief Models: faces with the edges that they share, the vertices at which edges meet, and the parts to which they belong.
#ifndef NURBS_CPP_MODEL_HPP
#define NURBS_CPP_MODEL_HPP

#include <nurbs/cpp/face.hpp>
#include <nurbs/cpp/list.hpp>
#include <nurbs/cpp/measure.hpp>
#include <nurbs/cpp/spline.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace libnurbs {
inline namespace NURBS_CPP_POLICY {

/// Which side of a surface is kept of a face.
inline constexpr std::int32_t trim_front = NURBS_TRIM_FRONT;
inline constexpr std::int32_t trim_back = NURBS_TRIM_BACK;

/// On which side of the faces of a model a point is.
inline constexpr std::int32_t side_inside = NURBS_SIDE_INSIDE;
inline constexpr std::int32_t side_on = NURBS_SIDE_ON;
inline constexpr std::int32_t side_outside = NURBS_SIDE_OUTSIDE;
inline constexpr std::int32_t side_undecided = NURBS_SIDE_UNDECIDED;

/// What is inside of closed curves, by how often they go around it.
inline constexpr std::int32_t fill_non_zero = NURBS_FILL_NON_ZERO;
inline constexpr std::int32_t fill_even_odd = NURBS_FILL_EVEN_ODD;
inline constexpr std::int32_t fill_positive = NURBS_FILL_POSITIVE;

/// What is made of two regions.
inline constexpr std::int32_t region_union = NURBS_REGION_UNION;
inline constexpr std::int32_t region_intersection = NURBS_REGION_INTERSECTION;
inline constexpr std::int32_t region_difference = NURBS_REGION_DIFFERENCE;
inline constexpr std::int32_t region_either = NURBS_REGION_EITHER;

/// How much a model holds.
struct ModelCounts {
    std::int64_t parts;    ///< Number of parts.
    std::int64_t uses;     ///< Number of uses of parts.
    std::int64_t faces;    ///< Number of faces.
    std::int64_t edges;    ///< Number of edges.
    std::int64_t vertices; ///< Number of vertices.
};

/// A face of a model.
struct ModelFace {
    Face face;                    ///< The face.
    std::int64_t part;            ///< The part that it belongs to.
    std::int32_t shape;           ///< The kind of its surface: a shape, that of none for a spline.
    bool against;                 ///< Whether the outer normal is against that of the surface.
    std::array<double, 3> colour; ///< Red, green and blue from 0 to 1, NaN where the file gives none.
};

/// The solid that a face of a model bounds.
struct FaceSolid {
    std::int64_t solid;   ///< The number of the solid, -1 for none.
    std::int32_t in_void; ///< Whether the face belongs to a void of it.
};

/// An edge of a model.
struct ModelEdge {
    Spline spline;                        ///< Its curve.
    std::int64_t part;                    ///< The part that it belongs to.
    std::array<std::int64_t, 2> vertices; ///< Where its curve begins and ends, -1 for none.
    std::int32_t shape;                   ///< The kind of its curve: a shape, that of none for a spline.
};

/// How well faces meet at the edges of a model.
struct EdgeGaps {
    std::vector<std::int64_t> uses;    ///< How many uses each edge has, 1 where a face ends.
    std::vector<double> gaps;          ///< How far the curves of faces are from the edge, at most.
    std::vector<std::int32_t> bounded; ///< 1 if that is a bound, 0 if it is the largest distance seen.
};

/// A use of a part.
struct ModelUse {
    std::int64_t parent;                            ///< The part in which it is placed, -1 for the whole.
    std::int64_t part;                              ///< The part that is placed.
    std::array<std::array<double, 4>, 3> placement; ///< A point x of the part is at M x + t, rows of (M | t).
};

/// Where the parts of a model stand in the whole.
struct ModelInstances {
    std::vector<std::int64_t> parents; ///< The instance in which each stands, -1 for the whole.
    std::vector<std::int64_t> uses;    ///< The last use on the way to it.
    std::vector<std::int64_t> parts;   ///< The part of that use.
    /// [n][12]: a point x of the part is at M x + t, the three rows of (M | t).
    std::vector<double> placements;
};

/// Where rays meet a model first, at origin + t direction.
struct ModelRays {
    std::vector<double> params;       ///< [n][2] on the surface of the face, NaN without a hit or touch.
    std::vector<double> distances;    ///< t, in lengths of the direction; NaN without a hit or touch.
    std::vector<std::int32_t> status; ///< ray_ bits.
    std::vector<std::int64_t> places; ///< [n][2]: the face, and the instance of its part.
};

/// All places where a ray meets a model, by rising t.
struct ModelRayHits {
    std::vector<double> params;       ///< [n][2] on the surface of the face.
    std::vector<double> distances;    ///< t, in lengths of the direction.
    std::vector<std::int32_t> kinds;  ///< ray_hit or ray_touch each, and ray_back.
    std::vector<std::int64_t> places; ///< [n][2]: the face, and the instance of its part.
    bool complete;                    ///< Whether there are no others, and none is a touch.
};

/// The points of a model that are nearest to given points.
struct ClosestOnModel {
    std::vector<double> params;       ///< [n][2] on the surface of the face.
    std::vector<double> points;       ///< [n][3], in the whole.
    std::vector<double> distances;    ///< From the points that were given, in the whole.
    std::vector<std::int32_t> status; ///< closest_ bits.
    /// [n][2]: the face, and the instance of its part; -1 if there are no faces.
    std::vector<std::int64_t> places;
};

/// Faces and the edges that they share: a handle that is copied in constant time and freed by its destructor.
class Model : public detail::ModelHandle {
public:
    using ModelHandle::ModelHandle;

    // Models: faces with the edges that they share, the vertices at which edges meet, and the parts to which they belong

    /// Reads the faces, edges and vertices of a STEP or an IGES file from memory.
    [[nodiscard]] static Returned<Model> read(std::span<const std::byte> bytes,
                                              const ReadOptions &options = {}) {
        return detail::made<Model>(nurbs_read_model, bytes.data(), detail::length(bytes), &options);
    }
    /// The same; `call` can watch and end it.
    [[nodiscard]] static Returned<Model> read(std::span<const std::byte> bytes, const ReadOptions &options,
                                              const CallOptions &call) {
        const detail::Watch watch(call);
        return detail::made<Model>(nurbs_read_model_with, bytes.data(), detail::length(bytes), &options,
                                   watch.get());
    }
    /// Reads a STEP or an IGES file by its path.
    [[nodiscard]] static Returned<Model> read_file(const std::string &path, const ReadOptions &options = {}) {
        if (path.find('\0') != std::string::npos) {
            detail::fail(Status::file, "path contains a zero byte");
        }
        return detail::made<Model>(nurbs_read_model_file, path.c_str(), &options);
    }
    /// The same; `call` can watch and end it.
    [[nodiscard]] static Returned<Model> read_file(const std::string &path, const ReadOptions &options,
                                                   const CallOptions &call) {
        if (path.find('\0') != std::string::npos) {
            detail::fail(Status::file, "path contains a zero byte");
        }
        const detail::Watch watch(call);
        return detail::made<Model>(nurbs_read_model_file_with, path.c_str(), &options, watch.get());
    }
    /// A model of faces, with one part and one use of it. Faces with a common key share an edge.
    [[nodiscard]] static Returned<Model> create(std::span<const Face> faces, double metres = 0) {
        return detail::made<Model>(nurbs_model_create, detail::length(faces),
                                   detail::handle_list(faces).data(), metres);
    }
    /// A model of faces that do not know each other: pieces of their boundaries within the tolerance become
    /// common edges.
    [[nodiscard]] static Returned<Model> sew(std::span<const Face> faces, double tolerance,
                                             double metres = 0) {
        return detail::made<Model>(nurbs_model_sew, detail::length(faces), detail::handle_list(faces).data(),
                                   tolerance, metres);
    }
    /// The same; `call` can watch and end it.
    [[nodiscard]] static Returned<Model> sew(std::span<const Face> faces, double tolerance, double metres,
                                             const CallOptions &call) {
        const detail::Watch watch(call);
        return detail::made<Model>(nurbs_model_sew_with, detail::length(faces),
                                   detail::handle_list(faces).data(), tolerance, metres, watch.get());
    }
    /// The region that closed curves of the plane enclose, as faces without a common point inside: each curve
    /// begins where the one before it ends, or where that one closes a loop, a loop of its own. rule is one of
    /// the fill_ constants.
    [[nodiscard]] static Returned<Model> region(std::span<const Spline> curves,
                                                std::int32_t rule = fill_non_zero, double tolerance = 0) {
        return detail::made<Model>(nurbs_region_create, detail::length(curves),
                                   detail::handle_list(curves).data(), rule, tolerance);
    }
    /// The same; `call` can watch and end it.
    [[nodiscard]] static Returned<Model> region(std::span<const Spline> curves, std::int32_t rule,
                                                double tolerance, const CallOptions &call) {
        const detail::Watch watch(call);
        return detail::made<Model>(nurbs_region_create_with, detail::length(curves),
                                   detail::handle_list(curves).data(), rule, tolerance, watch.get());
    }
    /// The union, intersection or difference of two regions, each of which is what its faces cover. rule is one
    /// of the region_ constants.
    [[nodiscard]] static Returned<Model> combine(std::int32_t rule, std::span<const Face> a,
                                                 std::span<const Face> b, double tolerance = 0) {
        return detail::made<Model>(nurbs_region_combine, rule, detail::length(a),
                                   detail::handle_list(a).data(), detail::length(b),
                                   detail::handle_list(b).data(), tolerance);
    }
    /// The same; `call` can watch and end it.
    [[nodiscard]] static Returned<Model> combine(std::int32_t rule, std::span<const Face> a,
                                                 std::span<const Face> b, double tolerance,
                                                 const CallOptions &call) {
        const detail::Watch watch(call);
        return detail::made<Model>(nurbs_region_combine_with, rule, detail::length(a),
                                   detail::handle_list(a).data(), detail::length(b),
                                   detail::handle_list(b).data(), tolerance, watch.get());
    }
    /// The parts of a face that curves in the domain of its surface divide it into; they share edges.
    [[nodiscard]] static Returned<Model> split(const Face &face, std::span<const Spline> curves,
                                               double tolerance = 0) {
        return detail::made<Model>(nurbs_face_split, face.get(), detail::length(curves),
                                   detail::handle_list(curves).data(), tolerance);
    }
    /// The same; `call` can watch and end it.
    [[nodiscard]] static Returned<Model> split(const Face &face, std::span<const Spline> curves,
                                               double tolerance, const CallOptions &call) {
        const detail::Watch watch(call);
        return detail::made<Model>(nurbs_face_split_with, face.get(), detail::length(curves),
                                   detail::handle_list(curves).data(), tolerance, watch.get());
    }
    /// What of a face lies on one side of a surface, which divides it where both meet. side is one of the trim_
    /// constants.
    [[nodiscard]] static Returned<Model> trim(const Face &face, const Spline &surface, std::int32_t side,
                                              double tolerance) {
        return detail::made<Model>(nurbs_face_trim, face.get(), surface.get(), side, tolerance);
    }
    /// The same; `call` can watch and end it.
    [[nodiscard]] static Returned<Model> trim(const Face &face, const Spline &surface, std::int32_t side,
                                              double tolerance, const CallOptions &call) {
        const detail::Watch watch(call);
        return detail::made<Model>(nurbs_face_trim_with, face.get(), surface.get(), side, tolerance,
                                   watch.get());
    }
    /// How much it holds.
    [[nodiscard]] Returned<ModelCounts> counts() const {
        ModelCounts found{};
        detail::call(nurbs_model_counts, get(), &found.parts, &found.uses, &found.faces, &found.edges,
                     &found.vertices);
        return found;
    }
    /// A face.
    [[nodiscard]] Returned<ModelFace> face(std::int64_t index) const {
        ModelFace made{};
        std::int32_t against = 0;
        made.face = detail::made<Face>(nurbs_model_face, get(), index, &made.part, &made.shape, &against,
                                       made.colour.data());
        made.against = against != 0;
        return made;
    }
    /// The name of a face.
    [[nodiscard]] Returned<std::string> face_name(std::int64_t index) const {
        return detail::text_of([&](char *buf, std::int64_t cap, std::int64_t *length) {
            return nurbs_model_face_name(get(), index, buf, cap, length);
        });
    }
    /// The solid that a face bounds, -1 for none, and whether the face belongs to a void of it.
    [[nodiscard]] Returned<FaceSolid> face_solid(std::int64_t index) const {
        FaceSolid found{};
        detail::call(nurbs_model_face_solid, get(), index, &found.solid, &found.in_void);
        return found;
    }
    /// The layers that a face is in.
    [[nodiscard]] Returned<std::vector<std::int64_t>> face_layers(std::int64_t index) const {
        std::vector<std::int64_t> values;
        std::int64_t count = 0;
        const auto ask = [&](std::int64_t cap) {
            detail::call(nurbs_model_face_layers, get(), index, cap, values.data(), &count);
        };
        ask(0);
        values = detail::room<std::int64_t>(count);
        ask(count);
        return values;
    }
    /// An edge.
    [[nodiscard]] Returned<ModelEdge> edge(std::int64_t index) const {
        ModelEdge made{};
        made.spline = detail::made<Spline>(nurbs_model_edge, get(), index, &made.part, made.vertices.data(),
                                           &made.shape);
        return made;
    }
    /// Where faces use an edge: face, loop, and place in the loop; once at a free boundary, twice inside a shell.
    [[nodiscard]] Returned<std::vector<std::int64_t>> edge_uses(std::int64_t index) const {
        std::vector<std::int64_t> values;
        std::int64_t count = 0;
        const auto ask = [&](std::int64_t cap) {
            detail::call(nurbs_model_edge_uses, get(), index, cap, values.data(), &count);
        };
        ask(0);
        values = detail::room<std::int64_t>(count, 3);
        ask(count);
        return values;
    }
    /// How well faces meet at its edges: the number of uses of each, and how far the curves of faces are from it.
    [[nodiscard]] Returned<EdgeGaps> edge_gaps() const {
        EdgeGaps found{};
        std::int64_t count = 0;
        const auto ask = [&](std::int64_t cap) {
            detail::call(nurbs_model_edge_gaps, get(), cap, found.uses.data(), found.gaps.data(),
                         found.bounded.data(), &count);
        };
        ask(0);
        found.uses = detail::room<std::int64_t>(count);
        found.gaps = detail::room(count);
        found.bounded = detail::room<std::int32_t>(count);
        ask(count);
        return found;
    }
    /// The point of a vertex.
    [[nodiscard]] Returned<std::array<double, 3>> vertex(std::int64_t index) const {
        return detail::result_of<std::array<double, 3>>(
            [&](auto *v) { return nurbs_model_vertex(get(), index, v->data()); });
    }
    /// The name of a part.
    [[nodiscard]] Returned<std::string> part(std::int64_t index) const {
        return detail::text_of([&](char *buf, std::int64_t cap, std::int64_t *length) {
            return nurbs_model_part(get(), index, buf, cap, length);
        });
    }
    /// A use of a part: where it is placed.
    [[nodiscard]] Returned<ModelUse> use(std::int64_t index) const {
        ModelUse found{};
        detail::call(nurbs_model_use, get(), index, &found.parent, &found.part,
                     detail::flat(found.placement));
        return found;
    }
    /// Where the parts stand in the whole: each way through uses of parts in parts.
    [[nodiscard]] Returned<ModelInstances> instances() const {
        ModelInstances found{};
        std::int64_t count = 0;
        const auto ask = [&](std::int64_t cap) {
            detail::call(nurbs_model_instances, get(), cap, found.parents.data(), found.uses.data(),
                         found.parts.data(), found.placements.data(), &count);
        };
        ask(0);
        found.parents = detail::room<std::int64_t>(count);
        found.uses = detail::room<std::int64_t>(count);
        found.parts = detail::room<std::int64_t>(count);
        found.placements = detail::room(count, 12);
        ask(count);
        return found;
    }
    /// Where rays meet its faces first, with proof.
    [[nodiscard]] Returned<ModelRays> rays(View<double> origins, View<double> directions) const {
        const std::int64_t n = detail::records(origins, 3, "origins");
        detail::require(directions, 3 * n, "directions");
        ModelRays found{detail::room(n, 2), detail::room(n), detail::room<std::int32_t>(n),
                        detail::room<std::int64_t>(n, 2)};
        detail::call(nurbs_model_rays, get(), n, origins.data(), directions.data(), found.params.data(),
                     found.distances.data(), found.status.data(), found.places.data());
        return found;
    }
    /// The same; `call` can watch and end it.
    [[nodiscard]] Returned<ModelRays> rays(View<double> origins, View<double> directions,
                                           const CallOptions &call) const {
        const std::int64_t n = detail::records(origins, 3, "origins");
        detail::require(directions, 3 * n, "directions");
        ModelRays found{detail::room(n, 2), detail::room(n), detail::room<std::int32_t>(n),
                        detail::room<std::int64_t>(n, 2)};
        const detail::Watch watch(call);
        detail::call(nurbs_model_rays_with, get(), n, origins.data(), directions.data(), found.params.data(),
                     found.distances.data(), found.status.data(), found.places.data(), watch.get());
        return found;
    }
    /// All places where a ray meets its faces, by rising t.
    [[nodiscard]] Returned<ModelRayHits> ray_hits(const std::array<double, 3> &origin,
                                                  const std::array<double, 3> &direction,
                                                  View<double> range = {}) const {
        detail::require_given(range, 2, "range");
        ModelRayHits found{};
        std::int32_t complete = 0;
        std::int64_t count = 0;
        const auto ask = [&](std::int64_t cap) {
            detail::call(nurbs_model_ray_hits, get(), origin.data(), direction.data(), detail::pointer(range),
                         cap, found.params.data(), found.distances.data(), found.kinds.data(),
                         found.places.data(), &count, &complete);
        };
        ask(0);
        found.params = detail::room(count, 2);
        found.distances = detail::room(count);
        found.kinds = detail::room<std::int32_t>(count);
        found.places = detail::room<std::int64_t>(count, 2);
        ask(count);
        found.complete = complete != 0;
        return found;
    }
    /// The same; `call` can watch and end it.
    [[nodiscard]] Returned<ModelRayHits> ray_hits(const std::array<double, 3> &origin,
                                                  const std::array<double, 3> &direction, View<double> range,
                                                  const CallOptions &call) const {
        detail::require_given(range, 2, "range");
        ModelRayHits found{};
        const detail::Watch watch(call);
        std::int32_t complete = 0;
        std::int64_t count = 0;
        const auto ask = [&](std::int64_t cap) {
            detail::call(nurbs_model_ray_hits_with, get(), origin.data(), direction.data(),
                         detail::pointer(range), cap, found.params.data(), found.distances.data(),
                         found.kinds.data(), found.places.data(), &count, &complete, watch.get());
        };
        ask(0);
        found.params = detail::room(count, 2);
        found.distances = detail::room(count);
        found.kinds = detail::room<std::int32_t>(count);
        found.places = detail::room<std::int64_t>(count, 2);
        ask(count);
        found.complete = complete != 0;
        return found;
    }
    /// The points of its faces that are nearest to given points, with proof.
    [[nodiscard]] Returned<ClosestOnModel> closest_points(Input points, double tolerance = 0) const {
        const std::int64_t n = detail::records(points, 3, "points");
        ClosestOnModel found{detail::room(n, 2), detail::room(n, 3), detail::room(n),
                             detail::room<std::int32_t>(n), detail::room<std::int64_t>(n, 2)};
        detail::call(nurbs_model_closest_points, get(), n, points.data(), points.stride(),
                     points.component_stride(), tolerance, found.params.data(), found.points.data(),
                     found.distances.data(), found.status.data(), found.places.data());
        return found;
    }
    /// The same; `call` can watch and end it.
    [[nodiscard]] Returned<ClosestOnModel> closest_points(Input points, double tolerance,
                                                          const CallOptions &call) const {
        const std::int64_t n = detail::records(points, 3, "points");
        ClosestOnModel found{detail::room(n, 2), detail::room(n, 3), detail::room(n),
                             detail::room<std::int32_t>(n), detail::room<std::int64_t>(n, 2)};
        const detail::Watch watch(call);
        detail::call(nurbs_model_closest_points_with, get(), n, points.data(), points.stride(),
                     points.component_stride(), tolerance, found.params.data(), found.points.data(),
                     found.distances.data(), found.status.data(), found.places.data(), watch.get());
        return found;
    }
    /// Whether points are inside its solids: a side_ constant each.
    [[nodiscard]] Returned<std::vector<std::int32_t>> classify(Input points, double tolerance = 0) const {
        const std::int64_t n = detail::records(points, 3, "points");
        std::vector<std::int32_t> values = detail::room<std::int32_t>(n);
        detail::call(nurbs_model_classify, get(), n, points.data(), points.stride(),
                     points.component_stride(), tolerance, values.data());
        return values;
    }
    /// The same; `call` can watch and end it.
    [[nodiscard]] Returned<std::vector<std::int32_t>> classify(Input points, double tolerance,
                                                               const CallOptions &call) const {
        const std::int64_t n = detail::records(points, 3, "points");
        const detail::Watch watch(call);
        std::vector<std::int32_t> values = detail::room<std::int32_t>(n);
        detail::call(nurbs_model_classify_with, get(), n, points.data(), points.stride(),
                     points.component_stride(), tolerance, values.data(), watch.get());
        return values;
    }
    /// The area of all its faces where they stand.
    [[nodiscard]] Returned<Measured> area(double relative_tolerance = 0) const {
        Measured found{};
        detail::call(nurbs_model_area, get(), relative_tolerance, &found.value, &found.error);
        return found;
    }
    /// The same; `call` can watch and end it.
    [[nodiscard]] Returned<Measured> area(double relative_tolerance, const CallOptions &call) const {
        Measured found{};
        const detail::Watch watch(call);
        detail::call(nurbs_model_area_with, get(), relative_tolerance, &found.value, &found.error,
                     watch.get());
        return found;
    }
    /// The volume that its solids hold where they stand, with centroid and inertia.
    [[nodiscard]] Returned<EnclosedVolume> volume(double relative_tolerance = 0) const {
        EnclosedVolume found{};
        detail::call_moments(
            [&](double *centroid, double *inertia) {
                return nurbs_model_volume(get(), relative_tolerance, &found.volume, centroid, inertia,
                                          &found.openness, &found.error);
            },
            found.centroid, {detail::flat(found.inertia), 9});
        return found;
    }
    /// The same; `call` can watch and end it.
    [[nodiscard]] Returned<EnclosedVolume> volume(double relative_tolerance, const CallOptions &call) const {
        EnclosedVolume found{};
        const detail::Watch watch(call);
        detail::call_moments(
            [&](double *centroid, double *inertia) {
                return nurbs_model_volume_with(get(), relative_tolerance, &found.volume, centroid, inertia,
                                               &found.openness, &found.error, watch.get());
            },
            found.centroid, {detail::flat(found.inertia), 9});
        return found;
    }
    /// The curves and surfaces of a file that no face or edge consists of, with its unit and the notes on what
    /// was not read.
    [[nodiscard]] Returned<List> splines() const { return detail::made<List>(nurbs_model_splines, get()); }
    /// The layers that a curve or a surface is in which no face or edge consists of.
    [[nodiscard]] Returned<std::vector<std::int64_t>> spline_layers(std::int64_t index) const {
        std::vector<std::int64_t> values;
        std::int64_t count = 0;
        const auto ask = [&](std::int64_t cap) {
            detail::call(nurbs_model_spline_layers, get(), index, cap, values.data(), &count);
        };
        ask(0);
        values = detail::room<std::int64_t>(count);
        ask(count);
        return values;
    }
    /// How many layers faces and splines are in.
    [[nodiscard]] Returned<std::int64_t> layer_count() const {
        return detail::result_of<std::int64_t>([&](auto *v) { return nurbs_model_layer_count(get(), v); });
    }
    /// The name of a layer.
    [[nodiscard]] Returned<std::string> layer(std::int64_t index) const {
        return detail::text_of([&](char *buf, std::int64_t cap, std::int64_t *length) {
            return nurbs_model_layer(get(), index, buf, cap, length);
        });
    }
    /// Writes it to a file, which is replaced whole or not at all.
    Returned<void> write_file(const std::string &path, std::int32_t format,
                              const WriteOptions &options = {}) const {
        if (path.find('\0') != std::string::npos) {
            detail::fail(Status::file, "path contains a zero byte");
        }
        return detail::call(nurbs_model_write_file, get(), path.c_str(), format, &options);
    }
    /// The same; `call` can watch and end it.
    Returned<void> write_file(const std::string &path, std::int32_t format, const WriteOptions &options,
                              const CallOptions &call) const {
        if (path.find('\0') != std::string::npos) {
            detail::fail(Status::file, "path contains a zero byte");
        }
        const detail::Watch watch(call);
        return detail::call(nurbs_model_write_file_with, get(), path.c_str(), format, &options, watch.get());
    }
    /// The model of what to_bytes() made of it.
    [[nodiscard]] static Returned<Model> from_bytes(std::span<const std::byte> bytes) {
        return detail::made<Model>(nurbs_model_from_bytes, bytes.data(), detail::length(bytes));
    }
};

} // namespace NURBS_CPP_POLICY
} // namespace libnurbs

#endif // NURBS_CPP_MODEL_HPP
