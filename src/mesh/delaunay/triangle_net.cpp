// SPDX-License-Identifier: MIT
#include "mesh/delaunay/triangle_net.h"

#include "base/error.h"

#include <utility>

namespace nrb::mesh {

TriangleNet::TriangleNet(std::vector<GridPoint> points, const GridMetric &metric)
    : points_(std::move(points)), metric_(metric), fans_(points_.size() + 1, -1) {}

void TriangleNet::set_mark(EdgeId e, int32_t mark) noexcept {
    join(e, twin(e), mark);
}

bool TriangleNet::circle_contains(TriangleId t, const GridPoint &p) const noexcept {
    const auto &[a, b, c] = at(t).corner;
    if ((a | b | c) >= 0) {
        return metric_ == GridMetric{} ? in_circle(point(a), point(b), point(c), p)
                                       : in_circle(metric_, point(a), point(b), point(c), p);
    }
    const EdgeId e = edge_of(t, a < 0 ? 0 : b < 0 ? 1 : 2);
    return side(e, p) > 0;
}

bool TriangleNet::convex_at(EdgeId e) const noexcept {
    if (ghost(triangle_of(e)) || ghost(triangle_of(twin(e)))) {
        return false;
    }
    const GridPoint &p = point(apex(e)), &q = point(apex(twin(e)));
    return orientation(p, point(from(e)), q) > 0 && orientation(p, q, point(to(e))) > 0;
}

void TriangleNet::start(VertexId a, VertexId b, VertexId c) {
    const EdgeId inner = edge_of(add_triangle(a, b, c), 0);
    const EdgeId ghosts[3] = {edge_of(add_triangle(infinite, c, b), 0),
                              edge_of(add_triangle(infinite, a, c), 0),
                              edge_of(add_triangle(infinite, b, a), 0)};
    for (int k = 0; k < 3; ++k) {
        join(inner + k, ghosts[k], unmarked);
        // Around the infinite vertex, the ghosts follow each other clockwise.
        join(next(ghosts[k]), previous(ghosts[(k + 2) % 3]), unmarked);
    }
}

VertexId TriangleNet::add_point(const GridPoint &p) {
    if (points_.size() >= size_t{most_vertices}) {
        fail(Status::overflow, "more than %d vertices of a triangulation", most_vertices);
    }
    fans_.push_back(-1);
    points_.push_back(p);
    return static_cast<VertexId>(points_.size()) - 1;
}

// The triangle (c, a, b) of e = ab becomes (v, a, b); the new triangles are (v, b, c) and (v, c, a).
void TriangleNet::split_triangle(EdgeId e, VertexId v) {
    reserve_triangles(2);
    const VertexId a = from(e), b = to(e), c = apex(e);
    const bool is_inside = inside(triangle_of(e));
    const EdgeId bc = edge_of(add_triangle(v, b, c), 0), ca = edge_of(add_triangle(v, c, a), 0);
    set_inside(triangle_of(bc), is_inside);
    set_inside(triangle_of(ca), is_inside);
    join(bc, twin(next(e)), mark(next(e)));
    join(ca, twin(previous(e)), mark(previous(e)));
    set_apex(e, v);
    join(next(e), previous(bc), unmarked);
    join(next(bc), previous(ca), unmarked);
    join(next(ca), previous(e), unmarked);
}

// Splitting one triangle leaves a triangle on e without area. The flip turns this one and its neighbour
// across e into the halves of the neighbour.
void TriangleNet::split_edge(EdgeId e, VertexId v) {
    const EdgeId other = twin(e);
    const int32_t old_mark = mark(e);
    split_triangle(e, v);
    flip(e);
    set_inside(triangle_of(e), inside(triangle_of(other)));
    set_mark(previous(e), old_mark);
    set_mark(other, old_mark);
}

void TriangleNet::flip(EdgeId e) noexcept {
    const EdgeId f = twin(e), outer = twin(next(e)), other_outer = twin(next(f));
    const VertexId a = from(e), b = to(e);
    set_apex(previous(e), apex(f));
    set_apex(previous(f), apex(e));
    set_fan(a, next(e));
    set_fan(b, next(f));
    join(f, outer, mark(outer));
    join(e, other_outer, mark(other_outer));
    join(next(e), next(f), unmarked);
}

TriangleId TriangleNet::add_triangle(VertexId a, VertexId b, VertexId c) {
    triangles_.push_back({{a, b, c}, {-1, -1, -1}, {unmarked, unmarked, unmarked}, false});
    const TriangleId t = size() - 1;
    set_fan(a, edge_of(t, 0));
    set_fan(b, edge_of(t, 1));
    set_fan(c, edge_of(t, 2));
    return t;
}

void TriangleNet::reserve_triangles(size_t more) {
    const size_t needed = triangles_.size() + more;
    if (needed > triangles_.capacity()) {
        triangles_.reserve(needed + needed / 2);
    }
}

void TriangleNet::join(EdgeId e, EdgeId twin, int32_t mark) noexcept {
    at(triangle_of(e)).twin[e & 3] = twin;
    at(triangle_of(e)).mark[e & 3] = mark;
    at(triangle_of(twin)).twin[twin & 3] = e;
    at(triangle_of(twin)).mark[twin & 3] = mark;
}

void TriangleNet::move_last_to(TriangleId t) noexcept {
    const TriangleId last = size() - 1;
    at(t) = at(last);
    for (int k = 0; k < 3; ++k) {
        const EdgeId e = edge_of(t, k);
        set_fan(apex(e), e);
        join(e, twin(e), mark(e));
    }
    triangles_.pop_back();
}

} // namespace nrb::mesh
