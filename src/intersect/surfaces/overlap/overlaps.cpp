// SPDX-License-Identifier: MIT
#include "intersect/surfaces/overlap/overlaps.h"

#include "base/numbers.h"
#include "base/watch.h"
#include "intersect/surfaces/curves/segment_seams.h"
#include "intersect/surfaces/overlap/overlap_proofs.h"

#include <algorithm>
#include <cmath>

namespace nrb::intersect {

namespace {

using Place2 = std::array<double, 2>;

// A place inside of a region, found on the normal of one of its edges in the domain, as far from the edge as
// possible.
std::optional<CrossPlace> place_inside(const OverlapGround &ground, const OverlapEdges &edges,
                                       const OverlapRegions &regions, const OverlapRegion &region,
                                       double near) {
    const auto place_at = [&](const Place2 &at) -> std::optional<CrossPlace> {
        const auto point = ground.point(0, at.data());
        const auto foot = point ? ground.nearest(1, point->at, near) : std::nullopt;
        return foot ? std::optional(CrossPlace{at[0], at[1], (*foot)[0], (*foot)[1]}) : std::nullopt;
    };
    const std::array<Interval, 2> domain{ground.domain(0, 0), ground.domain(0, 1)};
    const Place2 sizes{domain[0].upper - domain[0].lower, domain[1].upper - domain[1].lower};
    if (region.loops.empty()) {
        return place_at({domain[0].lower + 0.47 * sizes[0], domain[1].lower + 0.48 * sizes[1]});
    }
    const bool wraps = ground.borders(0).wraps(0) || ground.borders(0).wraps(1);
    const std::vector<CrossSegment> &segments = edges.edges[region.loops.front().front()].segments;
    const auto &cubic = segments[segments.size() / 2].on[0];
    const Place2 from = cubic[0],
                 way{(cubic[3][0] - cubic[0][0]) / sizes[0], (cubic[3][1] - cubic[0][1]) / sizes[1]},
                 middle{from[0] / 2 + cubic[3][0] / 2, from[1] / 2 + cubic[3][1] / 2};
    const double length = std::hypot(way[0], way[1]);
    const auto place_off = [&](double step) -> std::optional<CrossPlace> {
        const Place2 at{middle[0] - step * way[1] / length * sizes[0],
                        middle[1] + step * way[0] / length * sizes[1]};
        int turns = 0;
        for (const auto &polygon : region.polygons) {
            turns += winding_of(polygon, at);
        }
        bool inside = wraps ? regions.hold(ground, at) : turns == 1;
        for (size_t k = 0; k < 2; ++k) {
            inside = inside && at[k] >= domain[k].lower && at[k] <= domain[k].upper;
        }
        return inside ? place_at(at) : std::nullopt;
    };
    double step = wraps ? 0x1p-5 : 0.5;
    while (step > 0x1p-24) {
        if (const auto place = place_off(step)) { // this may be close to the opposite side of the region
            const auto half = place_off(step / 2);
            return half ? half : place;
        }
        step *= wraps ? 0.5 : 0.77;
    }
    return std::nullopt;
}

bool has_no_borders(const OverlapBorders &borders) noexcept {
    return borders.sides.empty();
}

// Adds the branches and nodes of one region at a time.
class RegionBranches {
public:
    RegionBranches(const Overlaps &overlaps, const pieces::Frame &frame, const CrossSurface &a,
                   const CrossSurface &b, Meet &meet)
        : overlaps_(overlaps), frame_(frame), a_(a), b_(b), meet_(meet) {
        for (const MeetBranch &branch : meet.branches) {
            loops_ = std::max(loops_, branch.loop + 1);
        }
    }

    void add(size_t region) {
        level_ = static_cast<int64_t>(region) + 1;
        for (size_t k = 0; k < 2; ++k) {
            const int axis = static_cast<int>(k);
            ranges_[k] = {infinity, -infinity};
            ranges_[2 + k] = {infinity, -infinity};
            if (overlaps_.regions.list[region].loops.empty()) {
                ranges_[k] = {a_.grid.break_at(axis, 0), a_.grid.break_at(axis, a_.grid.count(axis))};
                ranges_[2 + k] = {b_.grid.break_at(axis, 0), b_.grid.break_at(axis, b_.grid.count(axis))};
            }
        }
        for (const OverlapLoop &loop : overlaps_.regions.list[region].loops) {
            add(loop);
        }
        add_region(overlaps_.places[region]);
    }

private:
    // The part of a loop from one node, or seam, to the next.
    struct Part {
        std::vector<CrossSegment> segments;
        bool after_seam = false;
    };

    void add(const OverlapLoop &loop) {
        std::vector<Part> parts;
        const bool closed = overlaps_.edges.edges[loop.front()].closed;
        for (const size_t edge : loop) {
            bool first = true;
            for (auto &segments : parts_between_seams(a_, b_, overlaps_.edges.edges[edge].segments, closed)) {
                parts.push_back({std::move(segments), !first});
                first = false;
            }
        }
        if (closed) {
            parts.front().after_seam =
                is_seam(a_, b_, parts.back().segments.back(), parts.front().segments.front());
            if (!parts.front().after_seam) {
                add_branch(std::move(parts.front()), {-1, -1});
                ++loops_;
                return;
            }
        }
        const size_t n = parts.size();
        std::vector<std::array<int64_t, 2>> nodes(n);
        for (size_t i = 0; i < n; ++i) {
            const size_t next = (i + 1) % n;
            join(parts[i], parts[next], nodes[i][1], nodes[next][0]);
        }
        for (size_t i = 0; i < n; ++i) {
            add_branch(std::move(parts[i]), nodes[i]);
        }
        ++loops_;
    }
    // Joins two parts in one node, or across a seam in two.
    void join(const Part &before, const Part &after, int64_t &end, int64_t &begin) {
        const CrossPlace from = place_of(before.segments.back(), 3), to = place_of(after.segments.front(), 0);
        if (!after.after_seam && from == to) {
            begin = end = add_node(NodeKind::border, from);
            meet_.nodes[static_cast<size_t>(end)].next = end;
            return;
        }
        end = add_node(NodeKind::seam, from);
        begin = add_node(NodeKind::seam, to);
        meet_.nodes[static_cast<size_t>(end)].next = begin;
        meet_.nodes[static_cast<size_t>(begin)].next = end;
    }
    static CrossPlace place_of(const CrossSegment &segment, size_t i) noexcept {
        return {segment.on[0][i][0], segment.on[0][i][1], segment.on[1][i][0], segment.on[1][i][1]};
    }
    int64_t add_node(NodeKind kind, const CrossPlace &at) {
        MeetNode node{level_, kind, {at[0], at[1]}, {}};
        node.at_second = {at[2], at[3]};
        for (size_t k = 0; k < 2; ++k) {
            node.range[k] = {at[k], at[k]};
            node.range_second[k] = {at[2 + k], at[2 + k]};
        }
        meet_.nodes.push_back(node);
        return std::ssize(meet_.nodes) - 1;
    }
    void add_branch(Part part, const std::array<int64_t, 2> &nodes) {
        for (const CrossSegment &segment : part.segments) {
            for (size_t i = 0; i < 4; ++i) {
                for (const Place2 &at : segment.on[i / 2]) {
                    ranges_[i] = {std::min(ranges_[i].lower, at[i % 2]),
                                  std::max(ranges_[i].upper, at[i % 2])};
                }
            }
        }
        meet_.branches.push_back(
            branch_along(cross_curve(frame_, a_, b_, std::move(part.segments), nodes[0] < 0), nodes, loops_,
                         BranchKind::overlap));
        meet_.branches.back().level = level_;
    }
    // Adds the node of kind overlap, with the box of the region: that of its boundary, or the whole domain of
    // a surface that closes or has a pole, since the region may reach beyond the box of its boundary there.
    void add_region(const CrossPlace &at) {
        const int64_t node = add_node(NodeKind::overlap, at);
        MeetNode &own = meet_.nodes[static_cast<size_t>(node)];
        for (size_t i = 0; i < 4; ++i) {
            const CrossSurface &surface = i < 2 ? a_ : b_;
            const int axis = static_cast<int>(i % 2);
            const bool all = surface.borders.wraps(0) || surface.borders.wraps(1) || has_pole(surface);
            const Interval domain{surface.grid.break_at(axis, 0),
                                  surface.grid.break_at(axis, surface.grid.count(axis))};
            (i < 2 ? own.range : own.range_second)[i % 2] = all ? domain : ranges_[i];
        }
    }
    static bool has_pole(const CrossSurface &surface) noexcept {
        for (size_t k = 0; k < 2; ++k) {
            const int64_t last = surface.grid.count(static_cast<int>(k)) - 1;
            if (surface.borders.is_collapsed(k, 0, false) || surface.borders.is_collapsed(k, last, true)) {
                return true;
            }
        }
        return false;
    }

    const Overlaps &overlaps_;
    const pieces::Frame &frame_;
    const CrossSurface &a_, &b_;
    Meet &meet_;
    int64_t level_ = 0, loops_ = 0;
    std::array<Interval, 4> ranges_{};
};

} // namespace

std::optional<Overlaps> find_overlaps(const OverlapGround &ground, const ContactTracer &tracer,
                                      double tolerance, double near, CrossParts &found) {
    const std::optional<OverlapBorders> borders = overlap_borders(ground, tolerance, near);
    if (!borders || (borders->runs.empty() && !has_no_borders(*borders))) {
        return std::nullopt;
    }
    std::optional<OverlapEdges> edges = overlap_edges(ground, tracer, *borders, near);
    if (!edges || (edges->edges.empty() && !has_no_borders(*borders))) {
        return std::nullopt;
    }
    Overlaps result{std::move(*edges), {}, {}};
    std::optional<OverlapRegions> regions = overlap_regions(ground, result.edges);
    if (!regions) {
        return std::nullopt;
    }
    result.regions = std::move(*regions);
    for (const OverlapRegion &region : result.regions.list) {
        const std::optional<CrossPlace> inside =
            place_inside(ground, result.edges, result.regions, region, near);
        if (!inside) {
            return std::nullopt;
        }
        result.places.push_back(*inside);
    }
    OverlapProofs proofs(ground, result.edges, result.regions, near);
    if (!proofs.prove()) {
        return std::nullopt;
    }
    proofs.take_out_of(found);
    return result;
}

void add_overlaps(const Overlaps &overlaps, const pieces::Frame &frame, const CrossSurface &a,
                  const CrossSurface &b, Meet &meet) {
    RegionBranches branches(overlaps, frame, a, b, meet);
    for (size_t region = 0; region < overlaps.regions.list.size(); ++region) {
        branches.add(region);
    }
}

} // namespace nrb::intersect
