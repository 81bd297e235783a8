// SPDX-License-Identifier: MIT
#include "face/meets/face_meet.h"

#include "base/numbers.h"
#include "base/watch.h"
#include "closest/closest.h"
#include "eval/curve_point.h"
#include "face/made/seam_parts.h"
#include "face/made/speeds.h"
#include "face/meets/along_border.h"
#include "face/meets/common_edges.h"
#include "face/meets/face_regions.h"
#include "face/meets/ground.h"
#include "face/meets/one_surface.h"
#include "face/trimmed_meet.h"
#include "intersect/pairs/curve_curve.h"
#include "intersect/surfaces/surface_surface.h"
#include "numeric/vector3.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <span>
#include <utility>

namespace nrb::face {

namespace {

using intersect::BranchKind;
using intersect::Meet;
using intersect::MeetBranch;
using intersect::MeetNode;
using intersect::NodeKind;

// Margins of the grounds that are tried where the usual ones leave something open. They differ from the usual
// margin and from each other, so that ends of grounds do not coincide again by chance.
constexpr std::array<double, 2> margins_beyond{1.0 / 53, 1.0 / 41};
struct Box {
    std::array<double, 3> lower{infinity, infinity, infinity}, upper{-infinity, -infinity, -infinity};
};

Box box_of(const Spline &curve) noexcept {
    Box box;
    for (int64_t i = 0; i < curve.point_count(); ++i) {
        for (size_t c = 0; c < 3; ++c) {
            const double x = curve.coordinate(i, static_cast<int>(c));
            box.lower[c] = std::min(box.lower[c], x);
            box.upper[c] = std::max(box.upper[c], x);
        }
    }
    return box;
}

bool are_near(const Box &a, const Box &b, double room) noexcept {
    for (size_t c = 0; c < 3; ++c) {
        if (!(a.lower[c] <= b.upper[c] + room && a.upper[c] >= b.lower[c] - room)) {
            return false;
        }
    }
    return true;
}

// The parts of a curve that run along common edges.
std::vector<Interval> parts_along(const Spline &curve, std::span<const CommonEdge> edges) {
    std::vector<Interval> parts;
    const Box box = box_of(curve);
    for (const CommonEdge &edge : edges) {
        if (!are_near(box, box_of(*edge.branch.space), edge.room)) {
            continue;
        }
        for (const intersect::PairHit &hit :
             intersect::curve_curve(curve, *edge.branch.space, edge.room).list) {
            if (hit.kind == intersect::HitKind::overlap) {
                parts.push_back(hit.range_a);
            }
        }
    }
    return parts;
}

PartsOfBranches parts_along(const Meet &meet, std::span<const CommonEdge> edges) {
    PartsOfBranches parts;
    for (const MeetBranch &branch : meet.branches) {
        parts.push_back(branch.kind == BranchKind::overlap ? std::vector<Interval>()
                                                           : parts_along(*branch.space, edges));
    }
    return parts;
}

// Drops the edges beside regions, of faces on one surface, that run along common edges.
void drop_edges_along(Meet &regions, std::span<const CommonEdge> edges) {
    std::erase_if(regions.branches, [&](const MeetBranch &branch) {
        return branch.kind == BranchKind::edge &&
               cover(parts_along(*branch.space, edges), branch.space->axis(0).domain());
    });
    regions.tidy_nodes();
}

// Whether a point is within the room of an edge.
bool is_at(const double *x, const CommonEdge &edge) {
    const Spline &own = *edge.branch.space;
    return closest::locator_of(own)
               .nearest({x, nullptr, edge.room, closest::usual_budget(own), false, true})
               .distance <= edge.room;
}

// Whether a curve cannot be told from an edge: it begins within the room of the edge, and is no larger than
// that.
bool is_of(const Spline &curve, const CommonEdge &edge) {
    const Box box = box_of(curve);
    double size = 0;
    for (size_t c = 0; c < 3; ++c) {
        size = std::hypot(size, box.upper[c] - box.lower[c]);
    }
    return size <= edge.room && is_at(eval::end_point(curve, false).data(), edge);
}

// Where arcs along an edge were not found to continue in each other, it is the edge that continues: undecided
// nodes that are single places on an edge become nodes of the edge.
void settle_places_on_edges(const Spline &surface, std::span<const CommonEdge> edges, Meet &meet) {
    for (MeetNode &node : meet.nodes) {
        const bool place =
            node.range[0].lower == node.range[0].upper && node.range[1].lower == node.range[1].upper;
        if (node.kind != NodeKind::undecided || !place) {
            continue;
        }
        const std::vector<double> x = point_at(surface, node.at);
        if (std::ranges::any_of(edges, [&](const CommonEdge &edge) { return is_at(x.data(), edge); })) {
            node.kind = NodeKind::edge;
        }
    }
}

// Drops short remainders at the ends of what runs along an edge, as these ends are only as exact as the room.
void drop_what_is_of_edges(Meet &meet, std::span<const CommonEdge> edges) {
    std::erase_if(meet.branches, [&](const MeetBranch &branch) {
        return std::ranges::any_of(edges, [&](const CommonEdge &edge) { return is_of(*branch.space, edge); });
    });
    meet.tidy_nodes();
}

// Moves a meet of continued surfaces into the domains of the faces, beyond which it extends by rounding only.
class IntoDomains {
public:
    IntoDomains(const Face &a, const Face &b) : faces_{&a, &b} {}

    void move(Meet &meet) {
        for (MeetBranch &branch : meet.branches) {
            branch.deviation += std::max(move(branch.on, 0), move(branch.on_second, 1));
        }
        for (MeetNode &node : meet.nodes) {
            move(node.at, node.range, 0);
            move(node.at_second, node.range_second, 1);
        }
    }

private:
    [[nodiscard]] double clamped(double x, size_t face, int k) const noexcept {
        const Covering &covering = faces_[face]->covering();
        return covering.closed(k) ? x : std::clamp(x, covering.domain(k).lower, covering.domain(k).upper);
    }
    void move(std::array<double, 2> &at, std::array<Interval, 2> &range, size_t face) const noexcept {
        for (const int k : {0, 1}) {
            const auto axis = static_cast<size_t>(k);
            at[axis] = clamped(at[axis], face, k);
            range[axis] = {clamped(range[axis].lower, face, k), clamped(range[axis].upper, face, k)};
        }
    }
    // Moves a curve, and returns a bound on how far the points of the surface move.
    double move(SplinePtr &curve, size_t face) {
        Point2 most{};
        curve = set_inside(faces_[face]->covering(), curve, false, most);
        if (most == Point2{}) {
            return 0;
        }
        const std::array<double, 2> speeds = fastest(*ground_of(*faces_[face], true));
        return most[0] * speeds[0] + most[1] * speeds[1];
    }

    std::array<const Face *, 2> faces_;
};

MeetNode node_at(const Face &a, const Face &b, const MeetBranch &branch, bool upper, NodeKind kind) {
    MeetNode node{0, kind, {}, {}};
    const auto place = [&](const Face &face, const Spline &curve, std::array<double, 2> &at,
                           std::array<Interval, 2> &range) {
        const std::vector<double> on = eval::end_point(curve, upper);
        at = face.covering().in_domain({on[0], on[1]});
        range = {Interval{at[0], at[0]}, Interval{at[1], at[1]}};
    };
    place(a, *branch.on, node.at, node.range);
    place(b, *branch.on_second, node.at_second, node.range_second);
    return node;
}

// An edge that closes begins and ends in two nodes that continue each other.
void add_edge(const Face &a, const Face &b, const CommonEdge &edge, Meet &meet) {
    Meet own;
    MeetBranch branch = edge.branch;
    const NodeKind kind = edge.closes ? NodeKind::seam : NodeKind::border;
    own.nodes = {node_at(a, b, branch, false, kind), node_at(a, b, branch, true, kind)};
    if (edge.closes) {
        own.nodes[0].next = 1;
        own.nodes[1].next = 0;
    }
    branch.nodes = {0, 1};
    branch.loop = edge.closes ? 0 : -1;
    own.branches.push_back(std::move(branch));
    meet.append(std::move(own));
}

// What two faces have in common in the regions of overlap of their surfaces. The nodes of these regions have
// then served their purpose.
Meet regions_in(Meet &surfaces, const Face &a, const Face &b, const std::array<SplinePtr, 2> &grounds,
                double tolerance) {
    Meet found;
    found.of_two = true;
    if (std::ranges::find(surfaces.nodes, NodeKind::overlap, &MeetNode::kind) == surfaces.nodes.end()) {
        return found;
    }
    FaceRegions regions(a, b, grounds, tolerance);
    for (MeetNode &node : surfaces.nodes) {
        if (node.kind != NodeKind::overlap || work_ended()) {
            continue;
        }
        if (std::optional<Meet> own = regions.within(surfaces, node)) {
            found.append(std::move(*own));
            node.kind = NodeKind::border; // without a branch, so that it is dropped
        }
    }
    return found;
}

Meet met_on(const std::array<SplinePtr, 2> &grounds, const Face &a, const Face &b, double tolerance) {
    Meet all =
        intersect::surface_intersections(*grounds[0], *grounds[1], tolerance, intersect::Regions::told);
    Meet regions = regions_in(all, a, b, grounds, tolerance);
    Meet found = trimmed(b, trimmed(a, all), 1);
    found.limited = found.limited || work_ended();
    found.append(std::move(regions));
    found.tidy_nodes();
    return found;
}

} // namespace

Meet face_intersections(const Face &a, const Face &b, double tolerance) {
    const LimitedSearch whole; // at a limit of the caller it ends with what it has
    const std::vector<CommonEdge> edges = common_edges(a, b, tolerance);
    if (edges.empty()) {
        return strangers_intersections(a, b, tolerance);
    }
    const std::array<SplinePtr, 2> grounds{ground_of(a, true), ground_of(b, true)};
    const auto told =
        may_be_one(grounds, a, edges, tolerance) ? intersect::Regions::told : intersect::Regions::open;
    Meet all = intersect::surface_intersections(*grounds[0], *grounds[1], tolerance, told);
    Meet regions = regions_in(all, a, b, grounds, tolerance);
    settle_places_on_edges(*grounds[0], edges, all);
    Meet found = trimmed(b, trimmed(a, all, 0, parts_along(all, edges)), 1);
    drop_what_is_of_edges(found, edges);
    drop_edges_along(regions, edges);
    found.limited = found.limited || work_ended();
    found.append(std::move(regions));
    found.tidy_nodes();
    IntoDomains(a, b).move(found);
    for (const CommonEdge &edge : edges) {
        add_edge(a, b, edge, found);
    }
    return found;
}

// Where two surfaces coincide up to a common end curve, only their continuations beyond it can show that the
// faces have nothing else in common.
Meet strangers_intersections(const Face &a, const Face &b, double tolerance) {
    const LimitedSearch whole;
    Meet found = met_on({ground_of(a, false), ground_of(b, false)}, a, b, tolerance);
    if (found.complete || found.limited) {
        return found;
    }
    Meet beyond = met_on({ground_of(a, true, margins_beyond[0]), ground_of(b, true, margins_beyond[1])}, a, b,
                         tolerance);
    if (!beyond.complete) {
        return found;
    }
    IntoDomains(a, b).move(beyond);
    return beyond;
}

} // namespace nrb::face
