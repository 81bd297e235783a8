// SPDX-License-Identifier: MIT
// A part of a face of a piece, and Newton's method for critical points on it.
#pragma once

#include "closest/patch/critical/critical_query.h"
#include "closest/patch/critical/patch_face.h"

#include <optional>

namespace nrb::closest {

struct FacePart {
    double *values;           // coefficients relative to the query point
    AxisValues lower, length; // in the piece, along the axes of the face
    int depth;

    // The middle, as a place in the piece.
    [[nodiscard]] AxisValues middle(const PatchFace &face) const noexcept;
    [[nodiscard]] int longest_axis(const PatchFace &face) const noexcept;
};

struct NewtonResult {
    AxisValues at; // in the piece
    bool converged;
};
// Newton's method from the middle of a part to a place in it where the distance is critical along the face.
// Empty if it leaves the part.
std::optional<NewtonResult> newton(const CriticalQuery &query, const PatchFace &face, const PatchItem &whole,
                                   const FacePart &part);

} // namespace nrb::closest
