// SPDX-License-Identifier: MIT
// Regions of the plane, and Boolean operations on them. A region is a list of faces of a plane, each
// connected, with or without holes; the empty region has no faces.
#pragma once

#include "face/face.h"

#include <span>
#include <vector>

namespace nrb::face {

// What counts as inside, by the winding number.
enum class FillRule : int32_t {
    non_zero = 1, // any number other than 0
    even_odd = 2, // an odd number
    positive = 3, // a positive number: more turns counterclockwise than clockwise
};

enum class RegionRule : int32_t {
    either = 1,     // in a or in b: the union
    both = 2,       // the intersection
    difference = 3, // in a and not in b
    one = 4,        // in a or in b and not in both: the symmetric difference
};

// The region that loops of curves enclose. The curves follow one another; a loop ends with the curve that
// comes back to its start. Throws Status::gap naming a curve that jumps, or that does not begin where the one
// before it ends; weight_sign; not_converged where rounding would have to decide.
std::vector<FacePtr> region_of(std::span<const SplinePtr> curves, FillRule rule, double tolerance);

// The faces in a are one region, however they overlap, and so are the faces in b. All of them are on the same
// surface, or in regions as region_of() makes them. Throws Status::incompatible otherwise, gap for a face
// with gaps; not_converged as above.
std::vector<FacePtr> combined(std::span<const FacePtr> a, std::span<const FacePtr> b, RegionRule rule,
                              double tolerance);

} // namespace nrb::face
