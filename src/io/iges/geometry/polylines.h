// SPDX-License-Identifier: MIT
// Lines (entity 110) and polygons (106).
#pragma once

#include "io/iges/geometry/placement.h"
#include "io/iges/record.h"
#include "model/shapes/curve_shape.h"

namespace nrb::io::iges {

std::array<double, 3> read_point(Record &record, const char *name);

// The points P1 and P2 of a line, placed.
struct LineEnds {
    std::array<double, 3> first;
    std::array<double, 3> second;
};
LineEnds read_line_ends(Record &record, const Placement &place);

// P1 + t (P2 - P1): form 0 for t in [0, 1], form 1 for t >= 0, form 2 for all t. Throws Status::syntax,
// unsupported.
model::CurvePiece read_line(Record &record, const Placement &place, int64_t form);

// Copious data that are polygons (forms 11, 12, 13, and 63, which is closed), with the vertices at the
// parameters 0, 1, 2, ... The vectors at the vertices (form 13) are not part of the shape. Throws
// Status::unsupported for points without lines between them, and for drawings; count, too_few_points, syntax.
model::CurvePiece read_polygon(Record &record, const Placement &place, int64_t form);

} // namespace nrb::io::iges
