// SPDX-License-Identifier: MIT
// A branch-and-bound search of a curve tree for the point nearest to, or farthest from, a given one.
#pragma once

#include "closest/curve/curve_best.h"

namespace nrb::closest {

struct CurveSearchResult {
    CurvePlace place;
    bool certified = false;
    bool unique = true; // false: a different place that is as good was seen
    int64_t examined = 0;
};

// The uncertainty of a distance computed in double precision: half of the bound is for the positions of the
// leaves, half for what is computed from them.
double distance_noise(const CurveTree &tree, const double *point) noexcept;

CurveSearchResult search(const CurveTree &tree, const Query &query);

// The local minimum that a descent from place s of a leaf reaches within this leaf.
CurvePlace descend(const CurveTree &tree, const double *point, int64_t leaf, double s);

} // namespace nrb::closest
