// Polygons in a plane, for tests.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

namespace polygons {

using Corner = std::array<double, 2>;

// The part of a convex polygon in another one, both anticlockwise (Sutherland & Hodgman 1974).
inline std::vector<Corner> common_part(std::vector<Corner> part, const std::vector<Corner> &of) {
    for (size_t i = 0; i < of.size(); ++i) {
        const Corner &p = of[i], &q = of[(i + 1) % of.size()];
        const auto side = [&](const Corner &x) {
            return (q[0] - p[0]) * (x[1] - p[1]) - (q[1] - p[1]) * (x[0] - p[0]);
        };
        std::vector<Corner> left;
        for (size_t k = 0; k < part.size(); ++k) {
            const Corner &x = part[k], &y = part[(k + 1) % part.size()];
            const double at_x = side(x), at_y = side(y);
            if (at_x >= 0) {
                left.push_back(x);
            }
            if ((at_x > 0 && at_y < 0) || (at_x < 0 && at_y > 0)) {
                const double t = at_x / (at_x - at_y);
                left.push_back({x[0] + t * (y[0] - x[0]), x[1] + t * (y[1] - x[1])});
            }
        }
        part = left;
    }
    return part;
}
inline double area_of(const std::vector<Corner> &polygon) {
    double area = 0;
    for (size_t i = 0; i < polygon.size(); ++i) {
        const Corner &p = polygon[i], &q = polygon[(i + 1) % polygon.size()];
        area += (p[0] * q[1] - q[0] * p[1]) / 2;
    }
    return area;
}

} // namespace polygons
