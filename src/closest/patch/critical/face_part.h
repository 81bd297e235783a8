// SPDX-License-Identifier: MIT
// A part of a face of a piece, and Newton's method in it.
#pragma once

#include "closest/patch/critical/critical_query.h"
#include "closest/patch/critical/patch_face.h"

#include <optional>

namespace nrb::closest {

struct FacePart {
    double *values;           // coefficients about the query point
    AxisValues lower, length; // in the piece, along the axes of the face
    int depth;

    // As a place in the piece.
    [[nodiscard]] AxisValues middle(const PatchFace &face) const noexcept;
    [[nodiscard]] int longest_axis(const PatchFace &face) const noexcept;
};

struct NewtonResult {
    AxisValues at; // in the piece
    bool converged;
};
// From the middle of a part to a place in it where the distance is critical along the face. None if the steps
// lead out of the part.
std::optional<NewtonResult> newton(const CriticalQuery &query, const PatchFace &face, const PatchItem &whole,
                                   const FacePart &part);

} // namespace nrb::closest
