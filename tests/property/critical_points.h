// Lists of critical points and of nearest points, asked for their lengths first.
#pragma once

#include "support/handle.h"

#include <algorithm>
#include <vector>

namespace support {

struct Critical {
    std::vector<double> params, distances; // [n][axes], [n]
    std::vector<int32_t> kinds;
    int32_t status = 0;

    [[nodiscard]] int64_t number(int32_t kind) const { return std::count(kinds.begin(), kinds.end(), kind); }

    void resize(const nurbs *g, int64_t count) {
        int32_t axes = 0;
        require_ok(nurbs_axes(g, &axes));
        params.resize(static_cast<size_t>(count * axes));
        distances.resize(static_cast<size_t>(count));
        kinds.resize(static_cast<size_t>(count));
    }
};

inline Critical critical(const nurbs *g, const std::vector<double> &x, double tolerance = 0) {
    Critical found;
    int64_t count = 0;
    require_ok(nurbs_critical_points(g, x.data(), nullptr, tolerance, 0, 0, nullptr, nullptr, nullptr, &count,
                                     nullptr));
    found.resize(g, count);
    require_ok(nurbs_critical_points(g, x.data(), nullptr, tolerance, 0, count, found.params.data(),
                                     found.distances.data(), found.kinds.data(), &count, &found.status));
    return found;
}

inline Critical all_nearest(const nurbs *g, const std::vector<double> &x, double tolerance) {
    Critical found;
    int64_t count = 0;
    require_ok(nurbs_closest_all(g, x.data(), nullptr, tolerance, 0, 0, nullptr, nullptr, &count, nullptr));
    found.resize(g, count);
    require_ok(nurbs_closest_all(g, x.data(), nullptr, tolerance, 0, count, found.params.data(),
                                 found.distances.data(), &count, &found.status));
    found.kinds.assign(found.kinds.size(), NURBS_CRITICAL_MINIMUM);
    return found;
}

} // namespace support
