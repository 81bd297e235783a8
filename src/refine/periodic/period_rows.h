// SPDX-License-Identifier: MIT
// Tables for periodic axes, whose layers form an endless sequence.
#pragma once

#include "spline/layer_table.h"

namespace nrb::refine {

// The composition of two tables: the rows of `outer`, in terms of the old layers of `inner`. On a periodic
// axis `inner` gives one period of the layers that `outer` combines, and `period` is the number of its old
// layers in a period. On any other axis the rows of `outer` refer only to rows of `inner`.
LayerTable composed(const LayerTable &outer, const LayerTable &inner, int64_t period);

// The rows of one period followed by copies of the first `wrapped` of them. `shift` is added to the numbers
// of their layers, which are then reduced modulo `period` to stored layers.
LayerTable wrapped_rows(const LayerTable &rows, int64_t shift, int64_t wrapped, int64_t period);

} // namespace nrb::refine
