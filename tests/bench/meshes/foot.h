// SPDX-License-Identifier: MIT
// Distances from surfaces, from above: Newton's method gives some place of the surface, which may not be the nearest one.
#pragma once

#include "bench/meshes/mesh.h"

#include <algorithm>

namespace bench::meshes {

struct Jet {
    Point point, along_u, along_v;
};
struct Domain {
    Param lower, upper;
};

// How far a place in space is from the point at a parameter and from those of up to `steps` better parameters, as far as one
// that is not farther than `enough`. `jet_of(param)` evaluates.
template <class Evaluate>
double foot_distance(const Point &x, Param at, const Domain &domain, double enough, int steps,
                     Evaluate &&jet_of) {
    double least = INFINITY;
    for (int step = 0;; ++step) {
        const Jet jet = jet_of(at);
        const Point off = x - jet.point;
        least = std::min(least, length(off));
        if (step == steps || least <= enough) {
            return least;
        }
        const double uu = dot(jet.along_u, jet.along_u), uv = dot(jet.along_u, jet.along_v),
                     vv = dot(jet.along_v, jet.along_v), u = dot(jet.along_u, off), v = dot(jet.along_v, off),
                     determinant = uu * vv - uv * uv;
        if (!(determinant > 0)) {
            return least;
        }
        const Param move{(vv * u - uv * v) / determinant, (uu * v - uv * u) / determinant};
        for (size_t k = 0; k < 2; ++k) {
            at[k] = std::clamp(at[k] + move[k], domain.lower[k], domain.upper[k]);
        }
    }
}

// Places of a triangle that are likely to be far off: its middle and those of its sides.
inline constexpr Point middles[] = {{1.0 / 3, 1.0 / 3, 1.0 / 3}, {0.5, 0.5, 0}, {0, 0.5, 0.5}, {0.5, 0, 0.5}};

} // namespace bench::meshes
