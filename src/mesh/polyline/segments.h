// SPDX-License-Identifier: MIT
// Places the vertices of a polyline between two points of a curve.
#pragma once

#include "mesh/polyline/curve_parts.h"

namespace nrb::mesh {

// Consecutive vertices, and the segments between them.
struct Run {
    std::vector<Vertex> vertices;
    std::vector<Segment> segments;
};

// Appends vertices, the first of which is the last one of the run.
void append(Run &run, Run more);

// Each vertex is about as far from the one before as the rule allows. Usually a segment is computed once or
// twice.
Run greedy(CurveParts &parts, const Vertex &from, const Vertex &to);

// If the last segment is short, places the last few vertices anew so that all their segments need about the
// same, where these keep to the rule.
Run spread_evenly(CurveParts &parts, Run run);

// With vertices at equal steps of the parameter, among others, as far as doubles can represent them.
Run divided(CurveParts &parts, const Vertex &from, const Vertex &to, int count);

} // namespace nrb::mesh
