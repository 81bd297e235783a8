// SPDX-License-Identifier: MIT
// The kernels that add up the gradients of a net from cotangents of points.
#pragma once

#include "base/records.h"
#include "eval/kernels/axis_source.h"

namespace nrb::eval {

// The data of the kernels. Arrays of control points are stored component by component. Neighbours along the
// last axis are adjacent, so that a vector of basis functions is multiplied by a vector of control points.
// Vectors may read and rewrite `padding` numbers after each component.
struct NetJob {
    static constexpr int64_t padding = 3;

    int axes;
    int dim;
    int order;                                  // 1 for gradients of parameters, else 0
    const AxisSource *sources;                  // [axes]
    std::array<AxisPoint *, max_axes> points{}; // working memory, for each axis [axis_block_size]
    std::array<double *, max_axes> values{};    // for each axis [axis_block_size][order + 1][lanes]
    double *work = nullptr;                     // [2 dim], working memory

    // Which control points the arrays hold: all of the net (`whole`), or only the active ones of one
    // parameter.
    bool whole = true;
    std::array<int64_t, max_axes> strides{}; // between layers of each axis
    int64_t size = 0;                        // between components
    const double *weights = nullptr;         // null: all 1
    bool even = true;                        // no weight is more than 4 times another
    const double *coordinates = nullptr;     // [dim]; null if only gradients of points are wanted
    double *grad_points = nullptr;           // [dim]; null: not wanted
    double *grad_weights = nullptr;          // or null
    double *slopes = nullptr;                // [axis_block_size][axes]; may be null
};

// Computes the basis functions and first layers of at most axis_block_size parameters. Returns whether some
// parameter is special: it gives NaN, or one of its functions is 1 and all others are 0.
bool find_net_bases(const NetJob &job, const ConstRecords &params) noexcept;

// Adds the contributions of parameters first, ..., first + count - 1 to the gradients. Let g be the cotangent
// of a parameter (record i is that of parameter i), q = 1 / w(t), d_i = <P_i - P, g> with any fixed point P,
// and h = q (sum of N_i w_i d_i). Then
//   dL/dP_i = q N_i w_i g,   dL/dw_i = q N_i (d_i - h),   dL/dt = q (sum of N_i' w_i (d_i - h)).
// The first two are added one parameter after the other. The slopes dL/dt are overwritten, except for
// parameters that give NaN.
void add_to_net(const NetJob &job, const ConstRecords &cotangents, int64_t first, int64_t count) noexcept;
// The same bits, faster, for cubic curves in space. Preconditions: the arrays hold the whole net and, if
// coordinates are given, the weights are even.
void add_to_cubic(const NetJob &job, const ConstRecords &cotangents, int64_t first, int64_t count) noexcept;

} // namespace nrb::eval
