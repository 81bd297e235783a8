// SPDX-License-Identifier: MIT
// The sides of patches, along which they may be sewn.
#pragma once

#include "face/face.h"
#include "intersect/rays/box_tree.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace nrb::model {

// A face prepared for sewing.
struct Patch {
    face::FacePtr given;
    std::vector<face::Loop> loops;
    // Whether the loops are the boundary of the whole surface, without those sides that at `tolerance` meet
    // each other (a seam) or are poles.
    bool natural = false;
    double tolerance = 0; // at which the surface closes up as the loops assume
};

// A face that is the whole of its surface gets the natural boundary at the tolerance of sewing, if that is
// larger than its own, unless the surface is so thin that two of its sides would meet all along.
Patch patch_of(const face::FacePtr &face, double tolerance);

// A curve of the domain along one axis: `across` is the other axis, on which it stays at `at`; along its own
// it runs from `from` to `to`.
struct StraightCurve {
    int across;
    double at, from, to;
};

// A curve of a loop, with its image on the surface in space over the same parameters.
struct Side {
    int64_t patch = 0, loop = 0, index = 0;
    SplinePtr curve, image{};
    double off = 0; // distance of `image` from the exact image as edge_over() found it, proven or not
    std::optional<StraightCurve> along{};
    intersect::Box3 box{}; // of the image
};

// The part of the curve in the domain over an interval of its parameter. A part of a straight curve along an
// axis is exactly along the axis, too.
SplinePtr curve_part(const Side &side, Interval range);

// Appends the sides of a patch, in the order of loops and curves.
void append_sides(const Patch &patch, int64_t number, double tolerance, std::vector<Side> &sides);

// Whether it is certain that no point of a curve is farther from its start than the tolerance.
bool is_collapsed(const Spline &curve, double tolerance);

} // namespace nrb::model
