// SPDX-License-Identifier: MIT
// The common curve of two surface parts, where it is a graph over one of their four parameters: one arc
// between two points on the border of the box.
#pragma once

#include "intersect/graph_arc.h"
#include "intersect/surfaces/cross_chart.h"

namespace nrb::intersect {

// A pair of parts with a chart: the box of four parameters in which zeros of F = A - B are looked for.
struct CrossBox {
    CrossCell *a, *b;
    CrossChart chart;

    [[nodiscard]] const CrossCell &cell(size_t coordinate) const noexcept { return coordinate < 2 ? *a : *b; }
    [[nodiscard]] double side(size_t coordinate, size_t end) const noexcept {
        return cell(coordinate).side(coordinate % 2, end);
    }
    struct Value {
        Vector3 difference;
        CrossPiece::Point a, b;         // with the derivatives by places in the parts
        std::array<Vector3, 4> columns; // of F', by u, v, s and t
    };
    [[nodiscard]] Value at(const CrossPlace &z) const noexcept;
    // Newton's method for F = 0 with coordinate `fixed` held, in the wide parts. False: there is no zero, or
    // none is found.
    bool solve(size_t fixed, CrossPlace &z) const;
    // The rest of the interface that GraphArc requires.
    [[nodiscard]] double length(size_t coordinate) const noexcept {
        return cell(coordinate).length(coordinate % 2);
    }
    [[nodiscard]] const CrossPlace &start() const noexcept { return chart.start(); }
    [[nodiscard]] CrossPlace step_at(const CrossPlace &z) const noexcept {
        return chart.step(at(z).difference);
    }
    [[nodiscard]] CrossPlace tangent_at(const CrossPlace &z) const noexcept;
};

using CrossEnd = GraphEnd<4>;

// All zeros of a box: one arc, which runs along N_b x N_a, the cross product of the surface normals, from the
// first end to the last one.
struct CrossArc {
    CrossBox box;
    std::array<CrossEnd, 2> ends;
    // along: the arc runs along a border of a piece, and it is left open on which side of it; the piece
    // beyond the border may have the same arc, or other parts of it. far: the largest distance of its known
    // zeros beyond the border, in lengths of the piece.
    bool along = false;
    double far = 0;
};

// Finds the arc in a box, if there is one. It may run along a border of a piece, with zeros a little beyond
// it.
class ArcFinder {
public:
    using Verdict = GraphVerdict;
    Verdict look(const CrossBox &box);
    [[nodiscard]] const CrossArc &arc() const noexcept { return arc_; }

private:
    using Graph = GraphArc<CrossBox, 4>;

    Verdict look_between_sides(int parts);
    Verdict look_along_borders();
    bool move_sides();
    bool set_along(size_t coordinate, size_t side);
    [[nodiscard]] bool goes_on() const;
    void move_to_border(CrossEnd &end) const;

    const CrossBox *box_ = nullptr;
    Graph graph_;
    Graph::Sides sides_{}; // of the box, or moved outwards for arcs along borders
    CrossArc arc_;
};

} // namespace nrb::intersect
