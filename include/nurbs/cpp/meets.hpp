/* SPDX-License-Identifier: MIT */
/* Generated from include/nurbs/nurbs.h and capi/bindings/table by: python3 cmake/interface/generate.py . - do not edit. */
/// \file meets.hpp
/// \brief Curves where shapes meet, and the nodes where these end; every answer says whether it is complete.
#ifndef NURBS_CPP_MEETS_HPP
#define NURBS_CPP_MEETS_HPP

#include <nurbs/cpp/face.hpp>
#include <nurbs/cpp/model.hpp>
#include <nurbs/cpp/spline.hpp>

#include <array>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

namespace libnurbs {
inline namespace NURBS_CPP_POLICY {

/// What a node is.
inline constexpr std::int32_t node_border = NURBS_NODE_BORDER;
inline constexpr std::int32_t node_seam = NURBS_NODE_SEAM;
inline constexpr std::int32_t node_touch = NURBS_NODE_TOUCH;
inline constexpr std::int32_t node_undecided = NURBS_NODE_UNDECIDED;
inline constexpr std::int32_t node_edge = NURBS_NODE_EDGE;
inline constexpr std::int32_t node_fold = NURBS_NODE_FOLD;
inline constexpr std::int32_t node_overlap = NURBS_NODE_OVERLAP;

/// What a branch is.
inline constexpr std::int32_t branch_crossing = NURBS_BRANCH_CROSSING;
inline constexpr std::int32_t branch_edge = NURBS_BRANCH_EDGE;
inline constexpr std::int32_t branch_contact = NURBS_BRANCH_CONTACT;
inline constexpr std::int32_t branch_touch = NURBS_BRANCH_TOUCH;
inline constexpr std::int32_t branch_overlap = NURBS_BRANCH_OVERLAP;

/// Kinds of contours.
inline constexpr std::int32_t contour_silhouette = NURBS_CONTOUR_SILHOUETTE;
inline constexpr std::int32_t contour_perspective = NURBS_CONTOUR_PERSPECTIVE;
inline constexpr std::int32_t contour_isophote = NURBS_CONTOUR_ISOPHOTE;
inline constexpr std::int32_t contour_parabolic = NURBS_CONTOUR_PARABOLIC;

/// Kinds of reflection lines.
inline constexpr std::int32_t reflection_highlight = NURBS_REFLECTION_HIGHLIGHT;
inline constexpr std::int32_t reflection_along = NURBS_REFLECTION_ALONG;
inline constexpr std::int32_t reflection_from = NURBS_REFLECTION_FROM;

/// How much a meet holds.
struct MeetCounts {
    std::int64_t branches; ///< Number of branches.
    std::int64_t nodes;    ///< Number of nodes.
    bool complete;         ///< Whether it is proven that there is nothing else, no node being undecided.
};

/// What branches belong to, and where they end.
struct MeetBranches {
    std::vector<std::int64_t> levels; ///< Which plane, or value, each belongs to.
    /// [n][2]: the nodes at which it begins and ends, -1 where it closes.
    std::vector<std::int64_t> end_nodes;
    std::vector<std::int64_t> loops; ///< The closed way that it is a part of, counted from 0; -1 for none.
    std::vector<double> deviations;  ///< Proven bounds of the distances of its curves from the section.
};

/// Where branches end, and where there may be more than they tell.
struct MeetNodes {
    std::vector<std::int64_t> levels; ///< Which plane, or value, each belongs to.
    std::vector<std::int32_t> kinds;  ///< One of the node_ constants each.
    std::vector<double> params;       ///< [n][2] of the surface; of a part its middle.
    /// [n][2][2] of parameters: the lower and upper end of the part on each axis.
    std::vector<double> ranges;
};

/// Where nodes are on the second of two surfaces.
struct MeetPlaces {
    std::vector<double> params; ///< [n][2] of the surface; of a part its middle.
    /// [n][2][2] of parameters: the lower and upper end of the part on each axis.
    std::vector<double> ranges;
};

/// Branches one after the other, each of which goes on where the one before ends.
struct MeetWays {
    std::vector<std::int64_t> levels; ///< Which plane, or value, each belongs to.
    std::vector<std::int64_t> firsts; ///< The first branch.
    std::vector<std::int64_t> sizes;  ///< The number of branches.
    std::vector<std::int32_t> closed; ///< 1 for a way that closes, else 0.
    std::vector<double> gaps; ///< The largest distances in space between ends that go on in each other.
};

/// The faces of a model on which branches are; -1 in a meet of one surface.
struct MeetFaces {
    std::vector<std::int64_t> faces;     ///< The faces.
    std::vector<std::int64_t> instances; ///< The instances of their parts.
};

/// How ways go on at nodes, and the faces of a model on which these are.
struct MeetJoints {
    /// The node of the branch that goes on, or that came here; -1: none.
    std::vector<std::int64_t> next_nodes;
    std::vector<double> gaps;            ///< How far apart in space the ends of both branches are.
    std::vector<std::int64_t> faces;     ///< The faces; -1 in a meet of one surface.
    std::vector<std::int64_t> instances; ///< The instances of their parts.
};

/// Curves where shapes meet: a handle that is copied in constant time and freed by its destructor.
class Meet : public detail::MeetHandle {
public:
    using MeetHandle::MeetHandle;

    // Curves where shapes meet, and the nodes where these end; every answer says whether it is complete

    /// Where planes normal . x = offset cut a surface: all curves to within a tolerance, proven to be all.
    [[nodiscard]] static Returned<Meet> sections(const Spline &g, const std::array<double, 3> &normal,
                                                 View<double> offsets, double tolerance) {
        return detail::made<Meet>(nurbs_surface_sections, g.get(), normal.data(), detail::length(offsets),
                                  offsets.data(), tolerance);
    }
    /// The same; `call` can watch and end it.
    [[nodiscard]] static Returned<Meet> sections(const Spline &g, const std::array<double, 3> &normal,
                                                 View<double> offsets, double tolerance,
                                                 const CallOptions &call) {
        const detail::Watch watch(call);
        return detail::made<Meet>(nurbs_surface_sections_with, g.get(), normal.data(),
                                  detail::length(offsets), offsets.data(), tolerance, watch.get());
    }
    /// Silhouettes, isophotes of some angles, and parabolic curves of a surface: all of them, proven to be all.
    [[nodiscard]] static Returned<Meet> contours(const Spline &g, std::int32_t kind,
                                                 const std::optional<std::array<double, 3>> &d,
                                                 View<double> cosines, double tolerance) {
        return detail::made<Meet>(nurbs_surface_contours, g.get(), kind, d ? d->data() : nullptr,
                                  detail::length(cosines), cosines.data(), tolerance);
    }
    /// The same; `call` can watch and end it.
    [[nodiscard]] static Returned<Meet> contours(const Spline &g, std::int32_t kind,
                                                 const std::optional<std::array<double, 3>> &d,
                                                 View<double> cosines, double tolerance,
                                                 const CallOptions &call) {
        const detail::Watch watch(call);
        return detail::made<Meet>(nurbs_surface_contours_with, g.get(), kind, d ? d->data() : nullptr,
                                  detail::length(cosines), cosines.data(), tolerance, watch.get());
    }
    /// Lines of light that a surface mirrors, or that its normals meet: all of them, proven to be all.
    [[nodiscard]] static Returned<Meet> reflections(const Spline &g, std::int32_t kind,
                                                    const std::optional<std::array<double, 3>> &eye,
                                                    const std::array<double, 3> &direction, Input points,
                                                    double tolerance) {
        const std::int64_t n = detail::records(points, 3, "points");
        return detail::made<Meet>(nurbs_surface_reflections, g.get(), kind, eye ? eye->data() : nullptr,
                                  direction.data(), n, points.data(), points.stride(),
                                  points.component_stride(), tolerance);
    }
    /// The same; `call` can watch and end it.
    [[nodiscard]] static Returned<Meet> reflections(const Spline &g, std::int32_t kind,
                                                    const std::optional<std::array<double, 3>> &eye,
                                                    const std::array<double, 3> &direction, Input points,
                                                    double tolerance, const CallOptions &call) {
        const std::int64_t n = detail::records(points, 3, "points");
        const detail::Watch watch(call);
        return detail::made<Meet>(nurbs_surface_reflections_with, g.get(), kind, eye ? eye->data() : nullptr,
                                  direction.data(), n, points.data(), points.stride(),
                                  points.component_stride(), tolerance, watch.get());
    }
    /// Where an implicit polynomial of space vanishes on a surface, proven to be all.
    [[nodiscard]] static Returned<Meet> level(const Spline &g, std::int32_t degree, View<double> coefficients,
                                              double tolerance) {
        detail::require(coefficients, detail::monomials(detail::dimension(g.get()), degree), "coefficients");
        return detail::made<Meet>(nurbs_surface_level, g.get(), degree, coefficients.data(), tolerance);
    }
    /// The same; `call` can watch and end it.
    [[nodiscard]] static Returned<Meet> level(const Spline &g, std::int32_t degree, View<double> coefficients,
                                              double tolerance, const CallOptions &call) {
        detail::require(coefficients, detail::monomials(detail::dimension(g.get()), degree), "coefficients");
        const detail::Watch watch(call);
        return detail::made<Meet>(nurbs_surface_level_with, g.get(), degree, coefficients.data(), tolerance,
                                  watch.get());
    }
    /// Where a scalar spline over a surface has given values, proven to be all.
    [[nodiscard]] static Returned<Meet> level_curves(const Spline &g, const Spline &scalar,
                                                     View<double> values, double tolerance) {
        return detail::made<Meet>(nurbs_surface_level_curves, g.get(), scalar.get(), detail::length(values),
                                  values.data(), tolerance);
    }
    /// The same; `call` can watch and end it.
    [[nodiscard]] static Returned<Meet> level_curves(const Spline &g, const Spline &scalar,
                                                     View<double> values, double tolerance,
                                                     const CallOptions &call) {
        const detail::Watch watch(call);
        return detail::made<Meet>(nurbs_surface_level_curves_with, g.get(), scalar.get(),
                                  detail::length(values), values.data(), tolerance, watch.get());
    }
    /// Where two surfaces meet in curves, proven to be all.
    [[nodiscard]] static Returned<Meet> surfaces(const Spline &a, const Spline &b, double tolerance) {
        return detail::made<Meet>(nurbs_surface_intersections, a.get(), b.get(), tolerance);
    }
    /// The same; `call` can watch and end it.
    [[nodiscard]] static Returned<Meet> surfaces(const Spline &a, const Spline &b, double tolerance,
                                                 const CallOptions &call) {
        const detail::Watch watch(call);
        return detail::made<Meet>(nurbs_surface_intersections_with, a.get(), b.get(), tolerance, watch.get());
    }
    /// Where a surface meets itself in curves, proven to be all; without any it is proven to be simple.
    [[nodiscard]] static Returned<Meet> of_itself(const Spline &g, double tolerance) {
        return detail::made<Meet>(nurbs_surface_self_intersections, g.get(), tolerance);
    }
    /// The same; `call` can watch and end it.
    [[nodiscard]] static Returned<Meet> of_itself(const Spline &g, double tolerance,
                                                  const CallOptions &call) {
        const detail::Watch watch(call);
        return detail::made<Meet>(nurbs_surface_self_intersections_with, g.get(), tolerance, watch.get());
    }
    /// Where two faces meet: in the edges that they share, and in curves inside of both.
    [[nodiscard]] static Returned<Meet> of_faces(const Face &a, const Face &b, double tolerance) {
        return detail::made<Meet>(nurbs_face_intersections, a.get(), b.get(), tolerance);
    }
    /// The same; `call` can watch and end it.
    [[nodiscard]] static Returned<Meet> of_faces(const Face &a, const Face &b, double tolerance,
                                                 const CallOptions &call) {
        const detail::Watch watch(call);
        return detail::made<Meet>(nurbs_face_intersections_with, a.get(), b.get(), tolerance, watch.get());
    }
    /// A curve projected onto a surface along a direction, or normally: all curves on it, proven to be all.
    [[nodiscard]] static Returned<Meet> projection(const Spline &g, const Spline &curve,
                                                   View<double> direction, double tolerance) {
        detail::require(direction, 3, "direction");
        return detail::made<Meet>(nurbs_surface_project_curve, g.get(), curve.get(), direction.data(),
                                  tolerance);
    }
    /// The same; `call` can watch and end it.
    [[nodiscard]] static Returned<Meet> projection(const Spline &g, const Spline &curve,
                                                   View<double> direction, double tolerance,
                                                   const CallOptions &call) {
        detail::require(direction, 3, "direction");
        const detail::Watch watch(call);
        return detail::made<Meet>(nurbs_surface_project_curve_with, g.get(), curve.get(), direction.data(),
                                  tolerance, watch.get());
    }
    /// A curve projected onto a face along a direction, or normally: all curves inside of its loops.
    [[nodiscard]] static Returned<Meet> face_projection(const Face &face, const Spline &curve,
                                                        View<double> direction, double tolerance) {
        detail::require(direction, 3, "direction");
        return detail::made<Meet>(nurbs_face_project_curve, face.get(), curve.get(), direction.data(),
                                  tolerance);
    }
    /// The same; `call` can watch and end it.
    [[nodiscard]] static Returned<Meet> face_projection(const Face &face, const Spline &curve,
                                                        View<double> direction, double tolerance,
                                                        const CallOptions &call) {
        detail::require(direction, 3, "direction");
        const detail::Watch watch(call);
        return detail::made<Meet>(nurbs_face_project_curve_with, face.get(), curve.get(), direction.data(),
                                  tolerance, watch.get());
    }
    /// How much it holds.
    [[nodiscard]] Returned<MeetCounts> counts() const {
        MeetCounts found{};
        std::int32_t complete = 0;
        detail::call(nurbs_meet_counts, get(), &found.branches, &found.nodes, &complete);
        found.complete = complete != 0;
        return found;
    }
    /// What the branches belong to, and where they end.
    [[nodiscard]] Returned<MeetBranches> branches() const {
        MeetBranches found{};
        std::int64_t count = 0;
        const auto ask = [&](std::int64_t cap) {
            detail::call(nurbs_meet_branches, get(), cap, found.levels.data(), found.end_nodes.data(),
                         found.loops.data(), found.deviations.data(), &count);
        };
        ask(0);
        found.levels = detail::room<std::int64_t>(count);
        found.end_nodes = detail::room<std::int64_t>(count, 2);
        found.loops = detail::room<std::int64_t>(count);
        found.deviations = detail::room(count);
        ask(count);
        return found;
    }
    /// What the branches are, one of the branch_ constants each.
    [[nodiscard]] Returned<std::vector<std::int32_t>> kinds() const {
        std::vector<std::int32_t> values;
        std::int64_t count = 0;
        const auto ask = [&](std::int64_t cap) {
            detail::call(nurbs_meet_kinds, get(), cap, values.data(), &count);
        };
        ask(0);
        values = detail::room<std::int32_t>(count);
        ask(count);
        return values;
    }
    /// The curves of a branch, with common knots: in space, and in the parameter domain.
    [[nodiscard]] Returned<std::pair<Spline, Spline>> branch(std::int64_t index) const {
        nurbs *space = nullptr, *on_surface = nullptr;
        detail::call(nurbs_meet_branch, get(), index, &space, &on_surface);
        return std::pair(Spline(space), Spline(on_surface));
    }
    /// The curve of a branch in the parameter domain of the second of two surfaces.
    [[nodiscard]] Returned<Spline> branch_second(std::int64_t index) const {
        return detail::made<Spline>(nurbs_meet_branch_second, get(), index);
    }
    /// Where branches end, and where there may be more than they tell.
    [[nodiscard]] Returned<MeetNodes> nodes() const {
        MeetNodes found{};
        std::int64_t count = 0;
        const auto ask = [&](std::int64_t cap) {
            detail::call(nurbs_meet_nodes, get(), cap, found.levels.data(), found.kinds.data(),
                         found.params.data(), found.ranges.data(), &count);
        };
        ask(0);
        found.levels = detail::room<std::int64_t>(count);
        found.kinds = detail::room<std::int32_t>(count);
        found.params = detail::room(count, 2);
        found.ranges = detail::room(count, 2, 2);
        ask(count);
        return found;
    }
    /// Where the nodes are on the second of two surfaces.
    [[nodiscard]] Returned<MeetPlaces> nodes_second() const {
        MeetPlaces found{};
        std::int64_t count = 0;
        const auto ask = [&](std::int64_t cap) {
            detail::call(nurbs_meet_nodes_second, get(), cap, found.params.data(), found.ranges.data(),
                         &count);
        };
        ask(0);
        found.params = detail::room(count, 2);
        found.ranges = detail::room(count, 2, 2);
        ask(count);
        return found;
    }
    /// The ways that the branches make, from one to the next.
    [[nodiscard]] Returned<MeetWays> ways() const {
        MeetWays found{};
        std::int64_t count = 0;
        const auto ask = [&](std::int64_t cap) {
            detail::call(nurbs_meet_ways, get(), cap, found.levels.data(), found.firsts.data(),
                         found.sizes.data(), found.closed.data(), found.gaps.data(), &count);
        };
        ask(0);
        found.levels = detail::room<std::int64_t>(count);
        found.firsts = detail::room<std::int64_t>(count);
        found.sizes = detail::room<std::int64_t>(count);
        found.closed = detail::room<std::int32_t>(count);
        found.gaps = detail::room(count);
        ask(count);
        return found;
    }
    /// The faces of a model on which the branches are.
    [[nodiscard]] Returned<MeetFaces> faces() const {
        MeetFaces found{};
        std::int64_t count = 0;
        const auto ask = [&](std::int64_t cap) {
            detail::call(nurbs_meet_faces, get(), cap, found.faces.data(), found.instances.data(), &count);
        };
        ask(0);
        found.faces = detail::room<std::int64_t>(count);
        found.instances = detail::room<std::int64_t>(count);
        ask(count);
        return found;
    }
    /// The faces of the second of two models on which the branches are.
    [[nodiscard]] Returned<MeetFaces> faces_second() const {
        MeetFaces found{};
        std::int64_t count = 0;
        const auto ask = [&](std::int64_t cap) {
            detail::call(nurbs_meet_faces_second, get(), cap, found.faces.data(), found.instances.data(),
                         &count);
        };
        ask(0);
        found.faces = detail::room<std::int64_t>(count);
        found.instances = detail::room<std::int64_t>(count);
        ask(count);
        return found;
    }
    /// How ways go on at the nodes, and on which faces of a model these are.
    [[nodiscard]] Returned<MeetJoints> joints() const {
        MeetJoints found{};
        std::int64_t count = 0;
        const auto ask = [&](std::int64_t cap) {
            detail::call(nurbs_meet_joints, get(), cap, found.next_nodes.data(), found.gaps.data(),
                         found.faces.data(), found.instances.data(), &count);
        };
        ask(0);
        found.next_nodes = detail::room<std::int64_t>(count);
        found.gaps = detail::room(count);
        found.faces = detail::room<std::int64_t>(count);
        found.instances = detail::room<std::int64_t>(count);
        ask(count);
        return found;
    }
    /// The faces of the second of two models on which the nodes are.
    [[nodiscard]] Returned<MeetFaces> joints_second() const {
        MeetFaces found{};
        std::int64_t count = 0;
        const auto ask = [&](std::int64_t cap) {
            detail::call(nurbs_meet_joints_second, get(), cap, found.faces.data(), found.instances.data(),
                         &count);
        };
        ask(0);
        found.faces = detail::room<std::int64_t>(count);
        found.instances = detail::room<std::int64_t>(count);
        ask(count);
        return found;
    }
    /// Where planes cut the faces of a model, joined to ways over the edges that faces share.
    [[nodiscard]] static Returned<Meet> model_sections(const Model &model, View<double> normals,
                                                       View<double> offsets, double tolerance) {
        const std::int64_t n = detail::records(normals, 3, "normals");
        detail::require(offsets, n, "offsets");
        return detail::made<Meet>(nurbs_model_sections, model.get(), n, normals.data(), offsets.data(),
                                  tolerance);
    }
    /// The same; `call` can watch and end it.
    [[nodiscard]] static Returned<Meet> model_sections(const Model &model, View<double> normals,
                                                       View<double> offsets, double tolerance,
                                                       const CallOptions &call) {
        const std::int64_t n = detail::records(normals, 3, "normals");
        detail::require(offsets, n, "offsets");
        const detail::Watch watch(call);
        return detail::made<Meet>(nurbs_model_sections_with, model.get(), n, normals.data(), offsets.data(),
                                  tolerance, watch.get());
    }
    /// Where the faces of two models meet, joined to ways over the edges that faces share.
    [[nodiscard]] static Returned<Meet> of_models(const Model &a, const Model &b, double tolerance) {
        return detail::made<Meet>(nurbs_model_intersections, a.get(), b.get(), tolerance);
    }
    /// The same; `call` can watch and end it.
    [[nodiscard]] static Returned<Meet> of_models(const Model &a, const Model &b, double tolerance,
                                                  const CallOptions &call) {
        const detail::Watch watch(call);
        return detail::made<Meet>(nurbs_model_intersections_with, a.get(), b.get(), tolerance, watch.get());
    }
    /// What of the branches lies in a face of the surface that they are on.
    [[nodiscard]] static Returned<Meet> trimmed(const Meet &meet, const Face &face) {
        return detail::made<Meet>(nurbs_meet_trim, meet.get(), face.get());
    }
    /// The same; `call` can watch and end it.
    [[nodiscard]] static Returned<Meet> trimmed(const Meet &meet, const Face &face, const CallOptions &call) {
        const detail::Watch watch(call);
        return detail::made<Meet>(nurbs_meet_trim_with, meet.get(), face.get(), watch.get());
    }
    /// What of the branches of two surfaces lies in a face of the second one.
    [[nodiscard]] static Returned<Meet> trimmed_second(const Meet &meet, const Face &face) {
        return detail::made<Meet>(nurbs_meet_trim_second, meet.get(), face.get());
    }
    /// The same; `call` can watch and end it.
    [[nodiscard]] static Returned<Meet> trimmed_second(const Meet &meet, const Face &face,
                                                       const CallOptions &call) {
        const detail::Watch watch(call);
        return detail::made<Meet>(nurbs_meet_trim_second_with, meet.get(), face.get(), watch.get());
    }
};

} // namespace NURBS_CPP_POLICY
} // namespace libnurbs

#endif // NURBS_CPP_MEETS_HPP
