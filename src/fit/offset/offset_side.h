// SPDX-License-Identifier: MIT
// Whether the normals of an offset surface and of its basis surface are on the same side.
#pragma once

#include "fit/offset/offset_curve.h"

namespace nrb::fit {

// The offset O = S + d N has O_u x O_v = (1 - k1 d)(1 - k2 d) S_u x S_v with the principal curvatures k1, k2
// of S, which are positive where S bends towards N. Returns 1 if that factor is proven to be positive
// everywhere, so that the normals of both are equal; -1 if it is proven to be negative everywhere; 0 if it
// changes its sign, vanishes, or is too near 0 to tell. `pieces`: the number of parts of the surface that may
// be looked at; those used are subtracted. Precondition: dimension 3.
int offset_side(const SplinePtr &surface, double distance, int64_t &pieces);

// The same with as many pieces as a rule leaves, at most some thousands; what is used is subtracted from its
// patches.
int offset_side(const SplinePtr &surface, double distance, const OffsetRule &rule);

// The same for a curve of dimension 2 or 3 and its offset along V x C' (offset_curve.h): 1 if the offset runs
// along the curve everywhere.
int offset_side(const SplinePtr &curve, const CurveOffset &offset, const OffsetRule &rule);

} // namespace nrb::fit
