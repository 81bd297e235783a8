// SPDX-License-Identifier: MIT
#include "mesh/proof/cut_triangle.h"

namespace nrb::mesh {

namespace {

// The part of a polygon where sign (x[k] - limit) <= 0.
CutPolygon half(const CutPolygon &given, size_t k, double limit, double sign) noexcept {
    CutPolygon result;
    const std::span<const CutPlace> places = given.places();
    for (size_t i = 0; i < places.size(); ++i) {
        const CutPlace &from = places[i], &to = places[i + 1 < places.size() ? i + 1 : 0];
        const double over = sign * (from.at[k] - limit), next = sign * (to.at[k] - limit);
        if (over <= 0) {
            result.add(from);
        }
        if ((over <= 0) != (next <= 0)) {
            const double t = over / (over - next);
            std::array<double, 2> x{from.at[0] * (1 - t) + to.at[0] * t, from.at[1] * (1 - t) + to.at[1] * t};
            x[k] = limit;
            result.add({x, over <= 0 ? -1 : from.side}); // leaves along the line, enters along the edge
        }
    }
    return result;
}

} // namespace

CutPolygon cut_triangle(const std::array<std::array<double, 2>, 3> &triangle,
                        const Rectangle &part) noexcept {
    CutPolygon result;
    for (size_t i = 0; i < 3; ++i) {
        result.add({triangle[i], i == 0 ? 2 : static_cast<int>(i) - 1});
    }
    for (size_t k = 0; k < 2; ++k) {
        result = half(half(result, k, part.lower[k], -1), k, part.upper[k], 1);
    }
    return result;
}

} // namespace nrb::mesh
