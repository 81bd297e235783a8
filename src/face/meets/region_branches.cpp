// SPDX-License-Identifier: MIT
#include "face/meets/region_branches.h"

#include "base/error.h"
#include "base/numbers.h"
#include "closest/closest.h"
#include "eval/curve_point.h"
#include "face/face_box.h"
#include "face/meets/shared_parts.h"
#include "face/places_inside.h"
#include "reduce/compatible.h"

#include <algorithm>
#include <utility>

namespace nrb::face {

namespace {

using intersect::BranchKind;
using intersect::MeetBranch;
using intersect::MeetNode;
using intersect::NodeKind;

using Ranges = std::array<Interval, 2>;

void include(Interval &range, double x) noexcept {
    range = {std::min(range.lower, x), std::max(range.upper, x)};
}

// The box of the curves in domain k. If the domain closes or has a pole, this is the whole domain, because a
// region may reach farther than its border there.
Ranges range_of(const Covering &covering, const SharedLoops &loops, size_t k) {
    const bool all = loops.empty() || covering.closed(0) || covering.closed(1) || covering.has_poles();
    if (all) {
        return {covering.domain(0), covering.domain(1)};
    }
    Ranges ranges{Interval{infinity, -infinity}, Interval{infinity, -infinity}};
    for (const SharedLoop &loop : loops) {
        for (const SharedCurve &curve : loop) {
            for (int64_t i = 0; i < curve.on[k]->point_count(); ++i) {
                for (size_t axis = 0; axis < 2; ++axis) {
                    const double x = curve.on[k]->coordinate(i, static_cast<int>(axis));
                    include(ranges[axis], x);
                }
            }
        }
    }
    return ranges;
}

Point2 place_beside(const SharedGrounds &grounds, const Point2 &at) {
    const std::vector<double> x = point_at(*grounds.surface(0), at);
    const Spline &other = *grounds.surface(1);
    const closest::Foot foot = closest::locator_of(other).nearest(
        {x.data(), nullptr, grounds.near() / 16, closest::usual_budget(other), false, true});
    if (!(foot.distance <= 2 * grounds.near())) {
        fail(Status::not_converged, "a region that two surfaces share has a place that is on one of them");
    }
    return {foot.params[0], foot.params[1]};
}

} // namespace

void RegionBranches::add_region(const SharedLoops &loops, int64_t level) {
    const FacePtr face = SharedParts::face_of(grounds_, 0, loops);
    const std::vector<Point2> inside = places_inside(*face);
    if (inside.empty()) {
        fail(Status::not_converged, "a region that two faces share is too thin");
    }
    for (const SharedLoop &loop : loops) {
        add_loop(loop, level);
    }
    MeetNode node{level, NodeKind::overlap, inside.front(), range_of(grounds_.covering(0), loops, 0)};
    node.at_second = place_beside(grounds_, inside.front());
    node.range_second = range_of(grounds_.covering(1), loops, 1);
    for (size_t axis = 0; axis < 2; ++axis) { // places may be outside by rounding, and by the tolerance
        include(node.range[axis], node.at[axis]);
        include(node.range_second[axis], node.at_second[axis]);
    }
    meet_.nodes.push_back(node);
}

void RegionBranches::add_edge(const SharedCurve &curve) {
    const int64_t from = add_node(curve, false, NodeKind::border, 0),
                  to = add_node(curve, true, NodeKind::border, 0);
    add_branch(curve, BranchKind::edge, 0, {from, to}, -1);
}

void RegionBranches::add_loop(const SharedLoop &loop, int64_t level) {
    const size_t n = loop.size();
    std::vector<std::array<int64_t, 2>> nodes(n, {-1, -1});
    const bool closed = n == 1 && goes_on_in_itself(loop.front());
    for (size_t i = 0; i < n && !closed; ++i) {
        const size_t next = (i + 1) % n;
        join(loop[i], loop[next], level, nodes[i][1], nodes[next][0]);
    }
    for (size_t i = 0; i < n; ++i) {
        add_branch(loop[i], BranchKind::overlap, level, nodes[i], loops_);
    }
    ++loops_;
}

// Whether a curve closes without a node, possibly by running once around a periodic axis.
bool RegionBranches::goes_on_in_itself(const SharedCurve &curve) const {
    for (size_t k = 0; k < 2; ++k) {
        const std::vector<double> from = eval::end_point(*curve.on[k], false),
                                  to = eval::end_point(*curve.on[k], true);
        for (size_t axis = 0; axis < 2; ++axis) {
            const bool periodic = grounds_.surface(k)->axis(static_cast<int>(axis)).periodic();
            if (from[axis] != to[axis] && !periodic) {
                return false;
            }
        }
    }
    return true;
}

// Joins two curves in one node or, across a seam, in two.
void RegionBranches::join(const SharedCurve &before, const SharedCurve &after, int64_t level, int64_t &end,
                          int64_t &begin) {
    const bool seam = passes_seam(before, after);
    const NodeKind kind = seam ? NodeKind::seam : NodeKind::border;
    end = add_node(before, true, kind, level);
    begin = seam ? add_node(after, false, kind, level) : end;
    meet_.nodes[static_cast<size_t>(end)].next = begin;
    meet_.nodes[static_cast<size_t>(begin)].next = end;
}

int64_t RegionBranches::add_node(const SharedCurve &curve, bool upper, NodeKind kind, int64_t level) {
    MeetNode node{level, kind, {}, {}};
    const auto set = [&](size_t k, std::array<double, 2> &at, Ranges &range) {
        Point2 end;
        eval::end_point(*curve.on[k], upper, end.data());
        at = grounds_.covering(k).in_domain(end);
        range = {Interval{at[0], at[0]}, Interval{at[1], at[1]}};
    };
    set(0, node.at, node.range);
    set(1, node.at_second, node.range_second);
    meet_.nodes.push_back(node);
    return std::ssize(meet_.nodes) - 1;
}

void RegionBranches::add_branch(const SharedCurve &curve, BranchKind kind, int64_t level,
                                const std::array<int64_t, 2> &nodes, int64_t loop) {
    const std::array<SplinePtr, 3> curves{curve.space, curve.on[0], curve.on[1]};
    std::vector<SplinePtr> all = reduce::make_compatible(curves, 0, false).splines;
    MeetBranch branch{level, std::move(all[0]), std::move(all[1]), curve.deviation, nodes, loop};
    branch.on_second = std::move(all[2]);
    branch.kind = kind;
    meet_.branches.push_back(std::move(branch));
}

} // namespace nrb::face
