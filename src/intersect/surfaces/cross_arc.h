// SPDX-License-Identifier: MIT
// The common curve of two parts of surfaces on which it is a graph.
#pragma once

#include "intersect/surfaces/cross_chart.h"

#include <optional>
#include <vector>

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
};

// A zero on the border of a box.
struct CrossEnd {
    CrossPlace at{};       // places in the parts
    size_t coordinate = 0; // the side on which it is
    size_t side = 0;       // 0: the lower one
    bool open = false;     // the surface ends there
};

// All that is in a box: N_b x N_a points from the first end to the last one.
struct CrossArc {
    CrossBox box;
    std::array<CrossEnd, 2> ends;
    // It runs along a border of a piece, on which side of it is left open: the piece beyond may have the same arc, or other
    // parts of it. far: how far it is beyond at most, as far as zeros are known, in parts of the piece.
    bool along = false;
    double far = 0;
};

// Finds what is in a box. As zeros are a graph whose differences have known signs, one place of the box at a zero, and the
// two where the curve through it leaves the box, are all that has to be found.
class ArcFinder {
public:
    enum class Verdict {
        nothing, // for certain
        arc,     // one
        open,    // the box is too large to tell
    };
    Verdict look(const CrossBox &box);
    [[nodiscard]] const CrossArc &arc() const noexcept { return arc_; }

private:
    using Sides = std::array<std::array<double, 2>, 4>;

    Verdict look_between_sides(int parts);
    Verdict look_along_borders();
    bool move_sides();
    bool set_along(size_t coordinate, size_t side);
    [[nodiscard]] bool goes_on() const;
    void set_zeros(int parts);
    [[nodiscard]] bool changes(size_t coordinate) const noexcept; // whether it may rise and fall
    [[nodiscard]] bool is_between_sides(const CrossPlace &z) const noexcept;
    std::optional<Verdict> find_inside();
    // Leaves of a range of coordinate k what zeros of the box may have, where values of F are off by `near`; z0: any place, with the step
    // M F there.
    void clip(const CrossPlace &z0, const CrossPlace &step, double near, Interval &range) const;
    CrossPlace leave(double way, CrossEnd &end) const;
    bool is_beyond(CrossEnd &end) const;
    bool find_end(double way, CrossEnd &end) const;
    void move_to_border(CrossEnd &end) const;
    [[nodiscard]] bool stays(size_t coordinate) const;

    const CrossBox *box_ = nullptr;
    Sides sides_{};       // of the box, or of what arcs along borders may be in
    CrossPlace inside_{}; // a zero in the box
    CrossPlace near_{};   // a zero in or beside it
    bool is_near_ = false;
    std::vector<CrossPlace> zeros_; // of the arc, by rising k
    CrossArc arc_;
};

} // namespace nrb::intersect
