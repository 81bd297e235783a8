// SPDX-License-Identifier: MIT
#include "ray_arguments.h"

#include "base/error.h"
#include "base/numbers.h"

#include <array>

namespace nrb::capi {

namespace {

Interval checked_range(const double *range) {
    if (range == nullptr) {
        return {0, infinity};
    }
    if (!(range[0] <= range[1])) {
        fail(Status::empty_domain, "range = {%s, %s}, expected two numbers that do not fall",
             Number(range[0]).text, Number(range[1]).text);
    }
    return {range[0], range[1]};
}

} // namespace

void check_directions(const char *name, const ConstRecords &rows) {
    for (int64_t i = 0; i < rows.count; ++i) {
        const std::array<double, 3> x{rows(i, 0), rows(i, 1), rows(i, 2)};
        check_direction(name, x.data(), i);
    }
}

intersect::RayQuery checked_ray(const double *origin, const double *direction, const double *range) {
    require(origin, "origin");
    require(direction, "direction");
    const Interval limits = checked_range(range);
    check_points("origin", {origin, 1, 3, 3, 1});
    check_direction("direction", direction);
    return {{origin[0], origin[1], origin[2]}, {direction[0], direction[1], direction[2]}, limits};
}

} // namespace nrb::capi
