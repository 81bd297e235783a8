// SPDX-License-Identifier: MIT
// The borders of parts of an arrangement, as loops.
#pragma once

#include "face/arrange/arrangement.h"

#include <vector>

namespace nrb::face {

using EdgeLoop = std::vector<DirectedEdge>;

// The loops that edges make which have a part of the domain to their left: at a node each goes on with the edge next to it on
// that side. Throws Status::not_converged where edges do not go on, which rounding alone can be the reason of.
std::vector<EdgeLoop> ways_around(const Arrangement &arrangement, const std::vector<DirectedEdge> &edges);

// A loop cut where it comes to a node again.
std::vector<EdgeLoop> simple_loops(const Arrangement &arrangement, const EdgeLoop &loop);

// The curves of a loop: exact parts of those that were given, as long as they follow one another on one of these. Ends of parts
// are nodes bit for bit, if they are so to rounding.
Loop loop_of(const Arrangement &arrangement, const EdgeLoop &loop);

} // namespace nrb::face
