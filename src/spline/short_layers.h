// SPDX-License-Identifier: MIT
// Layers of one short record each, along the only axis of a curve or the last axis of a surface or volume, in
// vectors of four. Most splines have such layers.
#pragma once

#include "spline/layer_table.h"

namespace nrb::inline spline {

inline constexpr int64_t longest_short_layer = 4;

// Rows of a table, and all of its coefficients.
struct LayerRows {
    std::span<const LayerTable::Row> rows;
    const double *coefficients;
};

// New layers from old ones of `width` doubles, at most longest_short_layer, with the bits of contract().
// Spline::padding doubles are read after the layers and written after the result.
void combine_short(const LayerRows &rows, const double *layers, int width, double *out) noexcept;

// The Cartesian points, and the weights, of new layers of one record (w x, w y, ..., w) each, for dimensions
// up to 3; copied layers are copied from `points` and `weights`. False if a sum has no weight: the result
// must then not be used. Padding as above, of `records` and `points`.
struct ShortNet {
    const double *records;
    const double *points;
    const double *weights;
    int dim;
};
bool combine_short(const LayerRows &rows, const ShortNet &net, double *points, double *weights) noexcept;

} // namespace nrb::inline spline
