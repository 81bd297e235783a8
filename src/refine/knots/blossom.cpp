// SPDX-License-Identifier: MIT
#include "refine/knots/blossom.h"

#include "basis/bspline.h"
#include "spline/axis_view.h"

#include <algorithm>
#include <array>

namespace nrb::refine {

namespace {

using Rows = std::array<BlossomRow, max_axes>;

// Removes a knot from the arguments in `values`, if it is among them. Returns whether it was.
bool take(double knot, KnotArguments &arguments) noexcept {
    double *const values = arguments.values.data(), *const end = values + arguments.others;
    double *const found = std::find(values, end, knot);
    if (found == end) {
        return false;
    }
    std::copy(found + 1, end, found);
    --arguments.others;
    return true;
}

} // namespace

KnotArguments split_arguments(const KnotVector &axis, int64_t span, std::span<const double> values) noexcept {
    KnotArguments split{span + 1, span + 1, static_cast<int>(values.size()), {}};
    std::ranges::copy(values, split.values.begin());
    for (bool taken = true; taken;) {
        const bool below = split.begin > 0 && take(axis[split.begin - 1], split);
        const bool above = split.end < std::ssize(axis.knots()) && take(axis[split.end], split);
        split.begin -= below ? 1 : 0;
        split.end += above ? 1 : 0;
        taken = below || above;
    }
    return split;
}

BlossomRow blossom_row(const KnotVector &axis, int64_t span, std::span<const double> values) noexcept {
    const KnotArguments split = split_arguments(axis, span, values);
    const double *knots = axis.knots().data();
    BlossomRow row;
    row.size = 1;
    row.coefficients[0] = 1;
    for (const double t : std::span(split.values).first(static_cast<size_t>(split.others))) {
        append_argument(knots + split.begin, knots + split.end, row.size++, t, row.coefficients);
    }
    row.first = split.begin - row.size;
    return row;
}

namespace {

Rows rows_at(const Spline &spline, const int64_t *spans, std::span<const double> arguments) noexcept {
    Rows rows;
    for (int k = 0; k < spline.axes(); ++k) {
        const auto at = static_cast<size_t>(k);
        const auto degree = static_cast<size_t>(spline.axis(k).degree());
        rows[at] = blossom_row(spline.axis(k), spans[k], arguments.first(degree));
        arguments = arguments.subspan(degree);
    }
    return rows;
}

// Component c of homogeneous record i, unscaled. A polynomial spline has no weights.
double record_value(const Spline &spline, int64_t i, int c) noexcept {
    const double stored =
        c < spline.stored_width() ? spline.points()[static_cast<size_t>(i * spline.stored_width() + c)] : 1;
    return spline.form() == Form::rational ? spline.weight(i) * stored : stored;
}

// The contraction of axes k, k + 1, ... with their rows, of the points whose index on the axes before is
// `base`. The last axis is contracted first.
double sum(const Spline &spline, const Rows &rows, int k, int64_t base, int c) noexcept {
    if (k == spline.axes()) {
        return record_value(spline, base, c);
    }
    const BlossomRow &row = rows[static_cast<size_t>(k)];
    double result = 0;
    for (int i = 0; i < row.size; ++i) {
        const int64_t next = base * spline.count(k) + row.first + i;
        result += row.coefficients[i] * sum(spline, rows, k + 1, next, c);
    }
    return result;
}

} // namespace

void blossom(const Spline &spline, const int64_t *spans, std::span<const double> arguments, double *out) {
    const Rows rows = rows_at(spline, spans, arguments);
    for (int c = 0; c < spline.width(); ++c) {
        out[c] = sum(spline, rows, 0, 0, c);
    }
}

} // namespace nrb::refine
