// SPDX-License-Identifier: MIT
// Hexahedra in place of volumes.
#pragma once

#include "mesh/mesh.h"

namespace nrb::mesh {

// Throws Status::axes, dimension or degree for what is no volume in space, all of whose axes have a degree.
void check_volume(const Spline &volume);

// Of `most` cells at most, unless there are more pieces. Throws Status::overflow for more than 2^31 - 1 points, and what
// refine::iso() throws. Precondition: check_volume() accepts it.
MeshPtr mesh_of_volume(const SplinePtr &volume, const MeshRule &rule, int64_t most);

} // namespace nrb::mesh
