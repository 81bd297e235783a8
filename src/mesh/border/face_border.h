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
    // The polyline that it is of, and where it is best divided; -1: none.
    int64_t line = -1;
    double middle = 0;
};

struct FaceBorder {
    std::vector<BorderPoint> points;
    std::vector<BorderSegment> segments;
};

// Loops that pass a seam end on its one side and go on on the other one.
FaceBorder border_of(const model::Model &model, int64_t face, const ModelEdges &edges);

} // namespace nrb::mesh
