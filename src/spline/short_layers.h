// Layers of one short record each, along the only axis of a curve or the last axis of anything else: what most
// splines are made of, in vectors of four.
#pragma once

#include "spline/layer_table.h"

namespace nrb::inline spline {

inline constexpr int64_t longest_short_layer = 4;

// New layers from old ones of `width` doubles, at most longest_short_layer, with the bits of contract().
// Spline::padding doubles are read behind the layers and written behind the result.
void combine_short(const LayerTable &table, const double *layers, int width, double *out) noexcept;

// The Cartesian points, and the weights, of new layers of one record (w x, w y, ..., w) each, for dimensions
// up to 3; copied layers are copied from `points` and `weights`. False if a sum has no weight: the result is
// then of no use. Padding as above, of `records` and `points`.
struct ShortNet {
    const double *records;
    const double *points;
    const double *weights;
    int dim;
};
bool combine_short(const LayerTable &table, const ShortNet &net, double *points, double *weights) noexcept;

} // namespace nrb::inline spline
