// SPDX-License-Identifier: MIT
// How well faces meet at their edges.
#pragma once

#include "model/model.h"

#include <vector>

namespace nrb::model {

// Of an edge: the largest distance of it from the curves of faces that use it, at most if `proven`, as face::deviation_of() has it.
// One that is not used has none. Throws what that throws.
face::Deviation edge_gap(const Model &model, const Edge &edge);

// Of the first `count` edges.
std::vector<face::Deviation> edge_gaps(const Model &model, int64_t count);

} // namespace nrb::model
