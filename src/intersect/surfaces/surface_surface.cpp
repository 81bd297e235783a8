// SPDX-License-Identifier: MIT
#include "intersect/surfaces/surface_surface.h"

#include "base/watch.h"
#include "intersect/surfaces/contact/contact_curves.h"
#include "intersect/surfaces/cross_clusters.h"
#include "intersect/surfaces/cross_curve.h"
#include "intersect/surfaces/cross_repeats.h"
#include "intersect/surfaces/overlap/overlaps.h"

#include <algorithm>
#include <utility>

namespace nrb::intersect {

namespace {

std::array<int, 2> degrees_of(const Spline &surface) noexcept {
    return {surface.axis(0).degree(), surface.axis(1).degree()};
}

// Curves are made of the other half of the work. limited: whether this one ended.
CrossParts parts_of(CrossSearch &search, double tolerance, bool &limited) {
    const HalfOfWork half;
    CrossParts found = search.run(tolerance);
    limited = work_ended();
    return found;
}

// Whether something is left open that is no touch.
bool is_left_open(const std::vector<CrossGroup> &groups) {
    return std::ranges::any_of(groups, [](const CrossGroup &group) { return !group.touch; });
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
    const UsualLimit usual(usual_work(a.point_count() + b.point_count()));
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
        const HalfOfWork half;
        overlaps = find_overlaps(OverlapGround(a, b, search.frame(), search.solver()), tracer, tolerance,
                                 in_frame, found);
        meet.limited = meet.limited || work_ended();
    }
    const std::vector<ContactCurve> contacts = contact_curves(tracer, found);
    CrossChains chains = cross_chains(on_a, on_b, touch, found);
    meet.limited = meet.limited || work_ended();
    meet.of_two = true;
    meet.periodic = {periodic_axes_of(a), periodic_axes_of(b)};
    meet.nodes = std::move(chains.nodes);
    meet.complete = std::ranges::none_of(
        meet.nodes, [](const MeetNode &node) { return node.kind == NodeKind::undecided; });
    CrossFitter fitter(degrees_of(a), degrees_of(b), in_frame);
    for (const CrossChain &chain : chains.chains) {
        meet.branches.push_back(branch_along(cross_curve(fitter, search.frame(), on_a, on_b, found, chain),
                                             chain.nodes, chain.loop, BranchKind::crossing));
    }
    add_branches(contacts, search.frame(), on_a, on_b, meet);
    if (overlaps) {
        add_overlaps(*overlaps, search.frame(), on_a, on_b, meet);
    }
    return meet;
}

} // namespace nrb::intersect
