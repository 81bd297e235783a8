// SPDX-License-Identifier: MIT
// On which side of an offset surface the normal of its basis lies.
#pragma once

#include "fit/offset/offset_curve.h"

namespace nrb::fit {

// The offset O = S + d N has O_u x O_v = (1 - k1 d)(1 - k2 d) S_u x S_v with the principal curvatures k1, k2 of S (positive where it
// bends towards N). 1 where that factor is proven to be positive everywhere, so that the normals of both are equal, -1 where it is
// negative, 0 where it changes its sign, vanishes, or is too near that. `pieces`: parts of it that may be looked at; what is used is
// taken away. Precondition: dimension 3.
int offset_side(const SplinePtr &surface, double distance, int64_t &pieces);

// The same with as many pieces as a rule leaves, at most some thousands, which are taken away from its patches.
int offset_side(const SplinePtr &surface, double distance, const OffsetRule &rule);

// The same of a curve of dimension 2 or 3 and its offset along V x C' (offset_curve.h): 1 where that runs along the curve.
int offset_side(const SplinePtr &curve, const CurveOffset &offset, const OffsetRule &rule);

} // namespace nrb::fit
