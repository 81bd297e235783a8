// SPDX-License-Identifier: MIT
// Meets: intersection curves of surfaces and faces with planes and with each other, and curves projected onto
// them; access to the branches, nodes and ways of a meet.
#include "checks.h"
#include "guard.h"
#include "meets.h"
#include "outputs.h"
#include "watched.h"

#include "base/tolerance.h"
#include "face/made/projected_curve.h"
#include "face/meets/face_meet.h"
#include "face/trimmed_meet.h"
#include "intersect/levels/sections.h"
#include "intersect/projection/curve_projection.h"
#include "intersect/surfaces/surface_surface.h"
#include "spline/kind.h"

#include <algorithm>
#include <array>
#include <memory>
#include <optional>
#include <span>
#include <utility>

using namespace nrb;
using namespace nrb::capi;

namespace {

const intersect::Meet &meet_of(const nurbs_meet *meet) {
    require(meet, "meet");
    return *meet->meet;
}

const intersect::Meet &two_surfaces_of(const nurbs_meet *meet) {
    const intersect::Meet &own = meet_of(meet);
    if (!own.of_two) {
        fail(Status::incompatible, "meet is of one surface or model, expected one of two");
    }
    return own;
}

void check_trims(const intersect::Meet &meet, const nurbs_face *face) {
    require(face, "face");
    const auto is_of_model = [](const auto &of) { return of.face >= 0; };
    if (std::ranges::any_of(meet.nodes, is_of_model) || std::ranges::any_of(meet.branches, is_of_model)) {
        fail(Status::incompatible, "meet is of models, expected one of surfaces or faces");
    }
}

const face::Face &space_face(const nurbs_face *face, const char *name) {
    require(face, name);
    check_dimension(*face->face->surface(), 3, 3);
    return *face->face;
}

const intersect::MeetBranch &branch_at(const intersect::Meet &meet, int64_t index) {
    if (index < 0 || index >= std::ssize(meet.branches)) {
        fail(Status::index, "index = %lld, expected one of the %zu branches", static_cast<long long>(index),
             meet.branches.size());
    }
    return meet.branches[static_cast<size_t>(index)];
}

// Stores the parameters of node i on a surface, and the box of its part.
void put_place(const std::array<double, 2> &at, const std::array<Interval, 2> &range, size_t i,
               double *params, double *ranges) {
    for (size_t k = 0; k < 2; ++k) {
        put(params, 2 * i + k, at[k]);
        put(ranges, 4 * i + 2 * k, range[k].lower);
        put(ranges, 4 * i + 2 * k + 1, range[k].upper);
    }
}

// A curve to be projected along a direction or, without one, along the normals of the surface.
struct ProjectionQuery {
    SplinePtr curve;
    std::optional<Vector3> direction;
};
ProjectionQuery projection_query(const nurbs *curve, const double *direction, double tolerance) {
    const Spline &spline = named(curve, "curve");
    check_kind(spline, 1, "curve");
    check_dimension(spline, 3, 3);
    if (direction != nullptr) {
        check_direction("direction", direction);
    }
    check_positive_tolerance(tolerance);
    return {curve->spline, direction == nullptr ? std::nullopt : std::optional(vector_of(direction, 3))};
}

} // namespace

nurbs_status nurbs_surface_sections(const nurbs *g, const double *normal, int64_t n, const double *offsets,
                                    double tolerance, nurbs_meet **out) {
    return guard([&] {
        require_out(out);
        const Spline &surface = surface_of(g);
        check_dimension(surface, 3, 3);
        require(normal, "normal");
        check_direction("normal", normal);
        const std::array<double, 3> direction{normal[0], normal[1], normal[2]};
        const std::span<const double> all = checked_values(n, offsets, "offsets");
        check_positive_tolerance(tolerance);
        give_meet(intersect::plane_sections(surface, direction, all, tolerance), out);
    });
}

nurbs_status nurbs_surface_sections_with(const nurbs *g, const double *normal, int64_t n,
                                         const double *offsets, double tolerance,
                                         const nurbs_call_options *call, nurbs_meet **out) {
    return watched(call, out, [&] { return nurbs_surface_sections(g, normal, n, offsets, tolerance, out); });
}

nurbs_status nurbs_surface_intersections(const nurbs *a, const nurbs *b, double tolerance, nurbs_meet **out) {
    return guard([&] {
        require_out(out);
        const Spline &first = named(a, "a"), &second = named(b, "b");
        check_kind(first, 2, "a");
        check_kind(second, 2, "b");
        check_dimension(first, 3, 3);
        check_dimension(second, 3, 3);
        check_positive_tolerance(tolerance);
        give_meet(intersect::surface_intersections(first, second, tolerance, intersect::Regions::told), out);
    });
}

nurbs_status nurbs_surface_intersections_with(const nurbs *a, const nurbs *b, double tolerance,
                                              const nurbs_call_options *call, nurbs_meet **out) {
    return watched(call, out, [&] { return nurbs_surface_intersections(a, b, tolerance, out); });
}

nurbs_status nurbs_surface_self_intersections(const nurbs *g, double tolerance, nurbs_meet **out) {
    return guard([&] {
        require_out(out);
        const Spline &surface = surface_of(g);
        check_dimension(surface, 3, 3);
        check_positive_tolerance(tolerance);
        give_meet(intersect::surface_self_intersections(surface, tolerance), out);
    });
}

nurbs_status nurbs_surface_self_intersections_with(const nurbs *g, double tolerance,
                                                   const nurbs_call_options *call, nurbs_meet **out) {
    return watched(call, out, [&] { return nurbs_surface_self_intersections(g, tolerance, out); });
}

nurbs_status nurbs_face_intersections(const nurbs_face *a, const nurbs_face *b, double tolerance,
                                      nurbs_meet **out) {
    return guard([&] {
        require_out(out);
        const face::Face &first = space_face(a, "a"), &second = space_face(b, "b");
        check_positive_tolerance(tolerance);
        give_meet(face::face_intersections(first, second, tolerance), out);
    });
}

nurbs_status nurbs_face_intersections_with(const nurbs_face *a, const nurbs_face *b, double tolerance,
                                           const nurbs_call_options *call, nurbs_meet **out) {
    return watched(call, out, [&] { return nurbs_face_intersections(a, b, tolerance, out); });
}

nurbs_status nurbs_surface_project_curve(const nurbs *g, const nurbs *curve, const double *direction,
                                         double tolerance, nurbs_meet **out) {
    return guard([&] {
        require_out(out);
        require(g, "g");
        require(curve, "curve");
        const Spline &surface = surface_of(g);
        check_dimension(surface, 3, 3);
        const ProjectionQuery query = projection_query(curve, direction, tolerance);
        give_meet(query.direction
                      ? intersect::projected_along(query.curve, surface, *query.direction, tolerance)
                      : intersect::projected_normally(query.curve, surface, tolerance),
                  out);
    });
}

nurbs_status nurbs_surface_project_curve_with(const nurbs *g, const nurbs *curve, const double *direction,
                                              double tolerance, const nurbs_call_options *call,
                                              nurbs_meet **out) {
    return watched(call, out,
                   [&] { return nurbs_surface_project_curve(g, curve, direction, tolerance, out); });
}

nurbs_status nurbs_face_project_curve(const nurbs_face *face, const nurbs *curve, const double *direction,
                                      double tolerance, nurbs_meet **out) {
    return guard([&] {
        require_out(out);
        const face::Face &own = face_of(face);
        check_dimension(*own.surface(), 3, 3);
        const ProjectionQuery query = projection_query(curve, direction, tolerance);
        give_meet(query.direction ? face::projected_along(query.curve, own, *query.direction, tolerance)
                                  : face::projected_normally(query.curve, own, tolerance),
                  out);
    });
}

nurbs_status nurbs_face_project_curve_with(const nurbs_face *face, const nurbs *curve,
                                           const double *direction, double tolerance,
                                           const nurbs_call_options *call, nurbs_meet **out) {
    return watched(call, out,
                   [&] { return nurbs_face_project_curve(face, curve, direction, tolerance, out); });
}

nurbs_status nurbs_meet_clone(const nurbs_meet *meet, nurbs_meet **out) {
    return guard([&] {
        require_out(out);
        require(meet, "meet");
        *out = new nurbs_meet{meet->meet};
    });
}

void nurbs_meet_destroy(nurbs_meet *meet) {
    delete meet;
}

nurbs_status nurbs_meet_counts(const nurbs_meet *meet, int64_t *branches, int64_t *nodes, int32_t *complete) {
    return guard([&] {
        const intersect::Meet &own = meet_of(meet);
        check_apart(
            {memory("branches", branches, 1), memory("nodes", nodes, 1), memory("complete", complete, 1)},
            {});
        put(branches, int64_t{std::ssize(own.branches)});
        put(nodes, int64_t{std::ssize(own.nodes)});
        put(complete, int32_t{own.complete});
    });
}

nurbs_status nurbs_meet_branches(const nurbs_meet *meet, int64_t cap, int64_t *levels, int64_t *end_nodes,
                                 int64_t *loops, double *deviations, int64_t *count) {
    return guard([&] {
        const std::vector<intersect::MeetBranch> &branches = meet_of(meet).branches;
        const int64_t filled = checked_cap(cap, std::ssize(branches));
        check_apart({memory("levels", levels, filled), memory("end_nodes", end_nodes, 2 * filled),
                     memory("loops", loops, filled), memory("deviations", deviations, filled),
                     memory("count", count, 1)},
                    {});
        for (size_t i = 0; std::cmp_less(i, filled); ++i) {
            put(levels, i, branches[i].level);
            put(end_nodes, 2 * i, branches[i].nodes[0]);
            put(end_nodes, 2 * i + 1, branches[i].nodes[1]);
            put(loops, i, branches[i].loop);
            put(deviations, i, branches[i].deviation);
        }
        put(count, int64_t{std::ssize(branches)});
    });
}

nurbs_status nurbs_meet_kinds(const nurbs_meet *meet, int64_t cap, int32_t *kinds, int64_t *count) {
    return guard([&] {
        const std::vector<intersect::MeetBranch> &branches = meet_of(meet).branches;
        const int64_t filled = checked_cap(cap, std::ssize(branches));
        check_apart({memory("kinds", kinds, filled), memory("count", count, 1)}, {});
        for (size_t i = 0; std::cmp_less(i, filled); ++i) {
            put(kinds, i, static_cast<int32_t>(branches[i].kind));
        }
        put(count, int64_t{std::ssize(branches)});
    });
}

nurbs_status nurbs_meet_branch(const nurbs_meet *meet, int64_t index, nurbs **space, nurbs **on_surface) {
    return guard([&] {
        put(on_surface, static_cast<nurbs *>(nullptr));
        require(space, "space");
        *space = nullptr;
        require(on_surface, "on_surface");
        const intersect::Meet &own = meet_of(meet);
        if (space == on_surface) {
            fail(Status::overlap, "output on_surface overlaps space");
        }
        const intersect::MeetBranch &branch = branch_at(own, index);
        auto in_space = std::make_unique<nurbs>(nurbs{branch.space});
        give(branch.on, on_surface);
        *space = in_space.release();
    });
}

nurbs_status nurbs_meet_branch_second(const nurbs_meet *meet, int64_t index, nurbs **on_second) {
    return guard([&] {
        require(on_second, "on_second");
        *on_second = nullptr;
        const intersect::Meet &own = two_surfaces_of(meet);
        give(branch_at(own, index).on_second, on_second);
    });
}

nurbs_status nurbs_meet_nodes(const nurbs_meet *meet, int64_t cap, int64_t *levels, int32_t *kinds,
                              double *params, double *ranges, int64_t *count) {
    return guard([&] {
        const std::vector<intersect::MeetNode> &nodes = meet_of(meet).nodes;
        const int64_t filled = checked_cap(cap, std::ssize(nodes));
        check_apart({memory("levels", levels, filled), memory("kinds", kinds, filled),
                     memory("params", params, 2 * filled), memory("ranges", ranges, 4 * filled),
                     memory("count", count, 1)},
                    {});
        for (size_t i = 0; std::cmp_less(i, filled); ++i) {
            put(levels, i, nodes[i].level);
            put(kinds, i, static_cast<int32_t>(nodes[i].kind));
            put_place(nodes[i].at, nodes[i].range, i, params, ranges);
        }
        put(count, int64_t{std::ssize(nodes)});
    });
}

nurbs_status nurbs_meet_nodes_second(const nurbs_meet *meet, int64_t cap, double *params, double *ranges,
                                     int64_t *count) {
    return guard([&] {
        const std::vector<intersect::MeetNode> &nodes = two_surfaces_of(meet).nodes;
        const int64_t filled = checked_cap(cap, std::ssize(nodes));
        check_apart({memory("params", params, 2 * filled), memory("ranges", ranges, 4 * filled),
                     memory("count", count, 1)},
                    {});
        for (size_t i = 0; std::cmp_less(i, filled); ++i) {
            put_place(nodes[i].at_second, nodes[i].range_second, i, params, ranges);
        }
        put(count, int64_t{std::ssize(nodes)});
    });
}

nurbs_status nurbs_meet_ways(const nurbs_meet *meet, int64_t cap, int64_t *levels, int64_t *firsts,
                             int64_t *sizes, int32_t *closes, double *gaps, int64_t *count) {
    return guard([&] {
        const std::vector<intersect::MeetWay> &ways = meet_of(meet).ways;
        const int64_t filled = checked_cap(cap, std::ssize(ways));
        check_apart({memory("levels", levels, filled), memory("firsts", firsts, filled),
                     memory("sizes", sizes, filled), memory("closes", closes, filled),
                     memory("gaps", gaps, filled), memory("count", count, 1)},
                    {});
        for (size_t i = 0; std::cmp_less(i, filled); ++i) {
            put(levels, i, ways[i].level);
            put(firsts, i, ways[i].first);
            put(sizes, i, ways[i].count);
            put(closes, i, int32_t{ways[i].closed});
            put(gaps, i, ways[i].gap);
        }
        put(count, int64_t{std::ssize(ways)});
    });
}

nurbs_status nurbs_meet_faces(const nurbs_meet *meet, int64_t cap, int64_t *own_faces, int64_t *own_instances,
                              int64_t *count) {
    return guard([&] {
        const std::vector<intersect::MeetBranch> &branches = meet_of(meet).branches;
        const int64_t filled = checked_cap(cap, std::ssize(branches));
        check_apart({memory("own_faces", own_faces, filled), memory("own_instances", own_instances, filled),
                     memory("count", count, 1)},
                    {});
        for (size_t i = 0; std::cmp_less(i, filled); ++i) {
            put(own_faces, i, branches[i].face);
            put(own_instances, i, branches[i].instance);
        }
        put(count, int64_t{std::ssize(branches)});
    });
}

nurbs_status nurbs_meet_joints(const nurbs_meet *meet, int64_t cap, int64_t *next_nodes, double *gaps,
                               int64_t *own_faces, int64_t *own_instances, int64_t *count) {
    return guard([&] {
        const std::vector<intersect::MeetNode> &nodes = meet_of(meet).nodes;
        const int64_t filled = checked_cap(cap, std::ssize(nodes));
        check_apart({memory("next_nodes", next_nodes, filled), memory("gaps", gaps, filled),
                     memory("own_faces", own_faces, filled), memory("own_instances", own_instances, filled),
                     memory("count", count, 1)},
                    {});
        for (size_t i = 0; std::cmp_less(i, filled); ++i) {
            put(next_nodes, i, nodes[i].next);
            put(gaps, i, nodes[i].gap);
            put(own_faces, i, nodes[i].face);
            put(own_instances, i, nodes[i].instance);
        }
        put(count, int64_t{std::ssize(nodes)});
    });
}

nurbs_status nurbs_meet_trim(const nurbs_meet *meet, const nurbs_face *face, nurbs_meet **out) {
    return guard([&] {
        require_out(out);
        const intersect::Meet &whole = meet_of(meet);
        check_trims(whole, face);
        give_meet(face::trimmed(*face->face, whole), out);
    });
}

nurbs_status nurbs_meet_trim_with(const nurbs_meet *meet, const nurbs_face *face,
                                  const nurbs_call_options *call, nurbs_meet **out) {
    return watched(call, out, [&] { return nurbs_meet_trim(meet, face, out); });
}

nurbs_status nurbs_meet_trim_second(const nurbs_meet *meet, const nurbs_face *face, nurbs_meet **out) {
    return guard([&] {
        require_out(out);
        require(meet, "meet");
        require(face, "face");
        const intersect::Meet &whole = two_surfaces_of(meet);
        check_trims(whole, face);
        give_meet(face::trimmed(*face->face, whole, 1), out);
    });
}

nurbs_status nurbs_meet_trim_second_with(const nurbs_meet *meet, const nurbs_face *face,
                                         const nurbs_call_options *call, nurbs_meet **out) {
    return watched(call, out, [&] { return nurbs_meet_trim_second(meet, face, out); });
}
