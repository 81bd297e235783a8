// SPDX-License-Identifier: MIT
// The parts of a domain, each in one piece, that edges of an arrangement bound.
#pragma once

#include "face/arrange/ways.h"

namespace nrb::face {

// The loops of a part: one around it, and those around holes.
using PartLoops = std::vector<EdgeLoop>;

// Parts to the left of edges, which are all that bound them: a loop around a hole belongs to the part that lies above its
// highest place. Loops that enclose nothing to rounding are left out. Throws Status::not_converged where edges do not go on, or
// rounding hides what is above.
std::vector<PartLoops> parts_within(const Arrangement &arrangement, const std::vector<DirectedEdge> &border);

} // namespace nrb::face
