// SPDX-License-Identifier: MIT
// The content spanned by derivative vectors.
#pragma once

#include <vector>

namespace nrb::measure {

// The length, area or volume spanned by vectors [axes][dim], which is the square root of Gram's determinant:
// the product of the distances of each vector from the space of those before it (Gram-Schmidt). Overwrites
// the vectors.
double spanned(std::vector<double> &vectors, int axes, int dim) noexcept;

} // namespace nrb::measure
