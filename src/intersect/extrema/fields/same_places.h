// SPDX-License-Identifier: MIT
// Critical places that lie where pieces are joined.
#pragma once

#include "intersect/extrema/fields/critical_search.h"

namespace nrb::intersect {

// Keeps one of those that were found more than once. What cannot be told to be one or two is left open.
void without_copies(const GradientField &field, const Stratum &stratum, CriticalPlaces &places);

} // namespace nrb::intersect
