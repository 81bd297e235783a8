// SPDX-License-Identifier: MIT
// One point at a time, as most programs ask for points: what a batch prepares for its points is kept with the
// spline.
#pragma once

#include "base/records.h"
#include "basis/span_table.h"
#include "eval/parameters.h"

#include <array>

namespace nrb::eval {

struct SingleAxis {
    SpanTable::Finder find;
    Interval domain{};
    const double *power_spans = nullptr; // of a curve: its own; otherwise of the basis of the axis
    int64_t power_span_size = 0;
    const int64_t *spans = nullptr; // as SpanTable::indices()
    int64_t stride = 0;             // between layers of the net, in doubles
    int degree = 0;
};

// Everything that a point inside the spans is computed from. Points into the tables of a spline, which keeps it.
struct SingleTables {
    std::array<SingleAxis, max_axes> axes;
    int axis_count = 0;
    int dim = 0;
    int width = 0;
    int lanes = 0;
    int span_lanes = 0;          // as Spline::span_lanes(), of a curve
    const double *net = nullptr; // the records; null for a curve
};

// The tables of a spline that was evaluated often enough to have all that they point to; null before.
const SingleTables *single_tables(const Spline &spline) noexcept;
// Makes them if that is so; called after an evaluation.
void keep_single_tables(const Spline &spline);

// The same point as in a batch: params [axes], point [dim]. False, and nothing is written, unless every
// parameter lies strictly inside a span that has a power span, or a Bernstein span of a curve.
bool evaluate_single(const SingleTables &tables, const double *params, double *point) noexcept;
// The same with first derivatives, of a surface in space: derivs [3][3] are S, S_u and S_v.
bool evaluate_single_derivs(const SingleTables &tables, const double *params, double *derivs) noexcept;

} // namespace nrb::eval
