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
    int32_t from, to;    // of the points
    face::Point2 over{}; // how far, along each axis, places between it and its curve are from the nearest of it
};

struct FaceBorder {
    std::vector<BorderPoint> points;
    std::vector<BorderSegment> segments;
};

// Loops that pass a seam end on its one side and go on on the other one.
FaceBorder border_of(const model::Model &model, int64_t face, const ModelEdges &edges);

} // namespace nrb::mesh
