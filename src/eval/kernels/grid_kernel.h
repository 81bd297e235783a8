// SPDX-License-Identifier: MIT
// The kernel of grids. It contracts whole layers of the net with the functions of one parameter of an axis,
// so that all parameters of the later axes share the result.
#pragma once

#include "eval/blocks.h"
#include "eval/kernels/axis_source.h"
#include "eval/kernels/contraction.h"
#include "eval/kernels/finish.h"

#include <memory>
#include <vector>

namespace nrb::eval {

inline constexpr int grid_group = 8;

// A part of a slab that some parameter needs.
struct Stretch {
    int64_t offset;
    int64_t length;
};

// Up to grid_group parameters of the last axis with the same active layers, which are computed side by side
// in vectors.
struct GridGroup {
    int64_t first = 0; // active layer
    int count = 0;
    bool consecutive = true;
    int64_t position[grid_group] = {}; // of each parameter along the axis
};

// The basis functions of all parameters of one axis. Record i of `values` is [order + 1][lanes].
struct GridAxis {
    std::vector<AxisPoint> points;
    std::vector<double> values;

    [[nodiscard]] int64_t size() const noexcept { return std::ssize(points); }
};

using GridAxes = std::array<std::shared_ptr<const GridAxis>, max_axes>;

struct GridJob {
    const Spline &spline;
    const RecordShape &shape;
    const QuotientRule *quotient; // null for a polynomial spline
    const double *net;            // the records of all control points
    const AxisSources &sources;
    const GridAxes &tables;
    const std::vector<GridGroup> &groups;
    bool rising; // whether each group's points are consecutive and follow those of the group before
    const double *group_values;             // [group][order + 1][degree + 1][grid_group], aligned
    const std::vector<int64_t> &exceptions; // positions on the last axis: NaN, or a sole function
    std::array<std::span<const Stretch>, max_axes> stretches; // of each row of the slab after axis k
    Slabs slabs;
    double *rows; // [slots][width][grid_group], aligned
    Records out;
    int64_t begin; // first parameter of axis 0
    int64_t end;
    BlockSink *sink;     // null: `out` is the whole grid
    int64_t sink_first;  // number of the first point of the first row in the whole grid
    int64_t sink_stride; // between the first points of rows there
};

// Fills the table of one axis with the functions at all of its parameters.
void tabulate(const AxisSource &source, int order, ConstRecords params, GridAxis &table) noexcept;
void run(const GridJob &job) noexcept;

} // namespace nrb::eval
