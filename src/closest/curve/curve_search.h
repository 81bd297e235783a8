// The search of a tree of curve pieces for the point that is nearest to a given one.
#pragma once

#include "closest/curve/curve_best.h"

namespace nrb::closest {

struct CurveSearchResult {
    CurvePlace place;
    bool certified = false;
    bool unique = true; // no place elsewhere was seen that is as near
    int64_t looked = 0;
};

// What double precision leaves open in a distance from a point: half of it in the positions of the leaves,
// half for what is computed from them.
double distance_noise(const CurveTree &tree, const double *point) noexcept;

CurveSearchResult search(const CurveTree &tree, const Query &query);

// The place of a local minimum that a descent comes to from s on a leaf.
CurvePlace descend(const CurveTree &tree, const double *point, int64_t leaf, double s);

} // namespace nrb::closest
