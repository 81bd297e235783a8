// SPDX-License-Identifier: MIT
// Finds the parts of a surface and of a curve in which there are feet, and the curves of these in them.
#pragma once

#include "intersect/projection/feet/feet_chart.h"
#include "intersect/projection/feet_groups.h"
#include "intersect/surfaces/cross_search.h"

#include <vector>

namespace nrb::intersect {

// All that is in a box: along the null vector of F' from the first end to the last one.
struct FeetArc {
    FeetBox box;
    std::array<GraphEnd<3>, 2> ends;
};

struct FeetParts {
    std::vector<FeetArc> arcs;
    std::vector<CrossCluster> clusters; // with all of the second parameter of lines
};

// How far points of ranges of u, v and t may be from each other at most; speeds: the largest derivatives.
double size_in_space(const std::array<double, 3> &speeds, const std::array<Interval, 4> &ranges) noexcept;

// Groups of pieces, then pieces, then their parts, all of one size before smaller ones: a pair has no feet, has a chart in
// which its arc is found, or one of both is halved. What is smaller than the tolerance is left as a cluster; so is what is left
// where feet fill regions, which the number of pairs tells.
class FeetSearch {
public:
    // lines: distance_lines() of the curve.
    FeetSearch(CrossGround &surface, CrossGround &lines, const Spline &curve, const pieces::Frame &frame);

    // tolerance: in the frame. The cells that arcs are in last as long as the search.
    FeetParts run(double tolerance);
    // Of what was found: the largest derivatives of points by u, v and t, infinite ones if parts without any bound are left.
    [[nodiscard]] const std::array<double, 3> &speeds() const noexcept { return speeds_; }

private:
    using Sides = GraphArc<FeetBox, 3>::Sides;
    // graph: of a pair that had a chart; see CrossSearch.
    struct Pair {
        FeetCell *patch, *span;
        bool graph = false;
    };

    void find_pieces();
    void look_at(FeetGroup &surface, FeetGroup &curve);
    void look(const Pair &pair);
    void look_in_chart(const Pair &pair);
    GraphVerdict look_along_borders(const Sides &sides);
    [[nodiscard]] GraphVerdict on_own_side(const Sides &sides, const Sides &moved) const;
    void halve(const Pair &pair, size_t axis);
    bool settle_crowd();
    [[nodiscard]] bool is_hidden(const Pair &pair) const noexcept;
    void add(const Pair &pair);
    void add_unknown(const FeetGroup &surface, const FeetGroup &curve);
    [[nodiscard]] static FeetPlace lengths_of(const Pair &pair) noexcept;
    [[nodiscard]] bool is_small(const Pair &pair) const noexcept;
    [[nodiscard]] std::array<Interval, 4> ranges_of(const Pair &pair) const noexcept;

    const pieces::PieceGrid &grid_, &lines_;
    FeetGroups patches_, spans_;
    std::array<double, 3> speeds_;
    bool unbounded_ = false; // parts are left that have none
    double tolerance_ = 0;
    std::vector<std::pair<FeetGroup *, FeetGroup *>> stack_;
    std::vector<Pair> pairs_, next_;
    FeetNets nets_;
    FeetBox box_;
    GraphArc<FeetBox, 3> finder_;
    FeetParts found_;
};

} // namespace nrb::intersect
