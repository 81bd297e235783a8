// SPDX-License-Identifier: MIT
// Points and weights on faces, for integrands that callers evaluate.
#pragma once

#include "face/face.h"

#include <vector>

namespace nrb::face {

struct FaceQuadrature {
    std::vector<double> params;  // [size][2], in the domain
    std::vector<double> weights; // [size] of areas of the domain, >= 0
    [[nodiscard]] int64_t size() const noexcept { return static_cast<int64_t>(weights.size()); }
};

// Gauss rules on the cells of which the face consists, with `nodes` points in each direction. A cell is
// between two lines u = const and between two curves, or lines v = const; it lies in one span of each axis.
// Beside a curve that is not straight, places are at a share 3 x^2 - 2 x^3 of the way along axis 0, where x
// are the nodes of the rule: then a curve that is vertical at an end, as a circle is, is smooth in x. Throws
// Status::orientation for loops that cross, overflow if there are too many points.
FaceQuadrature face_quadrature(const Face &face, int nodes);

// The weights times the area elements of the surface: weights for integrals over area. Throws
// Status::not_representable.
std::vector<double> measures_of(const Face &face, const FaceQuadrature &rule);

} // namespace nrb::face
