// SPDX-License-Identifier: MIT
#include "face/arrange/plane_map.h"

#include "base/finite.h"
#include "base/numbers.h"
#include "refine/forms/transform.h"

#include <cmath>

namespace nrb::face {

SplinePtr PlaneMap::image(const Spline &curve) const {
    return refine::transform(curve, {std::ssize(move), 2, matrix.data()}, move.data());
}

std::optional<PlaneMap> plane_map(const Spline &surface) {
    if (surface.rational() || surface.count(0) != 2 || surface.count(1) != 2 ||
        surface.axis(0).degree() != 1 || surface.axis(1).degree() != 1) {
        return std::nullopt;
    }
    const double largest = largest_magnitude(surface.points());
    const Interval u = surface.axis(0).domain(), v = surface.axis(1).domain();
    PlaneMap map;
    for (int c = 0; c < surface.dim(); ++c) {
        const auto corner = [&](int64_t i) { return surface.coordinate(i, c); };
        if (!(std::abs((corner(3) - corner(2)) - (corner(1) - corner(0))) <= 8 * eps * largest)) {
            return std::nullopt;
        }
        const double along_u = (corner(2) - corner(0)) / (u.upper - u.lower),
                     along_v = (corner(1) - corner(0)) / (v.upper - v.lower);
        map.matrix.insert(map.matrix.end(), {along_u, along_v});
        map.move.push_back(corner(0) - along_u * u.lower - along_v * v.lower);
    }
    return map;
}

} // namespace nrb::face
