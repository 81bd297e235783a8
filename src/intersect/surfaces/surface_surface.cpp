// SPDX-License-Identifier: MIT
#include "intersect/surfaces/surface_surface.h"

#include "base/watch.h"
#include "intersect/surfaces/contact/contact_curves.h"
#include "intersect/surfaces/cross_clusters.h"
#include "intersect/surfaces/cross_repeats.h"
#include "intersect/surfaces/curves/cross_curve.h"
#include "intersect/surfaces/overlap/overlaps.h"
#include "intersect/surfaces/self/mirrored.h"

#include <algorithm>
#include <utility>

namespace nrb::intersect {

namespace {

constexpr int64_t work_of_a_point = 300000; // for each control point: a net may touch in each of its pieces

constexpr double share_of_overlaps = 0.75; // of the work: the rest is for curves

std::array<int, 2> degrees_of(const Spline &surface) noexcept {
    return {surface.axis(0).degree(), surface.axis(1).degree()};
}

// The search gets one half of the work, and the making of curves the other one. limited: whether the first
// half was used up.
CrossParts parts_of(CrossSearch &search, double tolerance, bool &limited) {
    const PartOfWork half;
    CrossParts found = search.run(tolerance);
    limited = work_ended();
    return found;
}

// Whether a group is left open that is not a touch.
bool is_left_open(const std::vector<CrossGroup> &groups) {
    return std::ranges::any_of(groups, [](const CrossGroup &group) { return !group.touch; });
}

bool is_complete(const Meet &meet) {
    return std::ranges::none_of(meet.nodes,
                                [](const MeetNode &node) { return node.kind == NodeKind::undecided; });
}

void add_crossings(CrossChains chains, const CrossParts &found, const pieces::Frame &frame,
                   const CrossSurface &a, const CrossSurface &b, CrossFitter fitter, Meet &meet) {
    meet.limited = meet.limited || work_ended();
    meet.of_two = true;
    meet.nodes = std::move(chains.nodes);
    meet.complete = is_complete(meet);
    for (const CrossChain &chain : chains.chains) {
        meet.branches.push_back(branch_along(cross_curve(fitter, frame, a, b, found, chain), chain.nodes,
                                             chain.loop, BranchKind::crossing));
    }
}

} // namespace

std::array<std::optional<Interval>, 2> periodic_axes_of(const Spline &surface) {
    std::array<std::optional<Interval>, 2> domains;
    for (int k = 0; k < 2; ++k) {
        if (surface.axis(k).periodic()) {
            domains[static_cast<size_t>(k)] = surface.axis(k).domain();
        }
    }
    return domains;
}

Meet surface_intersections(const Spline &a, const Spline &b, double tolerance, Regions regions) {
    const UsualLimit usual(usual_work(a.point_count() + b.point_count(), work_of_a_point));
    const LimitedSearch limited;
    const pieces::PieceGrid &grid_a = pieces::piece_grid_of(a), &grid_b = pieces::piece_grid_of(b);
    const SurfaceBorders borders_a(grid_a), borders_b(grid_b);
    const CrossSurface on_a{grid_a, borders_a}, on_b{grid_b, borders_b};
    CrossSearch search(a, b, borders_a, borders_b);
    Meet meet;
    CrossParts found = parts_of(search, tolerance, meet.limited);
    remove_repeats(on_a, on_b, found);
    const double in_frame = search.frame().scaled(tolerance);
    ContactTracer tracer(search.solver(), degrees_of(a), degrees_of(b), in_frame);
    const CrossTouch touch(search.ground(0), search.ground(1), in_frame);
    std::optional<Overlaps> overlaps;
    if (regions == Regions::told && is_left_open(cross_groups(on_a, on_b, touch, found.clusters))) {
        const PartOfWork most(share_of_overlaps);
        overlaps = find_overlaps(OverlapGround(a, b, search.frame(), search.solver()), tracer, tolerance,
                                 in_frame, found);
        meet.limited = meet.limited || work_ended();
    }
    const std::vector<ContactCurve> contacts = contact_curves(tracer, found);
    std::vector<CrossGroup> groups = cross_groups(on_a, on_b, touch, found.clusters);
    add_crossings(cross_chains(on_a, on_b, std::move(groups), found), found, search.frame(), on_a, on_b,
                  CrossFitter(degrees_of(a), degrees_of(b), in_frame), meet);
    meet.periodic = {periodic_axes_of(a), periodic_axes_of(b)};
    add_branches(contacts, search.frame(), on_a, on_b, meet);
    if (overlaps) {
        add_overlaps(*overlaps, search.frame(), on_a, on_b, meet);
    }
    return meet;
}

Meet surface_self_intersections(const Spline &g, double tolerance) {
    const UsualLimit usual(usual_work(g.point_count(), work_of_a_point));
    const LimitedSearch limited;
    const pieces::PieceGrid &grid = pieces::piece_grid_of(g);
    const SurfaceBorders borders(grid);
    const CrossSurface on{grid, borders};
    CrossSearch search(g, borders);
    Meet meet;
    CrossParts found = parts_of(search, tolerance, meet.limited);
    remove_repeats(on, on, found);
    const double in_frame = search.frame().scaled(tolerance);
    ContactTracer tracer(search.solver(), degrees_of(g), degrees_of(g), in_frame);
    const CrossTouch touch(search.ground(0), search.ground(1), in_frame);
    std::vector<ContactCurve> contacts = contact_curves(tracer, found);
    remove_mirrored(tracer, contacts);
    CrossChains chains = cross_chains(on, on, mirrored_groups(on, touch, found.clusters), found);
    remove_mirrored(on, found, chains);
    add_crossings(std::move(chains), found, search.frame(), on, on,
                  CrossFitter(degrees_of(g), degrees_of(g), in_frame), meet);
    meet.periodic = {periodic_axes_of(g), periodic_axes_of(g)};
    add_branches(contacts, search.frame(), on, on, meet);
    remove_mirrored(on, touch, meet);
    meet.complete = is_complete(meet);
    meet.tidy_nodes();
    return meet;
}

} // namespace nrb::intersect
