// SPDX-License-Identifier: MIT
// Area of the faces of models, and what their solids hold.
#pragma once

#include "measure/moments.h"
#include "model/model.h"

namespace nrb::model {

// Of all faces where they stand in the whole. Throws what instances_of() and face::integrate() do, and Status::not_converged,
// not_representable.
measure::Moments area(const Model &model, double relative_tolerance);

// Of all solids where they stand in the whole, by the divergence theorem over their faces. Faces of a part that bound no solid
// enclose one together; of these each shell, the faces that hang together by edges, is seen as its first face is. What is inside
// of all of them comes out negative is taken to be turned inside out. Throws what check_closed(), instances_of() and
// face::integrate() do, and what measure::moments() does.
measure::Moments volume(const Model &model, measure::MomentOrder order, double relative_tolerance);

} // namespace nrb::model
