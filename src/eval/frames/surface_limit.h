// SPDX-License-Identifier: MIT
// Unit normals of surfaces where S_u x S_v may vanish.
#pragma once

#include "eval/frames/jet.h"

namespace nrb::eval {

enum class NormalKind { regular, limit, undefined };

struct SurfaceNormal {
    NormalKind kind = NormalKind::undefined;
    Vector3 direction; // set for regular points and limits
};

// The kind of the normal at a parameter, and its direction. If S_u x S_v exceeds the bound of its rounding
// error, the point is regular. Otherwise S_u x S_v = sum N_ij s^i t^j is expanded into the domain. If the
// terms of the lowest order i + j that does not vanish all have one direction, this is the limit along every
// path into the domain that stays away from its borders. Cost: some 100 ns, or a microsecond if S_u x S_v
// vanishes. Precondition: Jet::prepare() has been called for the surface.
SurfaceNormal surface_normal(const Spline &spline, const AxisRules &rules, const double *param) noexcept;

} // namespace nrb::eval
