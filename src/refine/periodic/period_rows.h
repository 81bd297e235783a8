// SPDX-License-Identifier: MIT
// Rows of periodic axes, whose layers continue without end.
#pragma once

#include "spline/layer_table.h"

namespace nrb::refine {

// The rows of `outer` in terms of the layers of `inner`. `inner` gives one period of the layers of `outer`;
// the period of its own layers is `period`. Without a period no row of `outer` leaves those of `inner`.
LayerTable composed(const LayerTable &outer, const LayerTable &inner, int64_t period);

// The rows of one period followed by the first `wrapped` of them again, over the stored layers of a period of
// `period` layers, with `shift` added to the numbers of the layers.
LayerTable wrapped_rows(const LayerTable &rows, int64_t shift, int64_t wrapped, int64_t period);

} // namespace nrb::refine
