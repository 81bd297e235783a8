// SPDX-License-Identifier: MIT
// Numbers of what faces have in common, after faces that could not be made.
#pragma once

#include "model/model.h"

namespace nrb::model {

// Numbers solids from 0 on in the order of their first faces, so that none is without a face.
void number_solids(Model &model);

// Leaves out the layers that no face and no spline is in.
void number_layers(Model &model);

} // namespace nrb::model
