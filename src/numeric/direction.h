// SPDX-License-Identifier: MIT
// Unit vectors of any dimension and length.
#pragma once

#include <vector>

namespace nrb::inline numeric {

// The unit vector of a direction. Precondition: the direction is finite and not zero.
std::vector<double> unit_vector(const double *direction, int dim);

} // namespace nrb::inline numeric
