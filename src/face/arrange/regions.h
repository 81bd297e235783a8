// SPDX-License-Identifier: MIT
// Regions of the plane: faces of a plane, each in one piece, with holes or without; none where there is nothing.
#pragma once

#include "face/face.h"

#include <span>
#include <vector>

namespace nrb::face {

// What counts as inside, by how often curves go around it.
enum class FillRule : int32_t {
    non_zero = 1, // a number other than 0
    even_odd = 2, // an odd number
    positive = 3, // more often counterclockwise than clockwise
};

enum class RegionRule : int32_t {
    either = 1,     // in a or in b: the union
    both = 2,       // the intersection
    difference = 3, // in a and not in b
    one = 4,        // in a or in b and not in both: the symmetric difference
};

// Of curves one after the other, which close where one comes back to the start of its loop. Throws Status::gap naming a curve
// that jumps, or does not go on, weight_sign, not_converged where rounding would have to decide.
std::vector<FacePtr> region_of(std::span<const SplinePtr> curves, FillRule rule, double tolerance);

// Faces in a are one region, however they overlap, and those in b. All are of one surface, or
// regions as region_of() makes them. Throws Status::incompatible otherwise, gap for a face with gaps; not_converged as above.
std::vector<FacePtr> combined(std::span<const FacePtr> a, std::span<const FacePtr> b, RegionRule rule,
                              double tolerance);

} // namespace nrb::face
