// SPDX-License-Identifier: MIT
// Singular places of a curve or surface: where C' or S_u x S_v vanishes.
#pragma once

#include "pieces/spline_pieces.h"

namespace nrb::analysis {

struct SingularPlace {
    std::array<double, 2> at{};
    Part box{}; // of the parameters
};

struct SingularPlaces {
    std::vector<SingularPlace> places;
    bool complete = true; // the spline is proven regular outside the boxes
};

// Subdivides the pieces. A part is regular if some linear combination of the components of C' or S_u x S_v
// (in dimensions above 3: of |S_u|^2 |S_v|^2 - (S_u . S_v)^2) has a certain sign on it. Any other part is
// halved, down to the tolerance or until pieces::default_budget halvings or the memory for them are used up.
// The parts that remain are boxes; boxes that touch form one place. Boundaries of pieces on which the vector
// vanishes to rounding are places of their own, and are divided out. Throws Status::not_representable.
SingularPlaces singular_places(const Spline &spline, double tolerance);

} // namespace nrb::analysis
