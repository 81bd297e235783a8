// SPDX-License-Identifier: MIT
// Rays, and the slab test for boxes.
#pragma once

#include "base/numbers.h"
#include "basis/knot_vector.h"
#include "numeric/vector3.h"
#include "pieces/tree/piece_grid.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace nrb::intersect {

// A ray as the caller gives it: x = origin + t direction, for t in the range. If it was moved to another
// place, off and turned bound the rounding of that.
struct RayQuery {
    Vector3 origin, direction;
    Interval range{0, infinity};
    double off = 0;    // a bound on the distance of the origin from the exact one
    double turned = 0; // the same for the direction, relative to its length
};

// A line x = origin + t direction.
struct Ray {
    Vector3 origin, direction;
    std::array<double, 3> start{}, inverse{}; // coordinates of the origin, and of 1 / direction

    Ray() = default;
    Ray(const Vector3 &from, const Vector3 &along) noexcept
        : origin(from),
          direction(along), start{from.x, from.y, from.z}, inverse{1 / along.x, 1 / along.y, 1 / along.z} {}
};

// A ray in the frame of pieces. The direction is a unit vector, and the origin is moved along the ray to the
// point nearest to the centre of the frame. The t in the frame is factor (t of the query) - start.
struct PlacedRay {
    Ray ray;
    double factor = 1, start = 0;
    double moved = 0; // a bound on its distance from the exact ray, near the pieces

    PlacedRay() = default;
    PlacedRay(const pieces::PieceGrid &grid, const RayQuery &query);
    [[nodiscard]] double in_frame(double t) const noexcept { return std::isinf(t) ? t : t * factor - start; }
    [[nodiscard]] double of_query(double t) const noexcept { return (t + start) / factor; }
    // A bound on the rounding in all: of the pieces, which are turned into the system of the ray, and of the
    // ray.
    [[nodiscard]] double room(const pieces::PieceGrid &grid) const noexcept;
};

// The slab test: where a ray is inside a box that is enlarged by `room`; lower > upper: nowhere. Where the
// direction has no component along an axis its inverse is infinite, and the ray is between both sides either
// everywhere or nowhere.
template <class T>
Interval slab(const T *lower, const T *upper, const Ray &ray, double room) noexcept {
    Interval inside{-infinity, infinity};
    for (size_t c = 0; c < 3; ++c) {
        const double from = double{lower[c]} - room - ray.start[c],
                     to = double{upper[c]} + room - ray.start[c];
        if (std::isinf(ray.inverse[c])) {
            if (from > 0 || to < 0) {
                return {infinity, -infinity};
            }
            continue;
        }
        const double first = from * ray.inverse[c], second = to * ray.inverse[c];
        inside.lower = std::max(inside.lower, std::min(first, second));
        inside.upper = std::min(inside.upper, std::max(first, second));
    }
    return inside;
}

} // namespace nrb::intersect
