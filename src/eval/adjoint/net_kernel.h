// SPDX-License-Identifier: MIT
// The sums of the gradients of a net, from cotangents of points.
#pragma once

#include "base/records.h"
#include "eval/kernels/axis_source.h"

namespace nrb::eval {

// Numbers of control points, component by component: those of neighbours along the last axis side by side, so
// that a vector of basis functions meets a vector of them. `padding` numbers after each component may be read
// and rewritten.
struct NetJob {
    static constexpr int64_t padding = 3;

    int axes;
    int dim;
    int order;                                  // 1 for gradients of parameters, else 0
    const AxisSource *sources;                  // [axes]
    std::array<AxisPoint *, max_axes> points{}; // working memory, for each axis [axis_block_size]
    std::array<double *, max_axes> values{};    // for each axis [axis_block_size][order + 1][lanes]
    double *work = nullptr;                     // [2 dim], working memory

    // The control points of the arrays: all of the net, or only the active ones of one parameter.
    bool whole = true;
    std::array<int64_t, max_axes> strides{}; // between layers of each axis
    int64_t size = 0;                        // between components
    const double *weights = nullptr;         // null: all 1
    bool even = true;                        // no weight is more than 4 times another
    const double *coordinates = nullptr;     // [dim], or null: only gradients of points are wanted
    double *grad_points = nullptr;           // [dim], or null: not wanted
    double *grad_weights = nullptr;          // or null
    double *slopes = nullptr;                // [axis_block_size][axes], or null
};

// The basis functions and first layers of at most axis_block_size parameters. Returns whether a parameter is
// special: it gives NaN, or lies where a function is alone.
bool find_net_bases(const NetJob &job, const ConstRecords &params) noexcept;

// What parameters first, ..., first + count - 1 of those contribute, with cotangents g (record i is that of
// parameter i), q = 1 / w(t) and the products d_i = <P_i - P, g> with any point P:
//   dL/dP_i = q N_i w_i g,   dL/dw_i = q N_i (d_i - h),   dL/dt = q (sum of N_i' w_i (d_i - h)),
// where h = q (sum of N_i w_i d_i). The first two are added one after the other; slopes are overwritten, but
// for parameters that give NaN.
void add_to_net(const NetJob &job, const ConstRecords &cotangents, int64_t first, int64_t count) noexcept;
// The same bits, faster, of cubic curves in space with whole arrays and, where products are made, even weights.
void add_to_cubic(const NetJob &job, const ConstRecords &cotangents, int64_t first, int64_t count) noexcept;

} // namespace nrb::eval
