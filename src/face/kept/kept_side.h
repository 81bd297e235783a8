// SPDX-License-Identifier: MIT
// Faces trimmed by surfaces.
#pragma once

#include "face/face.h"

#include <vector>

namespace nrb::face {

enum class SurfaceSide : int32_t {
    front = 1, // to which the normals S_u x S_v of the surface point
    back = -1,
};

// The parts of a face on one side of a surface. Parts beside curves in which both meet are on the side that the directions of these
// tell; others on that on which a place in them lies as seen from the nearest point of the surface, which no end of it may be. Throws
// Status::incompatible where the surface ends inside of the face, or before it tells a side; not_converged for what is undecided
// inside of the face, and what split() throws.
std::vector<FacePtr> kept_side(const Face &face, const SplinePtr &surface, SurfaceSide side,
                               double tolerance);

} // namespace nrb::face
