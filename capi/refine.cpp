// SPDX-License-Identifier: MIT
// Knot insertion, and the matrix that maps the old layers of control points to the new ones.
#include "checks.h"
#include "guard.h"
#include "sparse.h"

#include "base/checked.h"
#include "refine/knots/insert.h"

#include <algorithm>

using namespace nrb;
using namespace nrb::capi;

namespace {

std::vector<double> new_knots(const nurbs *g, int32_t axis, int64_t count, const double *knots) {
    check_axis(spline_of(g), axis);
    check_length(count, "count");
    if (count > 0) {
        require(knots, "knots");
    }
    checked_array(count, "knots");
    return refine::checked_new_knots(g->spline->axis(axis), axis, {knots, static_cast<size_t>(count)});
}

// The number of matrix entries. A row of size 0 stands for a copy of an old layer, which is one entry 1.
int64_t entries_of(const LayerTable &table) {
    int64_t total = 0;
    for (int64_t r = 0; r < table.rows(); ++r) {
        total += std::max(table.row(r).size, 1);
    }
    return total;
}

// Fills the arrays that are not null.
void fill(const LayerTable &table, const eval::SparseRows &rows) noexcept {
    int64_t at = 0;
    for (int64_t r = 0; r < table.rows(); ++r) {
        const LayerTable::Row &row = table.row(r);
        const int size = std::max(row.size, 1);
        if (rows.row_pointers != nullptr) {
            rows.row_pointers[r] = at;
            rows.row_pointers[r + 1] = at + size;
        }
        for (int i = 0; i < size; ++i, ++at) {
            if (rows.columns != nullptr) {
                rows.columns[at] = row.first + i;
            }
            if (rows.values != nullptr) {
                rows.values[at] = row.size == 0 ? 1 : table.coefficients(row)[i];
            }
        }
    }
}

} // namespace

nurbs_status nurbs_insert_knot(const nurbs *g, int32_t axis, double knot, int32_t times, nurbs **out) {
    return guard([&] {
        require_out(out);
        check_axis(spline_of(g), axis);
        give(refine::insert_knot(g->spline, axis, knot, times), out);
    });
}

nurbs_status nurbs_refine(const nurbs *g, int32_t axis, int64_t count, const double *knots, nurbs **out) {
    return guard([&] {
        require_out(out);
        const std::vector<double> inserted = new_knots(g, axis, count, knots);
        give(refine::refine(g->spline, axis, inserted), out);
    });
}

nurbs_status nurbs_refine_uniform(const nurbs *g, int32_t axis, int64_t parts, nurbs **out) {
    return guard([&] {
        require_out(out);
        check_axis(spline_of(g), axis);
        give(refine::refine(g->spline, axis, refine::uniform_new_knots(g->spline->axis(axis), axis, parts)),
             out);
    });
}

nurbs_status nurbs_refinement_matrix(const nurbs *g, int32_t axis, int64_t count, const double *knots,
                                     int64_t cap, double *values, int64_t *columns, int64_t *row_pointers,
                                     int64_t *entries) {
    return guard([&] {
        const std::vector<double> inserted = new_knots(g, axis, count, knots);
        const LayerTable table = refine::refine_axis(g->spline->axis(axis), inserted).table;
        const int64_t total = entries_of(table);
        const SparseArrays arrays(cap, values, columns, row_pointers, entries);
        fill(table, arrays.check(table.rows(), total, {memory("knots", knots, count)}));
        arrays.finish(total);
    });
}
