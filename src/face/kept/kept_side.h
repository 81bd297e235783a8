// SPDX-License-Identifier: MIT
// Faces trimmed by surfaces: the parts of a face on one side of a surface.
#pragma once

#include "face/face.h"

#include <vector>

namespace nrb::face {

enum class SurfaceSide : int32_t {
    front = 1, // to which the normals S_u x S_v of the surface point
    back = -1,
};

// The parts of a face on one side of a surface. A part beside intersection curves is on the side that follows
// from the direction of these: the front is to their left. Any other part is on the side of a point in it, as
// seen from the nearest point of the surface, which must not be on its boundary. Throws Status::incompatible
// where the surface ends inside the face, or too early to decide the side of a part; not_converged for
// what is undecided inside the face; and what split() throws.
std::vector<FacePtr> kept_side(const Face &face, const SplinePtr &surface, SurfaceSide side,
                               double tolerance);

} // namespace nrb::face
