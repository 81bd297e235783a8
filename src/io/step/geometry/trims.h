// SPDX-License-Identifier: MIT
// Where a trimmed curve begins and ends.
#pragma once

#include "io/step/entities.h"

#include "io/step/geometry/placements.h"

#include <optional>

namespace nrb::io::step {

// A parameter, a point, or both, of which one counts.
struct Trim {
    std::optional<double> parameter; // in the unit of the file
    std::optional<Point> point;
};

// A set of one or two trimming selects. Throws Status::syntax.
Trim read_trim(Entities &entities, Attributes &attributes, const char *name, double length);

} // namespace nrb::io::step
