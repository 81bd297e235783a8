// SPDX-License-Identifier: MIT
// The content of bodies, moved and added up.
#pragma once

#include "measure/moments.h"

#include <array>

namespace nrb::model {

// In units of 2^exponent: volume, centroid, and the integral of (x - centroid) (x - centroid)^T.
struct Body {
    int exponent = 0;
    double volume = 0, error = 0;
    std::array<double, 3> centroid{}, vector_area{};
    std::array<std::array<double, 3>, 3> second{};
};

// Moved by an affine map: x is placed at M x + t, rows of (M | t). Mirrors do not change signs.
Body placed(const Body &body, const std::array<double, 12> &placement);

// The moments of all of them together: their vector areas do not cancel each other. Throws Status::length if the sum is 0 and more
// than the content is wanted, not_representable.
measure::Moments moments_of(const std::vector<Body> &bodies, measure::MomentOrder order);

} // namespace nrb::model
