// SPDX-License-Identifier: MIT
// Whether faces close solids.
#pragma once

#include "model/model.h"

namespace nrb::model {

// Throws Status::gap if the faces of a solid, or those of a part that bound none, leave something open.
void check_closed(const Model &model);

} // namespace nrb::model
