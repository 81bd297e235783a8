// SPDX-License-Identifier: MIT
// Rays, and where they are in boxes.
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

// A ray as it is asked for: x = origin + t direction, for t in the range. What it was moved by may have rounded it.
struct RayQuery {
    Vector3 origin, direction;
    Interval range{0, infinity};
    double off = 0;    // how far the origin may be from the one that is meant
    double turned = 0; // and the direction, relative to its length
};

// A line x = origin + t direction.
struct Ray {
    Vector3 origin, direction;
    std::array<double, 3> start{}, inverse{}; // the origin, and 1 / direction

    Ray() = default;
    Ray(const Vector3 &from, const Vector3 &along) noexcept
        : origin(from),
          direction(along), start{from.x, from.y, from.z}, inverse{1 / along.x, 1 / along.y, 1 / along.z} {}
};

// In the frame of pieces, where directions are unit vectors and origins are moved along the ray to where it is nearest to
// the centre. t of the frame is (t of the query) factor - start.
struct PlacedRay {
    Ray ray;
    double factor = 1, start = 0;
    double moved = 0; // how far it may be from the ray that is meant, at the pieces

    PlacedRay() = default;
    PlacedRay(const pieces::PieceGrid &grid, const RayQuery &query);
    [[nodiscard]] double in_frame(double t) const noexcept { return std::isinf(t) ? t : t * factor - start; }
    [[nodiscard]] double of_query(double t) const noexcept { return (t + start) / factor; }
    // How far rounding moves the pieces, once they are turned, and the ray in all.
    [[nodiscard]] double room(const pieces::PieceGrid &grid) const noexcept;
};

// Where a ray is in a box, at most `room` larger; lower > upper: nowhere. Where the direction has no component along an
// axis, the inverse is infinite, and the ray is between both sides all along or nowhere.
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
