// SPDX-License-Identifier: MIT
#include "ray_arguments.h"

#include "base/error.h"
#include "base/numbers.h"

#include <array>
#include <cmath>
#include <cstdio>

namespace nrb::capi {

namespace {

// `index` < 0: there is one only.
void check_direction(const char *name, const double *x, int64_t index) {
    char row[32] = "";
    if (index >= 0) {
        std::snprintf(row, sizeof row, "[%lld]", static_cast<long long>(index));
    }
    for (int c = 0; c < 3; ++c) {
        if (!std::isfinite(x[c])) {
            fail(Status::direction, "%s%s[%d] = %s, expected a number", name, row, c, Number(x[c]).text);
        }
    }
    if (x[0] == 0 && x[1] == 0 && x[2] == 0) {
        fail(Status::direction, "%s%s is 0, expected a direction", name, row);
    }
}

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
    check_direction("direction", direction, -1);
    return {{origin[0], origin[1], origin[2]}, {direction[0], direction[1], direction[2]}, limits};
}

} // namespace nrb::capi
