// SPDX-License-Identifier: MIT
// Evaluation in blocks: points and derivatives are handed to a sink block by block, so that results computed
// from them (frames, curvature, other number formats) never need an array of all derivatives.
#pragma once

#include "eval/parameters.h"

namespace nrb::eval {

inline constexpr int64_t block_size = 64;

// The sink: receives points first, ..., first + values.count - 1. Component c of slot s of point i of the
// block is values.data[(s * dim + c) * block_size + i]: each component has a row of block_size doubles, of
// which the first values.count are filled. A point that gives NaN has NaN in all of its rows.
class BlockSink {
public:
    virtual ~BlockSink() = default;
    // Whether the sink wants the values as packed records, one point after the other, instead of rows. A
    // block then has up to most_points points.
    [[nodiscard]] virtual bool wants_points() const noexcept { return false; }
    static constexpr int64_t most_points = 512;
    virtual void operator()(int64_t first, ConstRecords values) noexcept = 0;
};

// The same values as those of evaluate_points() and evaluate_grid() of evaluate.h, in blocks of at most
// block_size points (or most_points, see wants_points()). Blocks of a list come in rising order, blocks of a
// grid in any order. Throws, if at all, before the sink is called for the first time.
void evaluate_points(const Spline &spline, const AxisRules &rules, int order, const ConstRecords &params,
                     BlockSink &sink);
// evaluate_grid() of a surface or volume, computed point by point as a list: for grids whose rows are too
// short for the grid kernel to pay off.
void evaluate_combinations(const Spline &spline, const AxisRules &rules, int order,
                           const std::array<ConstRecords, max_axes> &params, const Records &out);
void evaluate_combinations(const Spline &spline, const AxisRules &rules, int order,
                           const std::array<ConstRecords, max_axes> &params, BlockSink &sink);
void evaluate_grid(const Spline &spline, const AxisRules &rules, int order,
                   const std::array<ConstRecords, max_axes> &params, BlockSink &sink);

} // namespace nrb::eval
