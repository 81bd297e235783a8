// SPDX-License-Identifier: MIT
// Where planes cut a model.
#pragma once

#include "intersect/levels/level_meet.h"
#include "model/model.h"

#include <span>

namespace nrb::model {

// A plane x . normal = offset.
struct SectionPlane {
    Vector3 normal;
    double offset;
};

// All instances of faces by all planes, which are numbered as levels, each tolerance > 0. Branches are joined to ways, with the
// outer normal of the faces to the right of them as seen from the tip of the normal. Throws what instances_of() and Placement() do.
// Precondition: finite normals that are not 0.
intersect::Meet model_sections(const Model &model, std::span<const SectionPlane> planes, double tolerance);

} // namespace nrb::model
