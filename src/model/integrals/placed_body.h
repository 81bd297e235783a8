// SPDX-License-Identifier: MIT
// Bodies as their moments, moved and added up.
#pragma once

#include "measure/moments.h"

#include <array>

namespace nrb::model {

// A body in units of 2^exponent: its volume and the error of that, its centroid, its vector area (the
// integral of the outer normal), and its second moments, the integral of (x - centroid) (x - centroid)^T.
struct Body {
    int exponent = 0;
    double volume = 0, error = 0;
    std::array<double, 3> centroid{}, vector_area{};
    std::array<std::array<double, 3>, 3> second{};
};

// The body under the affine map x -> M x + t, given as the rows of (M | t). A mirror does not change the
// signs of volume and second moments.
Body placed(const Body &body, const std::array<double, 12> &placement);

// The moments of all bodies together. The openness is the sum of the lengths of their vector areas, so that
// these do not cancel each other. Throws Status::length if the volume is 0 and more than the content is
// wanted, and not_representable.
measure::Moments moments_of(const std::vector<Body> &bodies, measure::MomentOrder order);

} // namespace nrb::model
