// Values of polar forms.
#pragma once

#include "spline/spline.h"

#include <span>

namespace nrb {

// The polar form of the piece on the non-empty spans `spans`, one for each axis, at degree arguments for each
// axis, one axis after the other: `width()` components of an unscaled homogeneous record, (w x, ..., w) or
// (x, ...). L. Ramshaw, "Blossoms are polar forms", Computer Aided Geometric Design 6 (1989). Cost: degree^2 / 2
// divisions for each axis, and what a point costs.
void blossom(const Spline &spline, const int64_t *spans, std::span<const double> arguments, double *out);

} // namespace nrb
