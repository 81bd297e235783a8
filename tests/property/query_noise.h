// How far the distance of a certified nearest point may be off.
#pragma once

#include "support/spline_data.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace support {

inline double norm(const std::vector<double> &x) {
    double sum = 0;
    for (const double c : x) {
        sum += c * c;
    }
    return std::sqrt(sum);
}

// The rounding that a certificate allows.
inline double noise(const SplineData &data, const std::vector<double> &x) {
    double size = 0;
    int steps = 0;
    for (int64_t i = 0; i < data.point_count(); ++i) {
        const auto *point = data.points.data() + i * data.dim;
        size = std::max(size, norm({point, point + data.dim}));
    }
    for (const int32_t p : data.degrees) {
        steps += p + 1;
    }
    return 64 * steps * std::numeric_limits<double>::epsilon() * (size + norm(x));
}

} // namespace support
