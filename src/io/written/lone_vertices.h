// SPDX-License-Identifier: MIT
// Vertices of faces that belong to no edge.
#pragma once

#include "model/model.h"

#include <vector>

namespace nrb::io {

// The points at which a face needs a vertex besides those of its edges. If it is written on its shape
// (`on_shape`) and that is unbounded, these are the poles inside the face. A face without any edges has one
// on any surface: a pole inside the face or, if there is none, a corner of the domain.
std::vector<Vector3> lone_vertices(const model::ModelFace &face, bool on_shape);

} // namespace nrb::io
