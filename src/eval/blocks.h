// SPDX-License-Identifier: MIT
// Evaluation in blocks, for results that are computed from points and derivatives (frames, curvature, other
// number formats): no array of all derivatives is ever made.
#pragma once

#include "eval/parameters.h"

namespace nrb::eval {

inline constexpr int64_t block_size = 64;

// Receives points first, ..., first + values.count - 1. Component slot * dim + c of point i of the block is
// values.data[(slot * dim + c) * block_size + i]: one row of block_size doubles for each component, of which
// the first values.count are filled. A point that gives NaN has NaN in all rows.
class BlockSink {
public:
    virtual ~BlockSink() = default;
    // Whether values come as points one after the other in place of such rows, up to most_points of them.
    [[nodiscard]] virtual bool wants_points() const noexcept { return false; }
    static constexpr int64_t most_points = 512;
    virtual void operator()(int64_t first, ConstRecords values) noexcept = 0;
};

// The same as evaluate_points() and evaluate_grid(), at most block_size points (or most_points) at a time, in any order. May
// throw only std::bad_alloc, before the sink is called.
void evaluate_points(const Spline &spline, const AxisRules &rules, int order, const ConstRecords &params,
                     BlockSink &sink);
// evaluate_grid() point by point, for grids of surfaces and volumes whose rows are too short for the kernel
// of grids to pay.
void evaluate_combinations(const Spline &spline, const AxisRules &rules, int order,
                           const std::array<ConstRecords, max_axes> &params, const Records &out);
void evaluate_combinations(const Spline &spline, const AxisRules &rules, int order,
                           const std::array<ConstRecords, max_axes> &params, BlockSink &sink);
void evaluate_grid(const Spline &spline, const AxisRules &rules, int order,
                   const std::array<ConstRecords, max_axes> &params, BlockSink &sink);

} // namespace nrb::eval
