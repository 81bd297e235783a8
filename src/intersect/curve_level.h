// SPDX-License-Identifier: MIT
// Where an implicit polynomial vanishes along a curve.
#pragma once

#include "intersect/hits.h"
#include "intersect/implicit_form.h"

namespace nrb::intersect {

// All places where |f| <= tolerance along the curve, as hits: the zeros in such a range, each of its own, or
// the place where |f| is smallest; but where |f| <= tolerance on a whole span or more, that range as one,
// unless there is just one zero in it. Signs are proven on Bernstein pieces, by variation diminishing. Throws
// Status::not_representable.
CurveHits curve_level(const Spline &curve, const ImplicitForm &form, double tolerance);

} // namespace nrb::intersect
