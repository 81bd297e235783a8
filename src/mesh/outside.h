// SPDX-License-Identifier: MIT
// Labels the faces of a mesh with what the model says about them: names, colours, and which side is outside.
#pragma once

#include "mesh/mesh.h"
#include "model/model.h"

namespace nrb::mesh {

// Copies names, colours, parts with their uses and the unit of length, and sets on which side the faces have
// their outside.
// - Faces of a solid are oriented as in the model.
// - Faces of no solid are oriented shell by shell (a shell: faces connected by shared edges), as the first
//   face of each.
// - If then the triangles of a solid, or those of all faces of a part that bound no solid, are closed and
//   enclose a negative volume, they are inside out, and all of these faces are turned.
void label(const model::Model &model, Mesh &mesh);

// The same for the mesh of a single surface, which becomes the only part.
void label_as_one_part(Mesh &mesh);

} // namespace nrb::mesh
