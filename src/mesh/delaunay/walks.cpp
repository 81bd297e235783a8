// SPDX-License-Identifier: MIT
#include "mesh/delaunay/walks.h"

#include "base/watch.h"

#include <optional>

namespace nrb::mesh {

namespace {

constexpr int64_t work_of_a_step = 10;
// Enough for most ways around a vertex of many triangles, where a straight line has to look at all of them.
constexpr int most_visible_steps = 2000;

using Kind = GridPlace::Kind;

// How the ray from vertex a towards p begins.
struct Departure {
    enum class Kind {
        through, // into the triangle of an edge, which it leaves over this edge
        along,   // on an edge that begins at a
        outside  // into a ghost
    };
    Kind kind;
    EdgeId edge;
};

// Whether p is beyond the edge of a ghost; e is one of the other two.
bool beyond_hull(const TriangleNet &net, EdgeId e, const GridPoint &p) noexcept {
    const bool first = net.from(e) == TriangleNet::infinite;
    return net.side(first ? TriangleNet::next(e) : TriangleNet::previous(e), p) > 0;
}

// 0 for the infinite vertex.
int64_t side_of_ray(const TriangleNet &net, VertexId a, const GridPoint &p, VertexId corner) noexcept {
    return corner == TriangleNet::infinite ? 0 : orientation(net.point(a), p, net.point(corner));
}

// Precondition: p is not the point of a.
Departure depart(const TriangleNet &net, VertexId a, const GridPoint &p) {
    EdgeId e = net.fan_of(a);
    // of the corners of each triangle, as the ray sees them
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

// Over an edge from the right of the line from a to p to the left of it: the next edge, from right to left
// again, or -1 if the apex behind is on the line.
EdgeId next_crossed(const TriangleNet &net, const GridPoint &a, const GridPoint &p, EdgeId crossed) noexcept {
    const EdgeId f = net.twin(crossed);
    const int64_t side = orientation(a, p, net.point(net.apex(f)));
    return side > 0 ? TriangleNet::next(f) : side < 0 ? TriangleNet::previous(f) : -1;
}

// Edges of which p is to the left in every step, until it is of all three.
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
    // Whether this leads outside.
    bool leave_over(EdgeId e) noexcept {
        entered_ = net_.twin(e);
        place_ = {Kind::triangle, entered_};
        return net_.ghost(TriangleNet::triangle_of(entered_));
    }
    // p is on those edges that are told, and it may be on that over which the triangle was entered if it is the first one.
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

// Along the straight line from a vertex, and from each other vertex that this comes to.
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
    // Nothing if the line comes to a vertex first, or to one at the corner behind p, from which the way back is short.
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
    VertexId vertex_; // where the line begins, or goes on
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
