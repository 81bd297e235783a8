// SPDX-License-Identifier: MIT
// Checks that the faces of a model enclose solids.
#pragma once

#include "model/model.h"

namespace nrb::model {

// Throws Status::gap if the faces of a solid, or those faces of a part that bound none, do not close.
void check_closed(const Model &model);

} // namespace nrb::model
