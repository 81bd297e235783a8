// SPDX-License-Identifier: MIT
// How the parameters of a grid are arranged for the grid kernel.
#pragma once

#include "eval/kernels/grid_kernel.h"

namespace nrb::eval {

// The layers of an axis (of the given degree) that are active at some parameter, in rising order.
std::vector<int64_t> needed_layers(const GridAxis &table, int degree);

// The valid parameters, sorted by their first active layer and divided into groups that share it. Parameters
// with the same layers keep their order.
std::vector<GridGroup> group_by_layers(const GridAxis &table);

// Copies the values of the table to [group][order + 1][degree + 1][grid_group], so that the parameters of a
// group lie side by side in vectors. A group that is not full repeats its last parameter.
void transpose_values(const GridAxis &table, const AxisSource &source, int order,
                      const std::vector<GridGroup> &groups, double *values) noexcept;

} // namespace nrb::eval
