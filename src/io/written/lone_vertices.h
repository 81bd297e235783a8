// SPDX-License-Identifier: MIT
// Vertices that no edge has.
#pragma once

#include "model/model.h"

#include <vector>

namespace nrb::io {

// Places where a face needs a vertex besides its edges: a pole inside of a face on a surface without ends, as which it is written if
// `on_shape`; on any, if the face has no edges at all.
std::vector<Vector3> lone_vertices(const model::ModelFace &face, bool on_shape);

} // namespace nrb::io
