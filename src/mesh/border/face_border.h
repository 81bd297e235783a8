// SPDX-License-Identifier: MIT
// The polygons that bound a face in the domain of its surface.
#pragma once

#include "mesh/border/model_edges.h"

namespace nrb::mesh {

struct BorderPoint {
    face::Point2 param;
    int32_t point; // of ModelEdges
};

struct BorderSegment {
    int32_t from, to; // numbers in FaceBorder::points
    // A bound, in the domain, of how far places between the segment and its curve are from the segment: no
    // farther than the step `over` to one side or the other if `across`, else than |over[k]| along each axis
    // k.
    face::Point2 over{};
    bool across = true;
    // The polyline that the segment is of, -1: none, and the parameters of its ends on the edge.
    int64_t line = -1;
    std::array<double, 2> params{};
    bool backwards = false; // whether the inside is to its right instead of its left
};

struct FaceBorder {
    std::vector<BorderPoint> points;
    std::vector<BorderSegment> segments;
};

// Polygons that come to a seam end on one side of it and continue on the other side.
FaceBorder border_of(const model::Model &model, int64_t face, const ModelEdges &edges);

} // namespace nrb::mesh
