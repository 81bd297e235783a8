// SPDX-License-Identifier: MIT
// Control points of Hermite splines, which have the Taylor polynomials of an offset at the ends of their
// pieces.
#pragma once

#include "fit/offset/patch_axis.h"
#include "spline/spline.h"

#include <array>

namespace nrb::fit {

using PatchAxes = std::array<PatchAxis, 2>;

struct OffsetCandidate {
    SplinePtr spline;
    double jump; // largest gap between coinciding corners of neighbouring patches
};

// The candidate for the offset of a surface. Throws what offset_jets() throws.
OffsetCandidate offset_candidate(const Spline &surface, double distance, const PatchAxes &axes);

} // namespace nrb::fit
