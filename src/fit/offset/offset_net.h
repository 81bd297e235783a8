// SPDX-License-Identifier: MIT
// Control points of splines that have the Taylor polynomials of an offset where their pieces end.
#pragma once

#include "fit/offset/patch_axis.h"
#include "spline/spline.h"

#include <array>

namespace nrb::fit {

using PatchAxes = std::array<PatchAxis, 2>;

struct OffsetCandidate {
    SplinePtr spline;
    double jump; // the largest distance of two corners of neighbours that are one
};

// Of a surface. Throws what offset_jets() does.
OffsetCandidate offset_candidate(const Spline &surface, double distance, const PatchAxes &axes);

} // namespace nrb::fit
