// SPDX-License-Identifier: MIT
// Faces cut along curves in the domain of their surface.
#pragma once

#include "face/face.h"

#include <optional>
#include <span>
#include <vector>

namespace nrb::face {

using FacePtr = std::shared_ptr<const Face>;

// The parts of a face, each in one piece, that curves divide it into; what of these lies outside, and what ends inside without
// dividing anything, has no effect. Parts of the same curve to both sides have one edge in space with one key. Coedges that stay
// whole keep their edges and keys. Throws Status::gap for a face with gaps, not_converged where rounding would have to decide.
struct SplitPart {
    FacePtr face;
    bool left = false, right = false; // whether it lies to the left, and to the right, of one of the curves
};
struct SplitFace {
    std::vector<SplitPart> parts;
    std::optional<Point2> loose; // on a curve inside of the face that has the same part on both sides
};
SplitFace split_with_sides(const Face &face, std::span<const SplinePtr> curves, double tolerance);

// The parts alone.
std::vector<FacePtr> split(const Face &face, std::span<const SplinePtr> curves, double tolerance);

} // namespace nrb::face
