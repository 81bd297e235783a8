// SPDX-License-Identifier: MIT
// Bezier pieces as a ray sees them.
#pragma once

#include "intersect/rays/ray.h"

#include <vector>

namespace nrb::intersect {

// About the origin of a ray and turned so that the ray is the third axis: (x w, y w, t w, w).
class TurnedPatches {
public:
    static constexpr size_t lanes = 4;

    // Precondition: a curve or surface in space.
    explicit TurnedPatches(const pieces::PieceGrid &grid);

    // For what follows.
    void set_ray(const PlacedRay &ray);
    void fill(int64_t piece, double *out) noexcept;
    // Coefficients of weight 0 are 0 altogether where no weight is negative: they say nothing.
    [[nodiscard]] bool has_point(const double *record) const noexcept {
        return !grid_.positive() || record[3] != 0;
    }

private:
    const pieces::PieceGrid &grid_;
    std::vector<double> origin_, work_;
    Vector3 first_, second_, along_;
};

} // namespace nrb::intersect
