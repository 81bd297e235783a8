// SPDX-License-Identifier: MIT
#include "mesh/delaunay/walks.h"

#include "base/watch.h"

#include <optional>

namespace nrb::mesh {

namespace {

constexpr int64_t work_of_a_step = 10;
// Enough for most walks around a vertex of many triangles, all of which a straight walk would have to look
// at.
constexpr int most_visible_steps = 2000;

using Kind = GridPlace::Kind;

// How the ray from vertex a towards p begins.
struct Departure {
    enum class Kind {
        through, // into the triangle of an edge, which it leaves over this edge
        along,   // on an edge that begins at a
        outside  // into the ghost of an edge
    };
    Kind kind;
    EdgeId edge;
};

// Whether p is beyond the edge of a ghost on the hull; e is one of its other two edges.
bool beyond_hull(const TriangleNet &net, EdgeId e, const GridPoint &p) noexcept {
    const bool first = net.from(e) == TriangleNet::infinite;
    return net.side(first ? TriangleNet::next(e) : TriangleNet::previous(e), p) > 0;
}

// On which side of the ray from a to p a corner is: positive to its left; 0 for the infinite vertex.
int64_t side_of_ray(const TriangleNet &net, VertexId a, const GridPoint &p, VertexId corner) noexcept {
    return corner == TriangleNet::infinite ? 0 : orientation(net.point(a), p, net.point(corner));
}

// Precondition: p is not the point of a.
Departure depart(const TriangleNet &net, VertexId a, const GridPoint &p) {
    EdgeId e = net.fan_of(a);
    // On which side of the ray the corner from(e) is; `left` below is that of to(e).
    int64_t right = side_of_ray(net, a, p, net.from(e));
    for (;; e = net.next_in_fan(e)) {
        count_work(work_of_a_step);
        const VertexId corner = net.from(e);
        const int64_t left = side_of_ray(net, a, p, net.to(e));
        if (right == 0 && corner >= 0 && scalar_product(net.point(a), net.point(corner), p) > 0) {
            return {Departure::Kind::along, TriangleNet::previous(e)};
        }
        if (net.ghost(TriangleNet::triangle_of(e))) {
            if (beyond_hull(net, e, p)) {
                return {Departure::Kind::outside, e};
            }
        } else if (right < 0 && left > 0) {
            return {Departure::Kind::through, e};
        }
        right = left;
    }
}

// The edge that the line from a to p crosses after `crossed`, both of which lead from the right of the line
// to its left; -1 if the apex beyond `crossed` is on the line.
EdgeId next_crossed(const TriangleNet &net, const GridPoint &a, const GridPoint &p, EdgeId crossed) noexcept {
    const EdgeId f = net.twin(crossed);
    const int64_t side = orientation(a, p, net.point(net.apex(f)));
    return side > 0 ? TriangleNet::next(f) : side < 0 ? TriangleNet::previous(f) : -1;
}

// A visibility walk: crosses edges that p is strictly to the right of, until there are none in the triangle.
class VisibleWalk {
public:
    VisibleWalk(const TriangleNet &net, const GridPoint &p, TriangleId start) noexcept
        : net_(net), p_(p), entered_(TriangleNet::edge_of(start, 0)) {}

    // Whether the place is found.
    bool run() {
        if (net_.side(entered_, p_) < 0 && leave_over(entered_)) {
            return true;
        }
        for (int steps = 0; steps < most_visible_steps; ++steps) {
            count_work(work_of_a_step);
            const EdgeId first = TriangleNet::next(entered_), second = TriangleNet::previous(entered_);
            const int64_t left_of_first = net_.side(first, p_);
            const int64_t left_of_second = left_of_first < 0 ? 0 : net_.side(second, p_);
            if (left_of_first >= 0 && left_of_second >= 0) {
                settle(first, left_of_first == 0, second, left_of_second == 0);
                return true;
            }
            if (leave_over(left_of_first < 0 ? first : second)) {
                return true;
            }
        }
        return false;
    }
    [[nodiscard]] const GridPlace &place() const noexcept { return place_; }
    [[nodiscard]] TriangleId triangle() const noexcept { return TriangleNet::triangle_of(entered_); }

private:
    // Crosses an edge. Returns whether this leads outside of the hull.
    bool leave_over(EdgeId e) noexcept {
        entered_ = net_.twin(e);
        place_ = {Kind::triangle, entered_};
        return net_.ghost(TriangleNet::triangle_of(entered_));
    }
    // Sets the place within the triangle: whether p is on two of its edges is given. It can be on the entered
    // one as well only in the first triangle, which was not entered over it.
    void settle(EdgeId first, bool on_first, EdgeId second, bool on_second) noexcept {
        const bool on_entered = net_.side(entered_, p_) == 0;
        if (on_first + on_second + on_entered == 2) {
            place_ = {Kind::vertex, !on_first ? first : !on_second ? second : entered_};
        } else if (on_first || on_second || on_entered) {
            place_ = {Kind::edge, on_first ? first : on_second ? second : entered_};
        } else {
            place_ = {Kind::triangle, entered_};
        }
    }

    const TriangleNet &net_;
    GridPoint p_;
    EdgeId entered_; // p is to the left of it, or on it
    GridPlace place_{Kind::triangle, -1};
};

// A walk along the straight line from a vertex to p, which begins anew at each vertex that the line comes to.
class StraightWalk {
public:
    StraightWalk(const TriangleNet &net, const GridPoint &p, VertexId start) noexcept
        : net_(net), p_(p), vertex_(start) {}

    GridPlace run() {
        while (net_.point(vertex_) != p_) {
            if (const std::optional<GridPlace> place = place_before_vertex()) {
                return *place;
            }
        }
        return {Kind::vertex, net_.fan_of(vertex_)};
    }

private:
    // Follows the line to the next vertex on it, and returns where p is if that is found on the way.
    // Otherwise the walk begins anew at that vertex. It may lie beyond p, in the same triangle: then the way
    // back is short.
    std::optional<GridPlace> place_before_vertex() {
        const auto [kind, edge] = depart(net_, vertex_, p_);
        switch (kind) {
        case Departure::Kind::outside:
            return GridPlace{Kind::triangle, edge};
        case Departure::Kind::along:
            return place_on(edge);
        default:
            return place_beyond(edge);
        }
    }
    std::optional<GridPlace> place_on(EdgeId e) noexcept {
        const VertexId from = vertex_;
        vertex_ = net_.to(e);
        if (scalar_product(p_, net_.point(from), net_.point(vertex_)) < 0) {
            return GridPlace{Kind::edge, e};
        }
        return std::nullopt;
    }
    std::optional<GridPlace> place_beyond(EdgeId crossed) {
        const GridPoint &from = net_.point(vertex_);
        while (crossed >= 0) {
            count_work(work_of_a_step);
            const EdgeId f = net_.twin(crossed);
            if (const int64_t side = net_.side(crossed, p_); side >= 0) {
                return GridPlace{side == 0 ? Kind::edge : Kind::triangle, crossed};
            }
            if (net_.ghost(TriangleNet::triangle_of(f))) {
                return GridPlace{Kind::triangle, f};
            }
            vertex_ = net_.apex(f);
            crossed = next_crossed(net_, from, p_, crossed);
        }
        return std::nullopt;
    }

    const TriangleNet &net_;
    GridPoint p_;
    VertexId vertex_; // where the line begins
};

} // namespace

GridPlace locate(const TriangleNet &net, const GridPoint &p, TriangleId start) {
    VisibleWalk walk(net, p, start);
    if (walk.run()) {
        return walk.place();
    }
    return StraightWalk(net, p, net.apex(TriangleNet::edge_of(walk.triangle(), 0))).run();
}

SegmentPart first_part(const TriangleNet &net, VertexId a, VertexId b, std::vector<EdgeId> &crossed) {
    const GridPoint &p = net.point(a), &q = net.point(b);
    const Departure first = depart(net, a, q);
    if (first.kind == Departure::Kind::along) {
        return {net.to(first.edge), first.edge};
    }
    for (EdgeId e = first.edge; e >= 0; e = next_crossed(net, p, q, e)) {
        count_work(work_of_a_step);
        crossed.push_back(e);
    }
    return {net.apex(net.twin(crossed.back())), -1};
}

VertexId of_fewer_triangles(const TriangleNet &net, VertexId a, VertexId b) {
    const EdgeId start_of_a = net.fan_of(a), start_of_b = net.fan_of(b);
    EdgeId e = start_of_a, f = start_of_b;
    do {
        count_work(work_of_a_step);
        e = net.next_in_fan(e);
        f = net.next_in_fan(f);
    } while (e != start_of_a && f != start_of_b);
    return e == start_of_a ? a : b;
}

} // namespace nrb::mesh
