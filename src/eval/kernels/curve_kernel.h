// SPDX-License-Identifier: MIT
// The kernel of curves: evaluates points and derivatives at a list of parameters.
#pragma once

#include "eval/kernels/finish.h"
#include "eval/parameters.h"

namespace nrb::eval {

struct CurveJob {
    const Spline &spline;
    AxisRule rule;
    const RecordShape &shape;
    const QuotientRule *quotient;  // null for a polynomial curve
    const SpanTable *spans;        // null with `power_spans`
    const PowerSpans *power_spans; // null while there is no table; spans are then made anew
    const double *net;             // the table of records, or null
    double *records;               // working memory: [group][slots][lanes], a group being curve_group points
    double *weights;               // [slots]
    double *power_span;            // one span, made anew
    double *values;                // [order + 1][degree + 1]
    double *window;                // [degree + 1][lanes]: the larger of record and span lanes
    double *point;                 // [lanes], as for window
};

inline constexpr int curve_group = 8;
inline constexpr int curve_block = 16; // parameters computed together, a multiple of curve_group

void run(const CurveJob &job, const ConstRecords &params, const Records &out) noexcept;

} // namespace nrb::eval
