// SPDX-License-Identifier: MIT
// Checks of rays.
#pragma once

#include "checks.h"

#include "intersect/rays/ray.h"

namespace nrb::capi {

constexpr int64_t work_of_a_ray = 200;

// Throws NURBS_ERROR_DIRECTION for one that is not finite or 0.
void check_directions(const char *name, const ConstRecords &rows);

// One ray, over all t >= 0 where the range is NULL.
intersect::RayQuery checked_ray(const double *origin, const double *direction, const double *range);

inline Vector3 row(const ConstRecords &rows, int64_t i) {
    return {rows(i, 0), rows(i, 1), rows(i, 2)};
}

} // namespace nrb::capi
