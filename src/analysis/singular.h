// SPDX-License-Identifier: MIT
// Places where a curve or surface is singular.
#pragma once

#include "pieces/spline_pieces.h"

namespace nrb::analysis {

struct SingularPlace {
    std::array<double, 2> at{};
    Part box{}; // of the parameters
};

struct SingularPlaces {
    std::vector<SingularPlace> places;
    bool complete = true; // regular outside the boxes
};

// Examines parts of the pieces. If no combination of the components of C' or S_u x S_v (in dimensions above
// 3: |S_u|^2 |S_v|^2 - (S_u . S_v)^2) has a certain sign on a part, the part is halved, to the tolerance or
// until pieces::default_budget halvings are used up. The remaining parts are boxes; boxes that touch make one
// place. Boundaries of pieces that vanish to rounding are places of their own and are divided out. Throws
// Status::not_representable.
SingularPlaces singular_places(const Spline &spline, double tolerance);

} // namespace nrb::analysis
