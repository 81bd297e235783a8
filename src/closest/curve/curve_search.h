// SPDX-License-Identifier: MIT
// Searches a tree of curve pieces for the point nearest to a given one.
#pragma once

#include "closest/curve/curve_best.h"

namespace nrb::closest {

struct CurveSearchResult {
    CurvePlace place;
    bool certified = false;
    bool unique = true; // no place elsewhere was seen that is as near
    int64_t examined = 0;
};

// The uncertainty of a distance from a point in double precision: half of it is in the positions of the
// leaves, half is for what is computed from them.
double distance_noise(const CurveTree &tree, const double *point) noexcept;

CurveSearchResult search(const CurveTree &tree, const Query &query);

// The place of the local minimum that a descent from s on a leaf reaches.
CurvePlace descend(const CurveTree &tree, const double *point, int64_t leaf, double s);

} // namespace nrb::closest
