// SPDX-License-Identifier: MIT
// Layers that continue a spline beyond its ends. They come from tables with coefficients that are large and
// of both signs and add up to 1.
#pragma once

#include "spline/layer_table.h"

namespace nrb::refine {

struct ContinuedNet {
    Net net;
    int64_t infinite; // index of a point at infinity, which Form::rational cannot hold; -1: none
};

// The new layers in the form of the spline. Copied layers keep their stored bits. The sums are those of
// apply_along(), except for weights that differ little: these are summed as w_r + sum c_i (w_i - w_r), where
// c_r is the largest coefficient, because the rounding of terms such as 1e24 - 1e24 would be as large as the
// weight. Equal weights stay equal bit for bit. Weights of Form::rational may become negative. Throws
// Status::not_representable.
ContinuedNet continued_along(const Spline &spline, int axis, const LayerTable &table);

} // namespace nrb::refine
