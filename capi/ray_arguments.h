// SPDX-License-Identifier: MIT
// Checks the arguments of ray casting.
#pragma once

#include "checks.h"

#include "intersect/rays/ray.h"

namespace nrb::capi {

// Multiply-adds counted for each ray or classified point, in addition to those that its search counts.
constexpr int64_t work_of_a_ray = 200;

// Throws NURBS_ERROR_DIRECTION if a direction is not finite or is 0.
void check_directions(const char *name, const ConstRecords &rows);

// A ray, limited to t in [range[0], range[1]], or to t >= 0 if range is NULL.
intersect::RayQuery checked_ray(const double *origin, const double *direction, const double *range);

inline Vector3 row(const ConstRecords &rows, int64_t i) {
    return {rows(i, 0), rows(i, 1), rows(i, 2)};
}

} // namespace nrb::capi
