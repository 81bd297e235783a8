// SPDX-License-Identifier: MIT
// What must hold for constrained Delaunay triangulations, in exact arithmetic that shares nothing with the library's.
#pragma once

#include "mesh/delaunay/triangulation.h"

#include <algorithm>
#include <boost/multiprecision/cpp_int.hpp>
#include <gtest/gtest.h>
#include <map>
#include <random>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace delaunay_test {

using nrb::mesh::grid_end;
using nrb::mesh::GridMetric;
using nrb::mesh::GridPoint;
using nrb::mesh::TriangleId;
using nrb::mesh::Triangulation;
using nrb::mesh::VertexId;
using Segment = Triangulation::Segment;
using Points = std::vector<GridPoint>;
using Wide = boost::multiprecision::int128_t;

constexpr uint64_t seed = 20261129;

// The determinant of the rows (u, v, 1), by all its six terms.
inline Wide doubled_area(const GridPoint &a, const GridPoint &b, const GridPoint &c) {
    const auto term = [](const GridPoint &p, const GridPoint &q) {
        return Wide{p.u} * q.v - Wide{p.v} * q.u;
    };
    return term(a, b) + term(b, c) + term(c, a);
}

// Positive inside of the circle: the determinant of the rows (u, v, u^2 + v^2, 1) along its third column.
inline Wide power(const GridPoint &a, const GridPoint &b, const GridPoint &c, const GridPoint &d) {
    const auto square = [](const GridPoint &p) { return Wide{p.u} * p.u + Wide{p.v} * p.v; };
    return square(a) * doubled_area(b, c, d) - square(b) * doubled_area(a, c, d) +
           square(c) * doubled_area(a, b, d) - square(d) * doubled_area(a, b, c);
}

inline bool on_segment(const GridPoint &a, const GridPoint &b, const GridPoint &p) {
    return doubled_area(a, b, p) == 0 && Wide{p.u - a.u} * (p.u - b.u) + Wide{p.v - a.v} * (p.v - b.v) <= 0;
}

// Whether segments meet in a point that is within both.
inline bool cross(const GridPoint &a, const GridPoint &b, const GridPoint &c, const GridPoint &d) {
    const auto opposite = [](Wide x, Wide y) { return (x < 0 && y > 0) || (x > 0 && y < 0); };
    return opposite(doubled_area(a, b, c), doubled_area(a, b, d)) &&
           opposite(doubled_area(c, d, a), doubled_area(c, d, b));
}

// Twice the area of the convex hull (Andrew's chains), from sorted points.
inline Wide doubled_hull_area(Points points) {
    const auto less = [](const GridPoint &a, const GridPoint &b) {
        return std::pair(a.u, a.v) < std::pair(b.u, b.v);
    };
    std::sort(points.begin(), points.end(), less);
    Wide area = 0;
    for (int side = 0; side < 2; ++side) {
        Points chain;
        for (const GridPoint &p : points) {
            while (chain.size() > 1 && doubled_area(chain[chain.size() - 2], chain.back(), p) <= 0) {
                chain.pop_back();
            }
            chain.push_back(p);
        }
        for (size_t i = 1; i < chain.size(); ++i) {
            area += doubled_area({0, 0}, chain[i - 1], chain[i]);
        }
        std::reverse(points.begin(), points.end());
    }
    return area;
}

inline GridPoint corner(const Triangulation &t, TriangleId id, int k) {
    return t.vertices()[static_cast<size_t>(t.corners(id)[static_cast<size_t>(k)])];
}

// Of the neighbour over edge k: the edge that is the same one, or -1.
inline int opposite_edge(const Triangulation &t, TriangleId id, int k) {
    const auto here = t.corners(id), there = t.corners(t.neighbour(id, k));
    for (size_t j = 0; j < 3; ++j) {
        const auto i = static_cast<size_t>(k);
        if (there[(j + 1) % 3] == here[(i + 2) % 3] && there[(j + 2) % 3] == here[(i + 1) % 3] &&
            t.neighbour(t.neighbour(id, k), static_cast<int>(j)) == id) {
            return static_cast<int>(j);
        }
    }
    return -1;
}

// Whether an edge is a diagonal of a strictly convex quadrilateral.
inline bool is_diagonal(const Triangulation &t, TriangleId id, int k) {
    const TriangleId other = t.neighbour(id, k);
    return !t.ghost(id) && !t.ghost(other) &&
           cross(corner(t, id, k), corner(t, other, opposite_edge(t, id, k)), corner(t, id, (k + 1) % 3),
                 corner(t, id, (k + 2) % 3));
}

// Why an edge is not as it should be, or nothing: both sides tell the same of it, and it is Delaunay unless it stays.
inline std::string fault_of_edge(const Triangulation &t, TriangleId id, int k, bool delaunay) {
    const int j = opposite_edge(t, id, k);
    if (j < 0) {
        return "neighbours do not share an edge";
    }
    const TriangleId other = t.neighbour(id, k);
    if (t.label(id, k) != t.label(other, j) || t.border(id, k) != t.border(other, j)) {
        return "the sides of an edge differ";
    }
    if (!delaunay || t.constrained(id, k) || t.ghost(id) || t.ghost(other)) {
        return "";
    }
    const bool empty = power(corner(t, id, 0), corner(t, id, 1), corner(t, id, 2), corner(t, other, j)) <= 0;
    return empty ? "" : "a circle is not empty";
}

// A triangulation of the hull: all triangles are counterclockwise, neighbours agree, the areas add up, and vertices, triangles
// and edges of the hull are as many as Euler says.
inline std::string fault_of(const Triangulation &t, bool delaunay = true) {
    Wide area = 0;
    int64_t ghosts = 0;
    std::vector<bool> used(t.vertices().size());
    for (TriangleId id = 0; id < t.size(); ++id) {
        for (int k = 0; k < 3; ++k) {
            if (const std::string fault = fault_of_edge(t, id, k, delaunay); !fault.empty()) {
                return fault;
            }
        }
        if (t.ghost(id)) {
            ++ghosts;
            continue;
        }
        for (const VertexId v : t.corners(id)) {
            used[static_cast<size_t>(v)] = true;
        }
        const Wide twice = doubled_area(corner(t, id, 0), corner(t, id, 1), corner(t, id, 2));
        if (twice <= 0) {
            return "a triangle is not counterclockwise";
        }
        area += twice;
    }
    if (area != doubled_hull_area(t.vertices())) {
        return "the areas do not add up to the hull";
    }
    const bool all = std::find(used.begin(), used.end(), false) == used.end();
    const auto n = static_cast<int64_t>(used.size());
    return all && t.size() - ghosts == 2 * n - 2 - ghosts ? "" : "not Euler's number of triangles";
}

// The edges that stay, from the smaller vertex to the larger one, with their labels.
inline std::map<std::pair<VertexId, VertexId>, int32_t> staying_edges(const Triangulation &t) {
    std::map<std::pair<VertexId, VertexId>, int32_t> edges;
    for (TriangleId id = 0; id < t.size(); ++id) {
        for (int k = 0; k < 3; ++k) {
            if (t.constrained(id, k)) {
                const auto corners = t.corners(id);
                const auto i = static_cast<size_t>(k);
                const auto [a, b] = std::minmax({corners[(i + 1) % 3], corners[(i + 2) % 3]});
                edges[{a, b}] = t.label(id, k);
            }
        }
    }
    return edges;
}

// The vertices on a segment, in order.
inline std::vector<VertexId> vertices_on(const Triangulation &t, const Segment &segment) {
    const Points &points = t.vertices();
    const GridPoint a = points[static_cast<size_t>(segment.from)],
                    b = points[static_cast<size_t>(segment.to)];
    std::vector<VertexId> on;
    for (size_t v = 0; v < points.size(); ++v) {
        if (on_segment(a, b, points[v])) {
            on.push_back(static_cast<VertexId>(v));
        }
    }
    const auto far = [&](VertexId v) {
        const GridPoint &p = points[static_cast<size_t>(v)];
        return std::abs(int64_t{p.u} - a.u) + std::abs(int64_t{p.v} - a.v);
    };
    std::sort(on.begin(), on.end(), [&](VertexId x, VertexId y) { return far(x) < far(y); });
    return on;
}

// Exactly the parts of those that are not left out stay, with the label of the first of them.
inline void expect_segments(const Triangulation &t, const std::vector<Segment> &segments,
                            const std::set<size_t> &out) {
    std::map<std::pair<VertexId, VertexId>, int32_t> expected;
    for (size_t i = 0; i < segments.size(); ++i) {
        const std::vector<VertexId> on = vertices_on(t, segments[i]);
        for (size_t k = 1; k < on.size() && out.count(i) == 0; ++k) {
            const auto [a, b] = std::minmax(on[k - 1], on[k]);
            expected.insert({{a, b}, segments[i].label});
        }
    }
    EXPECT_EQ(staying_edges(t), expected);
}

// Whether the middle of a triangle is inside by parity of the borders that a ray from it crosses, in three times finer coordinates.
inline bool parity_of(const Triangulation &t, TriangleId id, const std::vector<Segment> &segments) {
    Wide u = 0, v = 0;
    for (int k = 0; k < 3; ++k) {
        u += corner(t, id, k).u;
        v += corner(t, id, k).v;
    }
    bool inside = false;
    for (const Segment &segment : segments) {
        const GridPoint &a = t.vertices()[static_cast<size_t>(segment.from)];
        const GridPoint &b = t.vertices()[static_cast<size_t>(segment.to)];
        const bool a_above = Wide{a.v} * 3 > v, b_above = Wide{b.v} * 3 > v;
        if (segment.border && a_above != b_above) {
            const Wide left =
                (Wide{b.u} - a.u) * (v - Wide{a.v} * 3) - (Wide{b.v} - a.v) * (u - Wide{a.u} * 3);
            inside ^= (left > 0) == b_above;
        }
    }
    return inside;
}

inline void expect_parity(const Triangulation &t, const std::vector<Segment> &segments) {
    for (TriangleId id = 0; id < t.size(); ++id) {
        ASSERT_EQ(t.inside(id), !t.ghost(id) && parity_of(t, id, segments));
    }
}

inline Points random_points(std::mt19937_64 &random, size_t count, int32_t end) {
    std::uniform_int_distribution<int32_t> coordinate(0, end);
    Points points(count);
    for (GridPoint &p : points) {
        p = {coordinate(random), coordinate(random)};
    }
    return points;
}

// Few lines and circles, or only the ends of the grid and what is next to them: most triples and quadruples are degenerate.
inline Points awkward_points(std::mt19937_64 &random, size_t count, int kind) {
    Points points = random_points(random, count, kind == 0 ? grid_end : kind == 1 ? 7 : kind == 2 ? 40 : 3);
    if (kind == 3) {
        for (GridPoint &p : points) {
            p = {p.u < 2 ? p.u : grid_end - 3 + p.u, p.v < 2 ? p.v : grid_end - 3 + p.v};
        }
    }
    return points;
}

} // namespace delaunay_test
