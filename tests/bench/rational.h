// Homogeneous control points, as the polynomial libraries need them.
#pragma once

#include "support/spline_data.h"

namespace bench {

// [points][dim + 1]: the weighted coordinates, then the weight.
inline std::vector<double> homogeneous(const support::SplineData &data) {
    std::vector<double> result;
    for (int64_t i = 0; i < data.point_count(); ++i) {
        for (int c = 0; c < data.dim; ++c) {
            result.push_back(data.weight(i) * data.coordinate(i, c));
        }
        result.push_back(data.weight(i));
    }
    return result;
}

} // namespace bench
