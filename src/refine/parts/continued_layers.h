// Layers of control points continued beyond those of a spline, by tables whose coefficients add up to 1 but are
// large and of both signs.
#pragma once

#include "spline/layer_table.h"

namespace nrb::refine {

struct ContinuedNet {
    Net net;
    int64_t infinite; // a control point at infinity, which points and weights cannot hold, or -1
};

// The new layers in the form of the spline; copied ones keep their stored bits. The sums are those of
// apply_along(), but weights that differ little are added up as w_r + sum c_i (w_i - w_r), r the largest
// coefficient: what rounding leaves of a sum of 1e24 - 1e24 would be as large as the weight, and equal weights
// stay equal bit for bit. Weights of Form::rational may come out below 0. Throws Status::not_representable.
ContinuedNet continued_along(const Spline &spline, int axis, const LayerTable &table);

} // namespace nrb::refine
