// SPDX-License-Identifier: MIT
// The result of an intersection that consists of curves: branches, the nodes at which they end, and ways,
// which are chains of branches.
#pragma once

#include "spline/spline.h"

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

namespace nrb::intersect {

enum class NodeKind : int32_t {
    border = 1,    // the surface ends or jumps there
    seam = 2,      // it closes there on an axis that is not periodic: the branch continues on the other side
    touch = 3,     // a part near all over, in which branches cannot be separated: a pole, a saddle, a peak
    undecided = 4, // a part whose contents are left open
    edge = 5,      // an edge or a vertex of a model, at which the branch on another face continues
    fold = 6,      // the surface folds as seen along a direction: the branch continues on another sheet
    overlap = 7,   // a region in which two surfaces coincide: a place inside, and its box
};

// The end of a branch, or a part that is reported itself.
struct MeetNode {
    int64_t level; // index of the value; for overlaps the number of the region, from 1
    NodeKind kind;
    std::array<double, 2> at;          // parameters
    std::array<Interval, 2> range;     // the box of a part
    int64_t next = -1;                 // the node at which the adjoining branch begins or ends; -1: none
    int64_t face = -1, instance = -1;  // of a model
    double gap = 0;                    // in space, to the next node
    std::array<double, 2> at_second{}; // the same on the second surface, if there are two
    std::array<Interval, 2> range_second{};
    int64_t second_face = -1, second_instance = -1; // of the second model, if there are two
};

enum class BranchKind : int32_t {
    crossing = 1, // common to two surfaces, or to a surface and a plane
    edge = 2,     // an edge that two faces share
    contact = 3,  // common, with equal tangent planes somewhere at least
    touch = 4,    // common, with equal tangent planes everywhere
    overlap = 5,  // a part of the boundary of a region in which two surfaces coincide
};

// A curve with common knots in space and in the parameter domain.
struct MeetBranch {
    int64_t level;
    SplinePtr space, on;
    double deviation;                 // a bound for either, in space
    std::array<int64_t, 2> nodes;     // -1: closed
    int64_t loop;                     // index of the closed way that it belongs to; -1: none
    int64_t face = -1, instance = -1; // of a model
    SplinePtr on_second = nullptr;    // in the domain of the second surface, if there are two
    BranchKind kind = BranchKind::crossing;
    int64_t second_face = -1, second_instance = -1; // of the second model, if there are two
};

// A way: branches in sequence, each of which continues where the one before ends.
struct MeetWay {
    int64_t level;
    int64_t first, count; // branches
    bool closed;          // the last one continues in the first one
    double gap;           // the largest one between consecutive branches
};

struct Meet {
    std::vector<MeetBranch> branches; // those of a loop are consecutive
    std::vector<MeetNode> nodes;
    std::vector<MeetWay> ways; // set by arranged()
    bool complete = true;      // no node is undecided
    bool limited = false;      // some are undecided because the work limit was reached
    bool of_two = false;       // there are two surfaces: branches and nodes are on the second one, too
    // For each of two surfaces the domains of its periodic axes, on which branches may run into neighbouring
    // periods.
    std::array<std::array<std::optional<Interval>, 2>, 2> periodic{};

    // Adds the branches and nodes of other levels.
    void append(Meet other);
    // Drops the nodes at which no branch ends any more, except for touches, overlaps and undecided parts, and
    // orders the others by level. `complete` becomes false if an undecided one is left.
    void tidy_nodes();
};

// Sets the ways. The branches of a way become consecutive, and the ways of a level follow the order of their
// first branches.
Meet arranged(Meet meet);

// Sets the loops of branches from the closed ways.
Meet with_loops(Meet meet);

} // namespace nrb::intersect
