// SPDX-License-Identifier: MIT
// What is found where a function over a surface has given values.
#pragma once

#include "spline/spline.h"

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

namespace nrb::intersect {

enum class NodeKind : int32_t {
    border = 1, // the surface ends or jumps there
    seam = 2,   // it closes there on an axis that is not periodic: the branch goes on on the other side
    touch = 3, // a part that is near all over, in which branches are not told apart: a pole, a saddle, a peak
    undecided = 4, // it is left open what there is
    edge = 5,      // an edge or a vertex of a model, at which the branch of another face goes on
    fold = 6,      // the surface folds as seen along a direction: the branch goes on in another sheet
    overlap = 7,   // a region in which two surfaces are one: a place inside, and its box
};

// Where branches end.
struct MeetNode {
    int64_t level; // index of the value; of overlaps the number of the region, from 1
    NodeKind kind;
    std::array<double, 2> at;         // parameters
    std::array<Interval, 2> range;    // of a part
    int64_t next = -1;                // the node of the branch that goes on here, or that came here; -1: none
    int64_t face = -1, instance = -1; // of a model
    double gap = 0;                   // in space, to the node that goes on
    std::array<double, 2> at_second{}; // the same on the other surface, of two
    std::array<Interval, 2> range_second{};
    int64_t second_face = -1, second_instance = -1; // of the other model, of two
};

enum class BranchKind : int32_t {
    crossing = 1, // what two surfaces, or a surface and a plane, have in common
    edge = 2,     // an edge that two faces have in common
    contact = 3,  // one at which both have the same tangent planes, somewhere at least
    touch = 4,    // of surfaces that have the same tangent planes all along
    overlap = 5,  // a part of the boundary of a region in which two surfaces are one
};

// Curves with common knots, in space and in the parameter domain.
struct MeetBranch {
    int64_t level;
    SplinePtr space, on;
    double deviation;                 // of either, in space
    std::array<int64_t, 2> nodes;     // -1: closed
    int64_t loop;                     // the closed way that it is part of, or all of; -1: of none
    int64_t face = -1, instance = -1; // of a model
    SplinePtr on_second = nullptr;    // in the domain of the other surface, of two
    BranchKind kind = BranchKind::crossing;
    int64_t second_face = -1, second_instance = -1; // of the other model, of two
};

// Branches one after the other, each of which goes on where the one before ends.
struct MeetWay {
    int64_t level;
    int64_t first, count; // branches
    bool closed;          // the last one goes on in the first one
    double gap;           // the largest one between them
};

struct Meet {
    std::vector<MeetBranch> branches; // those of a loop follow each other
    std::vector<MeetNode> nodes;
    std::vector<MeetWay> ways; // of arranged()
    bool complete = true;      // no node is undecided
    bool limited = false;      // some of them are so since work came to its end
    bool of_two = false;       // surfaces: branches and nodes are on a second one, too
    // Of each of two surfaces: the domains of axes that are periodic, on which branches may run into neighbouring periods.
    std::array<std::array<std::optional<Interval>, 2>, 2> periodic{};

    // That of other levels.
    void append(Meet other);
    // Nodes that no branch has any more go, but for those that tell of parts; the others by their levels. Undecided ones are seen.
    void tidy_nodes();
};

// With its ways, of which the branches follow each other, those of a level by their first branches.
Meet arranged(Meet meet);

// With the loops that its ways are.
Meet with_loops(Meet meet);

} // namespace nrb::intersect
