// SPDX-License-Identifier: MIT
// Where rays meet a surface.
#pragma once

#include "base/records.h"
#include "basis/knot_vector.h"
#include "spline/spline.h"

#include <array>
#include <memory>
#include <vector>

namespace nrb::intersect {

enum RayStatus : int32_t {
    ray_hit = 1,       // proven to be one, for a surface and a ray that rounding has moved
    ray_certified = 2, // nothing is nearer; without a hit: there is none
    ray_touch = 4,     // as far as rounding can tell
    ray_back = 8,      // from the side that the normal does not point to
};

// x = origin + t direction; rows of [3].
struct RayBatch {
    ConstRecords origins, directions;
    Interval range; // of t
};

struct RayAnswer {
    std::array<double, 2> params{};
    double t = 0;
    int32_t status = 0;
};

// Calls with each ray in turn. Precondition: a surface in space; finite origins, directions with a length.
class RayCaster {
public:
    RayCaster(const Spline &surface, const RayBatch &rays);
    ~RayCaster();
    RayCaster(const RayCaster &) = delete;
    RayCaster &operator=(const RayCaster &) = delete;

    // The meet with the smallest t. None: NaN.
    RayAnswer nearest(int64_t ray);
    // All of them, rising. Returns whether they are proven to be.
    bool all(int64_t ray, std::vector<RayAnswer> &out);

private:
    class Cast;
    std::unique_ptr<Cast> cast_;
};

} // namespace nrb::intersect
