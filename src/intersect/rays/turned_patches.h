// SPDX-License-Identifier: MIT
// Bezier pieces in the coordinate system of a ray.
#pragma once

#include "intersect/rays/ray.h"

#include <vector>

namespace nrb::intersect {

// Records (x w, y w, t w, w) about the origin of a ray, in an orthonormal system with the ray as the third
// axis.
class TurnedPatches {
public:
    static constexpr size_t lanes = 4;

    // Precondition: a curve or surface in space.
    explicit TurnedPatches(const pieces::PieceGrid &grid);

    // Sets the ray for the calls that follow.
    void set_ray(const PlacedRay &ray);
    void fill(int64_t piece, double *out) noexcept;
    // Where no weight is negative, a coefficient of weight 0 is 0 altogether and has no control point.
    [[nodiscard]] bool has_point(const double *record) const noexcept {
        return !grid_.positive() || record[3] != 0;
    }

private:
    const pieces::PieceGrid &grid_;
    std::vector<double> origin_, work_;
    Vector3 first_, second_, along_;
};

} // namespace nrb::intersect
