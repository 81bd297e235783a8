// SPDX-License-Identifier: MIT
// Division of curves into equal parts.
#pragma once

#include "measure/length/curve_length.h"

namespace nrb::measure {

// params: [parts + 1], the ends of the range among them. Returns the length of a part. Throws
// Status::length if the range has none, not_converged, not_representable.
double divide_by_length(const Spline &curve, Interval range, int64_t parts, double relative_tolerance,
                        std::vector<double> &params);

// So that consecutive points have equal distances, each the first one at its distance from the one before
// where there is such a division (chord_path.h). Returns the distance. Throws as divide_by_length();
// not_converged also where none is found.
double divide_by_chord(const Spline &curve, Interval range, int64_t parts, double relative_tolerance,
                       std::vector<double> &params);

} // namespace nrb::measure
