// SPDX-License-Identifier: MIT
// Curves of a domain cut wherever they meet.
#pragma once

#include "base/disjoint_sets.h"
#include "face/checks/loop_hits.h"

#include <set>
#include <utility>
#include <vector>

namespace nrb::face {

// The part of a curve from one node to the next.
struct CutEdge {
    size_t curve; // of the hits
    Interval range;
    size_t from, to; // nodes
};

// Edges that run along each other from end to end.
struct EdgePair {
    size_t a, b;
    bool against; // b runs against a
};

// Places where curves begin, end, cross, touch, and where what they have in common begins and ends are nodes; those that are
// near each other are one. The position of a node is that of an end of a curve, bit for bit, if there is one in it.
class Cuts {
public:
    // near: in the units of the hits; nodes are in the domain along closed axes. Throws Status::not_converged where what curves have in common is left open, or differs
    // from one of them to the other.
    Cuts(const Covering &covering, const LoopHits &hits, double near);

    [[nodiscard]] const std::vector<Point2> &nodes() const noexcept { return nodes_; }
    // By curves and parameters, without those that are no longer than what is near.
    [[nodiscard]] const std::vector<CutEdge> &edges() const noexcept { return edges_; }
    [[nodiscard]] const std::vector<EdgePair> &pairs() const noexcept { return pairs_; }

private:
    struct Mark {
        size_t curve;
        double at;
        friend auto operator<=>(const Mark &, const Mark &) = default;
    };

    void add_marks();
    void add_marks(const LoopHit &hit);
    [[nodiscard]] bool is_short(const LoopHit &hit) const;
    void add_touch(const LoopHit &hit);
    void add_reached(const LoopHit &hit);
    void link_near(const Mark &a, const Mark &b, const Point2 &move);
    [[nodiscard]] double end_of(size_t curve, bool upper) const noexcept;
    [[nodiscard]] bool is_loose(size_t curve, bool upper) const;
    [[nodiscard]] const Mark *mark_in(size_t curve, Interval range, double at) const;
    void add_marks_under_overlaps();
    Mark add(size_t curve, double t);
    [[nodiscard]] double at_knot(size_t curve, double t) const;
    [[nodiscard]] bool is_small(size_t curve, Interval range) const;
    void join_marks();
    void join_near(const std::vector<Point2> &places, DisjointSets &sets) const;
    void set_nodes(std::vector<size_t> &names);
    [[nodiscard]] bool is_end(const Mark &mark) const noexcept;
    void add_edges();
    void add_edge(const Mark &from, const Mark &to);
    void add_pairs(const LoopHit &hit);
    void add_pair(const LoopHit &hit, size_t edge);
    [[nodiscard]] std::pair<size_t, size_t> edges_in(size_t curve, Interval range) const;
    [[nodiscard]] Point2 beside(const LoopHit &hit, double t) const;
    [[noreturn]] void fail_at(const LoopHit &hit) const;

    const Covering &covering_;
    const LoopHits &hits_;
    double near_;
    std::set<Mark> found_;
    std::vector<Mark> marks_; // the same, all of them
    std::vector<std::pair<Mark, Mark>> links_;
    std::vector<size_t> node_of_; // of the marks
    std::vector<Point2> nodes_;
    std::vector<CutEdge> edges_;
    std::vector<EdgePair> pairs_;
};

} // namespace nrb::face
