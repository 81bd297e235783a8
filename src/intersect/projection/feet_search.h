// SPDX-License-Identifier: MIT
// Finds all feet of a curve on a surface by subdivision: parts of both in which the feet are one arc, and
// clusters in which they are not resolved.
#pragma once

#include "intersect/projection/feet/feet_chart.h"
#include "intersect/projection/feet_groups.h"
#include "intersect/surfaces/cross_search.h"

#include <vector>

namespace nrb::intersect {

// All feet in a box: one arc, which runs from the first end to the second along the null vector of F'.
struct FeetArc {
    FeetBox box;
    std::array<GraphEnd<3>, 2> ends;
};

struct FeetParts {
    std::vector<FeetArc> arcs;
    std::vector<CrossCluster> clusters; // ranges of (u, v, t, h), with all values of h
};

// A bound of the diameter in space of what the surface has over the ranges of u and v, and the curve over
// that of t. speeds: bounds of the derivatives by u, v and t.
double size_in_space(const std::array<double, 3> &speeds, const std::array<Interval, 4> &ranges) noexcept;

// Breadth-first subdivision of pairs of a part of the surface and a part of the curve: first groups of
// pieces, then pieces, then halves of them, all pairs of one size before smaller ones. A pair is excluded, or
// has a chart (FeetChart) in which its arc is found, or one of its parts is halved. Pairs that are smaller
// than the tolerance become clusters. So do all that are left where feet fill a region, which the growing
// number of pairs shows.
class FeetSearch {
public:
    // lines: distance_lines() of the curve.
    FeetSearch(CrossGround &surface, CrossGround &lines, const Spline &curve, const pieces::Frame &frame);

    // tolerance: in the frame. The arcs refer to cells of the search, and must not outlive it.
    FeetParts run(double tolerance);
    // After run(): bounds of the derivatives of points by u, v and t; infinite if parts without bounds are left.
    [[nodiscard]] std::array<double, 3> speeds() const noexcept {
        return unbounded_ ? std::array{infinity, infinity, infinity} : speeds_;
    }

private:
    using Sides = GraphArc<FeetBox, 3>::Sides;
    // graph: the pair comes from one that had a chart, and is not added as a cluster; see CrossSearch.
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
