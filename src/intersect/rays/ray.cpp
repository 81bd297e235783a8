// SPDX-License-Identifier: MIT
#include "intersect/rays/ray.h"

#include "numeric/power_of_two.h"

namespace nrb::intersect {

// `moved` bounds the rounding in moving the origin, and the errors that the query allows. That of the
// direction counts in proportion to the distance from the origin of the query.
PlacedRay::PlacedRay(const pieces::PieceGrid &grid, const RayQuery &query) {
    factor = times_power_of_two(grid.scaled(length(scaled_to_one(query.direction))),
                                size_exponent(query.direction));
    std::array<double, 4> placed{};
    const double given[] = {query.origin.x, query.origin.y, query.origin.z};
    grid.place(given, placed.data());
    const Vector3 from{placed[0], placed[1], placed[2]}, along = unit(scaled_to_one(query.direction));
    start = -dot(from, along);
    ray = Ray(from + start * along, along);
    const double far = std::abs(start) + length(ray.origin) + 2 * grid.radius();
    moved = 4 * eps * std::abs(start) +
            (query.off > 0 || query.turned > 0 ? grid.scaled(query.off) + query.turned * far : 0);
}

// Turning takes three products and two sums for each coordinate, and evaluation some operations for each
// degree; their errors are relative to the distance from the origin.
double PlacedRay::room(const pieces::PieceGrid &grid) const noexcept {
    const double far = length(ray.origin) + grid.radius();
    return 1.01 * grid.moved() + (16 * eps + 4 * grid.value_error()) * far + moved;
}

} // namespace nrb::intersect
