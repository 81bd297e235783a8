// SPDX-License-Identifier: MIT
#include "mesh/proof/cut_triangle.h"

namespace nrb::mesh {

namespace {

// What lies where sign (x[k] - limit) <= 0.
CutPolygon half(const CutPolygon &given, size_t k, double limit, double sign) {
    CutPolygon result;
    const size_t n = given.places.size();
    const auto over = [&](size_t i) { return sign * (given.places[i % n][k] - limit); };
    for (size_t i = 0; i < n; ++i) {
        const bool from_in = over(i) <= 0, to_in = over(i + 1) <= 0;
        if (from_in) {
            result.places.push_back(given.places[i]);
            result.sides.push_back(given.sides[i]);
        }
        if (from_in != to_in) {
            const auto &a = given.places[i], &b = given.places[(i + 1) % n];
            const double t = over(i) / (over(i) - over(i + 1));
            std::array<double, 2> x{a[0] * (1 - t) + b[0] * t, a[1] * (1 - t) + b[1] * t};
            x[k] = limit;
            result.places.push_back(x);
            result.sides.push_back(from_in ? -1 : given.sides[i]); // out of it, along the line; or in again
        }
    }
    return result;
}

} // namespace

CutPolygon cut_triangle(const std::array<std::array<double, 2>, 3> &triangle, const Rectangle &part) {
    CutPolygon result{{triangle.begin(), triangle.end()}, {2, 0, 1}};
    for (size_t k = 0; k < 2 && !result.places.empty(); ++k) {
        result = half(result, k, part.lower[k], -1);
        if (!result.places.empty()) {
            result = half(result, k, part.upper[k], 1);
        }
    }
    return result;
}

} // namespace nrb::mesh
