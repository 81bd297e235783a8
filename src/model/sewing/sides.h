// SPDX-License-Identifier: MIT
// The sides along which patches may be sewn.
#pragma once

#include "face/face.h"
#include "intersect/rays/box_tree.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace nrb::model {

// A face as it is to be sewn.
struct Patch {
    face::FacePtr given;
    std::vector<face::Loop> loops;
    bool natural =
        false; // the boundary of its surface, of whose sides those that meet or are poles at the tolerance are left out
    double tolerance = 0; // at which its surface closes up as the loops have it
};

// A face that is all of a surface, whatever its tolerance, is taken as it is at the tolerance of sewing, unless it is so thin that
// its own sides would meet all over.
Patch patch_of(const face::FacePtr &face, double tolerance);

// A curve along an axis from end to end, as natural boundaries are.
struct StraightCurve {
    int across;
    double at, from, to;
};

// A curve of a loop, with what the surface makes of it in space over the same parameters.
struct Side {
    int64_t patch = 0, loop = 0, index = 0;
    SplinePtr curve, image{};
    double off = 0; // how far the image is from where the surface maps the curve to
    std::optional<StraightCurve> along{};
    intersect::Box3 box{}; // of the image
};

// The curve in the domain over a part of its parameters: exactly along the axis where all of it is.
SplinePtr curve_part(const Side &side, Interval range);

// In the order of patches, loops and curves.
std::vector<Side> sides_of(const std::vector<Patch> &patches, double tolerance);

// Whether no point of a curve is farther from its start than the tolerance, for certain.
bool is_collapsed(const Spline &curve, double tolerance);

} // namespace nrb::model
