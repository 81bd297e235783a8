// SPDX-License-Identifier: MIT
// Where scalar splines of several axes are constant.
#pragma once

#include "intersect/extrema/extremum.h"
#include "intersect/extrema/fields/stratum.h"

namespace nrb::intersect {

// Whether a piece of a stratum is at the end of one of a stratum of more axes on which f is constant.
bool ends_plateau(const GradientField &field, const Stratum &stratum, const PieceIndex &index);

// Boxes of one kind and value that lie side by side are one.
std::vector<Extremum> merged(std::vector<Extremum> boxes, int axes);

} // namespace nrb::intersect
