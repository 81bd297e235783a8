// SPDX-License-Identifier: MIT
// The signs of the eigenvalues of a symmetric matrix that is known to within intervals.
#pragma once

#include "intersect/extrema/extremum.h"

#include <cstddef>

namespace nrb::intersect {

// Row by row, [size][size]; entries below the diagonal are not read. Minimum: positive definite, maximum: negative
// definite, saddle: proven to be neither, and regular if `regular` is; else undecided. size: 1 to 3.
uint32_t signature(const Interval *matrix, size_t size, bool regular);

} // namespace nrb::intersect
