// SPDX-License-Identifier: MIT
// How well faces meet at their edges.
#pragma once

#include "model/model.h"

#include <vector>

namespace nrb::model {

// The largest distance of an edge from the curves of the faces that use it, each as face::deviation_of()
// finds it; a bound only if all of them are proven. An edge without uses has the distance 0. Throws what
// deviation_of() throws.
face::Deviation edge_gap(const Model &model, const Edge &edge);

// The same for each of the first `count` edges.
std::vector<face::Deviation> edge_gaps(const Model &model, int64_t count);

} // namespace nrb::model
