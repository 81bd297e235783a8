// SPDX-License-Identifier: MIT
// The polygons that bound a face in the domain of its surface.
#pragma once

#include "mesh/border/model_edges.h"

namespace nrb::mesh {

struct BorderPoint {
    face::Point2 param;
    int32_t point;
};

struct BorderSegment {
    int32_t from, to; // of the points
    // No place between it and its curve is farther from it than by such a step, to one side or the other; if not `across`, along each axis.
    face::Point2 over{};
    bool across = true;
    // The polyline that it is of, -1: none, and the parameters of its ends on the edge.
    int64_t line = -1;
    std::array<double, 2> params{};
    bool backwards = false; // the inside is to its right, else to its left
};

struct FaceBorder {
    std::vector<BorderPoint> points;
    std::vector<BorderSegment> segments;
};

// Loops that pass a seam end on its one side and go on on the other one.
FaceBorder border_of(const model::Model &model, int64_t face, const ModelEdges &edges);

} // namespace nrb::mesh
