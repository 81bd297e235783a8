// SPDX-License-Identifier: MIT
// Directions of vectors of any dimension and length.
#pragma once

#include <vector>

namespace nrb::inline numeric {

// Of length 1. Precondition: finite and not zero.
std::vector<double> unit_vector(const double *direction, int dim);

} // namespace nrb::inline numeric
