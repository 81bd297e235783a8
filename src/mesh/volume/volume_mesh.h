// SPDX-License-Identifier: MIT
// Approximates volumes by hexahedra.
#pragma once

#include "mesh/mesh.h"

namespace nrb::mesh {

// Throws Status::axes, dimension or degree unless this is a volume in space whose axes all have a degree of
// at least 1.
void check_volume(const Spline &volume);

// Makes at most `most` cells, unless there are more pieces. Throws Status::overflow for more than 2^31 - 1
// points, and what refine::iso() throws. Precondition: check_volume() accepts the volume.
MeshPtr mesh_of_volume(const SplinePtr &volume, const MeshRule &rule, int64_t most);

} // namespace nrb::mesh
