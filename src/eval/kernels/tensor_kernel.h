// SPDX-License-Identifier: MIT
// The kernel of surfaces and volumes: evaluates points and derivatives at a list of parameters.
#pragma once

#include "eval/kernels/axis_source.h"
#include "eval/kernels/contraction.h"
#include "eval/kernels/finish.h"

#include <vector>

namespace nrb::eval {

// Points are computed in blocks, in passes: the basis functions of every axis, the contraction, the division.
// One fused loop would be slower, because the searches for the spans of the next points would wait for the
// sums.
struct TensorJob {
    const Spline &spline;
    const RecordShape &shape;
    const QuotientRule *quotient;               // null for a polynomial spline
    const AxisSource *sources;                  // [axes]
    const double *net;                          // the table of records; null: active records are copied
    int64_t block;                              // points in a block
    std::array<AxisPoint *, max_axes> points{}; // working memory, for each axis [block]
    std::array<double *, max_axes> values{};    // for each axis [block][order + 1][lanes]
    Slabs slabs;                                // of one point
    double *window;                             // the active records of one point, and padding
    double *records;                            // [block][slots][lanes]
    double *weights;                            // [slots]
};

void run(const TensorJob &job, const ConstRecords &params, const Records &out) noexcept;

} // namespace nrb::eval
