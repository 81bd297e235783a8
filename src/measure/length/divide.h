// SPDX-License-Identifier: MIT
// Division of curves into parts of equal length or equal chords.
#pragma once

#include "measure/length/curve_length.h"

namespace nrb::measure {

// params: [parts + 1], with the ends of the range. Returns the length of a part. Throws Status::length if the
// curve has no length in the range, not_converged, not_representable.
double divide_by_length(const Spline &curve, Interval range, int64_t parts, double relative_tolerance,
                        std::vector<double> &params);

// Divides so that consecutive points have equal distances. If possible, each point is the first one at this
// distance from the one before; otherwise the division follows chord_path.h. Returns the distance. Throws as
// divide_by_length(), and not_converged also if no division is found.
double divide_by_chord(const Spline &curve, Interval range, int64_t parts, double relative_tolerance,
                       std::vector<double> &params);

} // namespace nrb::measure
