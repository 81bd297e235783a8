// SPDX-License-Identifier: MIT
// Sections of a model with planes.
#pragma once

#include "intersect/levels/level_meet.h"
#include "model/model.h"

#include <span>

namespace nrb::model {

// The plane x . normal = offset.
struct SectionPlane {
    Vector3 normal;
    double offset;
};

// Cuts all instances of faces with all planes, whose numbers are the levels. tolerance > 0, in the whole.
// Branches are joined to ways; seen from the tip of the plane's normal, the outer normals of the faces are on
// their right. Throws what instances_of() and Placement() throw. Precondition: finite normals that are not 0.
intersect::Meet model_sections(const Model &model, std::span<const SectionPlane> planes, double tolerance);

} // namespace nrb::model
