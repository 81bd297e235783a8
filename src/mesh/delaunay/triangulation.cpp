// SPDX-License-Identifier: MIT
#include "mesh/delaunay/triangulation.h"

#include "base/watch.h"
#include "mesh/delaunay/insertion_order.h"

#include <algorithm>
#include <utility>

namespace nrb::mesh {

namespace {

constexpr int64_t work_of_a_triangle = 10;

// The mark of edges of a segment: twice the label, plus one for a border.
constexpr int32_t mark_of(const Triangulation::Segment &segment) noexcept {
    return 2 * segment.label + (segment.border ? 1 : 0);
}

// Moves the first vertex that is not on a line with the first two to the third place. Returns whether there
// is one.
bool begin_with_triangle(const std::vector<GridPoint> &points, std::span<VertexId> order) {
    const auto point = [&](VertexId v) { return points[static_cast<size_t>(v)]; };
    for (size_t i = 2; i < order.size(); ++i) {
        if (orientation(point(order[0]), point(order[1]), point(order[i])) != 0) {
            std::swap(order[2], order[i]);
            return true;
        }
    }
    return false;
}

} // namespace

Triangulation::Triangulation(std::span<const GridPoint> points, const GridMetric &metric) : net_({}) {
    DistinctPoints distinct = distinct_points(points);
    vertex_of_ = std::move(distinct.place);
    std::vector<VertexId> order = order_in_rounds(static_cast<int32_t>(distinct.points.size()));
    net_ = TriangleNet(std::move(distinct.points), metric);
    if (begin_with_triangle(net_.points(), order)) {
        build(order);
    }
}

void Triangulation::build(std::span<const VertexId> order) {
    net_.reserve_triangles(2 * order.size());
    const bool is_right = orientation(net_.point(order[0]), net_.point(order[1]), net_.point(order[2])) < 0;
    net_.start(order[0], order[is_right ? 2 : 1], order[is_right ? 1 : 2]);
    TriangleId near = 0;
    for (const VertexId v : order.subspan(3)) {
        add(v, locate(net_, net_.point(v), near));
        near = real_at(TriangleNet::triangle_of(net_.fan_of(v)));
    }
}

void Triangulation::add(VertexId v, const GridPlace &place) {
    if (place.kind == GridPlace::Kind::edge) {
        net_.split_edge(place.edge, v);
    } else {
        net_.split_triangle(place.edge, v);
    }
    star_flips_.run(net_, v);
}

// The triangle itself, or the neighbour of a ghost across its edge of the hull.
TriangleId Triangulation::real_at(TriangleId t) const noexcept {
    for (int k = 0; k < 3; ++k) {
        if (net_.apex(TriangleNet::edge_of(t, k)) == TriangleNet::infinite) {
            return neighbour(t, k);
        }
    }
    return t;
}

std::vector<Triangulation::Crossing> Triangulation::constrain(std::span<const Segment> segments) {
    std::vector<Crossing> crossings;
    if (size() == 0) {
        return crossings;
    }
    for (size_t i = 0; i < segments.size(); ++i) {
        const VertexId from = segments[i].from, to = segments[i].to;
        const VertexId a = of_fewer_triangles(net_, from, to), b = a == from ? to : from;
        if (const std::optional<EdgeId> e = first_crossed(a, b)) {
            crossings.push_back({i, net_.mark(*e) >> 1, net_.from(*e), net_.to(*e)});
        } else {
            recover(a, b, mark_of(segments[i]));
        }
    }
    return crossings;
}

// The first edge that stays which the segment from a to b crosses, if there is any.
std::optional<EdgeId> Triangulation::first_crossed(VertexId a, VertexId b) {
    while (a != b) {
        crossed_.clear();
        a = first_part(net_, a, b, crossed_).to;
        const auto staying = [&](EdgeId e) { return net_.mark(e) != TriangleNet::unmarked; };
        if (const auto e = std::find_if(crossed_.begin(), crossed_.end(), staying); e != crossed_.end()) {
            return *e;
        }
    }
    return std::nullopt;
}

void Triangulation::recover(VertexId a, VertexId b, int32_t mark) {
    while (a != b) {
        crossed_.clear();
        const SegmentPart part = first_part(net_, a, b, crossed_);
        if (part.along < 0) {
            corridor_.open(net_, crossed_, mark);
        } else if (const int32_t old = net_.mark(part.along); old == TriangleNet::unmarked) {
            net_.set_mark(part.along, mark);
        } else {
            net_.set_mark(part.along, old ^ (mark & 1));
        }
        a = part.to;
    }
}

bool Triangulation::mark_inside() {
    if (size() == 0) {
        return true;
    }
    std::vector<bool> reached(static_cast<size_t>(size()));
    std::vector<TriangleId> waiting = {TriangleNet::triangle_of(net_.fan_of(TriangleNet::infinite))};
    reached[static_cast<size_t>(waiting.front())] = true;
    net_.set_inside(waiting.front(), false);
    bool consistent = true;
    while (!waiting.empty()) {
        count_work(work_of_a_triangle);
        const TriangleId t = waiting.back();
        waiting.pop_back();
        for (int k = 0; k < 3; ++k) {
            consistent &= cross_into(TriangleNet::edge_of(t, k), reached, waiting);
        }
    }
    return consistent;
}

// Goes to the triangle beyond an edge. Returns whether its side agrees with what was found on other ways.
bool Triangulation::cross_into(EdgeId e, std::vector<bool> &reached, std::vector<TriangleId> &waiting) {
    const TriangleId behind = TriangleNet::triangle_of(net_.twin(e));
    const bool is_inside = net_.inside(TriangleNet::triangle_of(e)) != is_border(e);
    if (reached[static_cast<size_t>(behind)]) {
        return net_.inside(behind) == is_inside;
    }
    reached[static_cast<size_t>(behind)] = true;
    net_.set_inside(behind, is_inside);
    waiting.push_back(behind);
    return true;
}

std::optional<VertexId> Triangulation::insert(const GridPoint &p, TriangleId near, bool split_segments,
                                              std::vector<TriangleId> &changed) {
    changed.clear();
    if (size() == 0) {
        return std::nullopt;
    }
    const GridPlace place = locate(net_, p, real_at(near));
    const bool on_staying =
        place.kind == GridPlace::Kind::edge && net_.mark(place.edge) != TriangleNet::unmarked;
    if (place.kind == GridPlace::Kind::vertex || (on_staying && !split_segments)) {
        return std::nullopt;
    }
    const VertexId v = net_.add_point(p);
    add(v, place);
    const EdgeId start = net_.fan_of(v);
    EdgeId e = start;
    do {
        if (!net_.ghost(TriangleNet::triangle_of(e))) {
            changed.push_back(TriangleNet::triangle_of(e));
        }
        e = net_.next_in_fan(e);
    } while (e != start);
    return v;
}

bool Triangulation::flip(TriangleId t, int k, std::vector<TriangleId> &changed) {
    const EdgeId e = TriangleNet::edge_of(t, k);
    if (net_.mark(e) != TriangleNet::unmarked || !net_.convex_at(e)) {
        return false;
    }
    const TriangleId other = neighbour(t, k);
    changed.insert(changed.end(), {t, other});
    net_.flip(e);
    return true;
}

} // namespace nrb::mesh
