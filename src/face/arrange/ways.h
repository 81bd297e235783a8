// SPDX-License-Identifier: MIT
// The borders of parts of an arrangement, as loops.
#pragma once

#include "face/arrange/arrangement.h"

#include <span>
#include <vector>

namespace nrb::face {

using EdgeLoop = std::vector<DirectedEdge>;

// The loops that edges make which have a part of the domain to their left: at a node each goes on with the edge next to it on
// that side. Throws Status::not_converged where edges do not go on, which rounding alone can be the reason of.
std::vector<EdgeLoop> ways_around(const Arrangement &arrangement, const std::vector<DirectedEdge> &edges);

// The copy of the domain in which an edge ends that begins in another one.
std::array<int, 2> turned_by(const Arrangement &arrangement, std::array<int, 2> turns,
                             DirectedEdge edge) noexcept;

// A loop cut where it comes to a node again, in the same copy of the domain.
std::vector<EdgeLoop> simple_loops(const Arrangement &arrangement, const EdgeLoop &loop);

// A part of a curve that edges one after the other run over, without those that are points of space.
struct Run {
    size_t first, last; // of the cuts, as the loop runs
    bool back;
};

// Where runs end besides where curves do.
enum class RunRule {
    longest, // nowhere: of edges that run along each other any one may go on
    shared,  // at marked nodes, so that a loop on the other side has the same runs
};
std::vector<Run> runs_of(const Arrangement &arrangement, const EdgeLoop &loop, RunRule rule,
                         const std::vector<bool> &ends = {});

// The exact part of the curve that was given. Its ends are nodes bit for bit, if they are so to rounding.
SplinePtr curve_of(const Arrangement &arrangement, const Run &run);
// Whether that is all of it.
bool is_whole(const Arrangement &arrangement, const Run &run);

// A clamped curve with another end, if that is no farther away than that.
SplinePtr with_end(const SplinePtr &curve, bool upper, std::span<const double> end, double within);

} // namespace nrb::face
