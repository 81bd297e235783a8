// SPDX-License-Identifier: MIT
// Points and weights on faces, for integrands of others.
#pragma once

#include "face/face.h"

#include <vector>

namespace nrb::face {

struct FaceQuadrature {
    std::vector<double> params;  // [size][2], in the domain
    std::vector<double> weights; // [size] of the parameters, >= 0
    [[nodiscard]] int64_t size() const noexcept { return static_cast<int64_t>(weights.size()); }
};

// Rules of Gauss on the cells of which the face consists, each between two lines across axis 0 and between two curves, or lines,
// that stay in one span of each axis: `nodes` across and `nodes` along. Beside curves that are no lines places along axis 0 are
// u = 3 x^2 - 2 x^3 of the way, so that a bound which stands upright at an end, like that of a circle, is smooth in x. Throws
// Status::orientation for loops that cross, overflow if there are too many points.
FaceQuadrature face_quadrature(const Face &face, int nodes);

// The weights of areas. Throws Status::not_representable.
std::vector<double> measures_of(const Face &face, const FaceQuadrature &rule);

} // namespace nrb::face
