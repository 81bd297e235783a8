// SPDX-License-Identifier: MIT
// The borders of parts of an arrangement, as loops of half-edges and as curves.
#pragma once

#include "face/arrange/arrangement.h"

#include <span>
#include <vector>

namespace nrb::face {

using EdgeLoop = std::vector<DirectedEdge>;

// The loops of half-edges that have a part of the domain to their left. At a node a half-edge continues with
// the one that leaves next to it on its left side. Throws Status::not_converged where a half-edge has no
// continuation, which only rounding can cause.
std::vector<EdgeLoop> ways_around(const Arrangement &arrangement, const std::vector<DirectedEdge> &edges);

// The copy of the domain in which a half-edge ends that begins in the copy `turns`.
std::array<int, 2> turned_by(const Arrangement &arrangement, std::array<int, 2> turns,
                             DirectedEdge edge) noexcept;

// A loop cut into loops wherever it comes to a node again, in the same copy of the domain.
std::vector<EdgeLoop> simple_loops(const Arrangement &arrangement, const EdgeLoop &loop);

// A part of a given curve along which consecutive edges of a loop run. Edges that are points of space belong
// to none.
struct Run {
    size_t first, last; // edges of the cuts, in the order of the loop
    bool back;          // the loop runs against the curve
};

// Where runs end apart from the ends of curves.
enum class RunRule {
    longest, // nowhere: a run may continue along any member of an edge
    shared,  // at marked nodes, and along first members only: a loop on the other side has the same runs
};
std::vector<Run> runs_of(const Arrangement &arrangement, const EdgeLoop &loop, RunRule rule,
                         const std::vector<bool> &ends = {});

// The exact part of the given curve that a run is, in the direction of the loop. Where the curve is cut, the
// end is the node bit for bit if it is so to rounding.
SplinePtr curve_of(const Arrangement &arrangement, const Run &run);
// Whether a run is all of its curve.
bool is_whole(const Arrangement &arrangement, const Run &run);

// A clamped curve with the control point at one end set to another point; the curve itself if that moves a
// coordinate by more than `within`.
SplinePtr with_end(const SplinePtr &curve, bool upper, std::span<const double> end, double within);

} // namespace nrb::face
