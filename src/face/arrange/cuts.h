// SPDX-License-Identifier: MIT
// The curves of a domain cut into edges wherever they meet.
#pragma once

#include "base/disjoint_sets.h"
#include "face/checks/loop_hits.h"

#include <set>
#include <utility>
#include <vector>

namespace nrb::face {

// The part of a curve from one node to the next.
struct CutEdge {
    size_t curve; // index into the curves of the hits
    Interval range;
    size_t from, to; // nodes
};

// Two edges that run along each other from end to end.
struct EdgePair {
    size_t a, b;
    bool against; // b runs against a
};

// Nodes are the places where curves begin, end, cross or touch, and where overlaps begin and end. A mark is
// the parameter of a curve at such a place. Marks that a hit links, and marks near each other, are one node.
// If one of them is the end of a curve, the node is at that end bit for bit.
class Cuts {
public:
    // near: the distance that counts as none, in the units of the hits. Along closed axes nodes lie in the
    // domain. Throws Status::not_converged where the hits leave open what two curves have in common, where
    // the edges of two curves do not correspond along an overlap, or where the marks of a node are far apart.
    Cuts(const Covering &covering, const LoopHits &hits, double near);

    [[nodiscard]] const std::vector<Point2> &nodes() const noexcept { return nodes_; }
    // Sorted by curve and parameter. Parts of a curve that begin and end at one node are left out if they go
    // no farther than the marks of a node may lie from it.
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
    std::vector<Mark> marks_;                  // the same when it is complete, sorted
    std::vector<std::pair<Mark, Mark>> links_; // marks of one node
    std::vector<size_t> node_of_;              // by marks
    std::vector<Point2> nodes_;
    std::vector<CutEdge> edges_;
    std::vector<EdgePair> pairs_;
};

} // namespace nrb::face
