// SPDX-License-Identifier: MIT
// Evaluation of a single point, the most frequent call of many programs: what a batch prepares for its points
// is kept with the spline.
#pragma once

#include "base/records.h"
#include "basis/span_table.h"
#include "eval/parameters.h"

#include <array>

namespace nrb::eval {

// The tables of one axis.
struct SingleAxis {
    SpanTable::Finder find;
    Interval domain{};
    const double *power_spans = nullptr; // of the curve itself, or of the basis of the axis
    int64_t power_span_size = 0;
    const int64_t *spans = nullptr; // as SpanTable::indices()
    int64_t stride = 0;             // between layers of the net, in doubles
    int degree = 0;
};

// Everything that is needed to evaluate a point inside the spans. It points into the tables of a spline,
// which keeps it.
struct SingleTables {
    std::array<SingleAxis, max_axes> axes;
    int axis_count = 0;
    int dim = 0;
    int width = 0;
    int lanes = 0;
    int span_lanes = 0;          // for a curve: as Spline::span_lanes()
    const double *net = nullptr; // the records; null for a curve
};

// The tables of a spline, or null as long as it has not been evaluated often enough to have all that they
// point to.
const SingleTables *single_tables(const Spline &spline) noexcept;
// Makes these tables if all that they point to exists or has been paid for. Called after an evaluation.
void keep_single_tables(const Spline &spline);

// Evaluates the same point as a batch, bit for bit. params: [axes], point: [dim]. Returns false, and writes
// nothing, unless every parameter lies strictly inside a span that has a power span or, for a curve, a
// Bernstein span.
bool evaluate_single(const SingleTables &tables, const double *params, double *point) noexcept;
// The same with first derivatives, for a surface in space. derivs: [3][3], S, S_u and S_v.
bool evaluate_single_derivs(const SingleTables &tables, const double *params, double *derivs) noexcept;

} // namespace nrb::eval
