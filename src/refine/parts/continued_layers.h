// SPDX-License-Identifier: MIT
// Layers of control points continued beyond those of a spline, by tables whose coefficients add up to 1 but
// are large and of both signs.
#pragma once

#include "spline/layer_table.h"

namespace nrb::refine {

struct ContinuedNet {
    Net net;
    int64_t infinite; // a control point at infinity, which points and weights cannot hold; -1: none
};

// The new layers in the form of the spline; copied ones keep their stored bits. The sums are those of
// apply_along(), except that weights that differ little are added up as w_r + sum c_i (w_i - w_r), where r
// has the largest coefficient: the rounding of 1e24 - 1e24 would be as large as the weight. Equal weights
// stay equal bit for bit. Weights of Form::rational may become negative. Throws Status::not_representable.
ContinuedNet continued_along(const Spline &spline, int axis, const LayerTable &table);

} // namespace nrb::refine
