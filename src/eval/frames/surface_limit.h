// SPDX-License-Identifier: MIT
// Unit normals where S_u x S_v may vanish.
#pragma once

#include "eval/frames/jet.h"

namespace nrb::eval {

enum class NormalKind { regular, limit, undefined };

struct SurfaceNormal {
    NormalKind kind = NormalKind::undefined;
    Vector3 direction; // of a limit only
};

// Decides whether S_u x S_v exceeds the bound of its rounding error. If not, S_u x S_v = sum N_ij s^i t^j is
// expanded into the domain. If the terms of the lowest order that does not vanish have one direction, this is
// the limit along every way into the domain that keeps away from its borders. Cost: some 100 ns, a
// microsecond if S_u x S_v vanishes. Precondition: Jet::prepare().
SurfaceNormal surface_normal(const Spline &spline, const AxisRules &rules, const double *param) noexcept;

} // namespace nrb::eval
