// SPDX-License-Identifier: MIT
// Where the vertices between two places of a curve lie.
#pragma once

#include "mesh/polyline/curve_parts.h"

namespace nrb::mesh {

// Vertices, and the segments between them.
struct Run {
    std::vector<Vertex> vertices;
    std::vector<Segment> segments;
};

// More vertices, the first of which is the last of the run.
void append(Run &run, Run more);

// Each vertex about as far from the one before as the rule allows. Usually a segment is looked at once or twice.
Run greedy(CurveParts &parts, const Vertex &from, const Vertex &to);

// If the last segment is short: the last few so that they all need about the same, where that keeps to the rule.
Run spread_evenly(CurveParts &parts, Run run);

// With vertices at equal steps of the parameter among others, as far as doubles have them.
Run divided(CurveParts &parts, const Vertex &from, const Vertex &to, int count);

} // namespace nrb::mesh
