// SPDX-License-Identifier: MIT
// How the parameters of a grid are laid out for its kernel.
#pragma once

#include "eval/kernels/grid_kernel.h"

namespace nrb::eval {

// Every layer of an axis of that degree that is active at some parameter, in rising order.
std::vector<int64_t> needed_layers(const GridAxis &table, int degree);

// The valid parameters, sorted by their layers, in groups. Parameters in rising order keep that order.
std::vector<GridGroup> group_by_layers(const GridAxis &table);

// [group][order + 1][degree + 1][grid_group] from the table's values; a group that is not full repeats its
// last parameter.
void transpose_values(const GridAxis &table, const AxisSource &source, int order,
                      const std::vector<GridGroup> &groups, double *values) noexcept;

} // namespace nrb::eval
