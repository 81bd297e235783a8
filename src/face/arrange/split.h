// SPDX-License-Identifier: MIT
// Faces split along curves in the domain of their surface.
#pragma once

#include "face/face.h"

#include <optional>
#include <span>
#include <vector>

namespace nrb::face {

using FacePtr = std::shared_ptr<const Face>;

// The connected parts into which curves divide a face. The parts of curves that lie outside the face, or
// that end inside without dividing it, have no effect. Faces on both sides of a part of a curve have a common
// edge in space there, with one key. Coedges that stay whole keep their edges and keys; an edge without
// key gets one if parts on both sides have it. Throws Status::gap for a face with gaps, not_converged where
// rounding would have to decide.
struct SplitPart {
    FacePtr face;
    bool left = false, right = false; // whether it lies on that side of one of the curves
};
struct SplitFace {
    std::vector<SplitPart> parts;
    std::optional<Point2> loose; // a place of a curve, inside the face, with the same part on both sides
};
SplitFace split_with_sides(const Face &face, std::span<const SplinePtr> curves, double tolerance);

// The parts alone.
std::vector<FacePtr> split(const Face &face, std::span<const SplinePtr> curves, double tolerance);

} // namespace nrb::face
