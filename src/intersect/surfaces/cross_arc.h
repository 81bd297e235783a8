// SPDX-License-Identifier: MIT
// The common curve of two parts of surfaces on which it is a graph.
#pragma once

#include "intersect/graph_arc.h"
#include "intersect/surfaces/cross_chart.h"

namespace nrb::intersect {

// A pair of parts with a chart.
struct CrossBox {
    CrossCell *a, *b;
    CrossChart chart;

    [[nodiscard]] const CrossCell &cell(size_t coordinate) const noexcept { return coordinate < 2 ? *a : *b; }
    [[nodiscard]] double side(size_t coordinate, size_t end) const noexcept {
        return cell(coordinate).side(coordinate % 2, end);
    }
    struct Value {
        Vector3 difference;
        CrossPiece::Point a, b;         // derivatives by places in the parts
        std::array<Vector3, 4> columns; // of F'
    };
    [[nodiscard]] Value at(const CrossPlace &z) const noexcept;
    // Newton's method for F = 0 with one coordinate as it is, in the wide parts; false: there is no zero, or none is found.
    bool solve(size_t fixed, CrossPlace &z) const;
    // As GraphArc asks for.
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

// All that is in a box: N_b x N_a points from the first end to the last one.
struct CrossArc {
    CrossBox box;
    std::array<CrossEnd, 2> ends;
    // It runs along a border of a piece, on which side of it is left open: the piece beyond may have the same arc, or other
    // parts of it. far: how far it is beyond at most, as far as zeros are known, in parts of the piece.
    bool along = false;
    double far = 0;
};

// Finds what is in a box, and what runs along borders of pieces.
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
    Graph::Sides sides_{}; // of the box, or of what arcs along borders may be in
    CrossArc arc_;
};

} // namespace nrb::intersect
