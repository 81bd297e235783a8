// SPDX-License-Identifier: MIT
// Hexahedra in place of volumes.
#pragma once

#include "mesh/mesh.h"

namespace nrb::mesh {

// Of about `most` cells at most, unless there are more pieces. Throws Status::axes, dimension or degree for what is no volume in
// space, overflow for more than 2^31 - 1 points.
MeshPtr mesh_of_volume(const SplinePtr &volume, const MeshRule &rule, int64_t most);

} // namespace nrb::mesh
