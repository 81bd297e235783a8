// SPDX-License-Identifier: MIT
// What files say of the faces of a mesh: their names, and which side of them is outside.
#pragma once

#include "mesh/mesh.h"
#include "model/model.h"
#include "model/sections/shared_borders.h"

namespace nrb::mesh {

// Names, colours, parts and their uses, the unit of length. Faces of a solid have their outside where the model has it. Of the
// others in a part each shell, the faces that hang together by edges, is seen as its first face is. Where the triangles of a solid,
// or those of a part that bound none, close up and enclose a negative volume, all of them are turned: they are inside out.
void label(const model::Model &model, const model::SharedBorders &borders, Mesh &mesh);

// The same of the mesh of one surface.
void label_as_one_part(Mesh &mesh);

} // namespace nrb::mesh
