// SPDX-License-Identifier: MIT
// Where an implicit polynomial vanishes along a curve.
#pragma once

#include "intersect/hits.h"
#include "intersect/implicit_form.h"

namespace nrb::intersect {

// All places along the curve where |f| <= tolerance, as hits. A range of such places yields a hit for each
// zero and jump in it, or if there is none, a contact where |f| is smallest. But a range that holds a whole
// span or more is one hit, an overlap, unless there is exactly one zero or jump in it. Signs are proven on
// Bernstein pieces by the variation diminishing property. Throws Status::not_representable.
CurveHits curve_level(const Spline &curve, const ImplicitForm &form, double tolerance);

} // namespace nrb::intersect
