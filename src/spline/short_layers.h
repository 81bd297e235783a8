// SPDX-License-Identifier: MIT
// Layers of a single short record, computed in vectors of four doubles. They occur along the axis of a curve
// and along the last axis of a surface or volume, if records have at most four components, as in most
// splines.
#pragma once

#include "spline/layer_table.h"

namespace nrb::inline spline {

inline constexpr int64_t longest_short_layer = 4;

// Some rows of a table, and all of its coefficients.
struct LayerRows {
    std::span<const LayerTable::Row> rows;
    const double *coefficients;
};

// Computes layers of `width` <= longest_short_layer doubles each, with the same bits as contract().
// Spline::padding doubles are read after the layers and written after the result.
void combine_short(const LayerRows &rows, const double *layers, int width, double *out) noexcept;

// Computes the Cartesian points and the weights of layers of one record (w x, w y, ..., w) each, in
// dimensions up to 3. Copied layers are taken from `points` and `weights`. Returns false if the weight of a
// sum is 0; the result must not be used then. Padding as above, for `records` and `points`.
struct ShortNet {
    const double *records;
    const double *points;
    const double *weights;
    int dim;
};
bool combine_short(const LayerRows &rows, const ShortNet &net, double *points, double *weights) noexcept;

} // namespace nrb::inline spline
