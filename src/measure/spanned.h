// SPDX-License-Identifier: MIT
// What derivatives span.
#pragma once

#include <vector>

namespace nrb::measure {

// The length, area or volume that vectors [axes][dim] span, the root of Gram's determinant: the product of how far each is from
// those before it. Overwrites them.
double spanned(std::vector<double> &vectors, int axes, int dim) noexcept;

} // namespace nrb::measure
