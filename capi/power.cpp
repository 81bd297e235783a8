// SPDX-License-Identifier: MIT
// Conversion to and from the power basis of the polynomial pieces.
#include "guard.h"
#include "sparse.h"

#include "base/checked.h"
#include "refine/forms/power.h"
#include "spline_data.h"

#include <algorithm>
#include <cmath>
#include <limits>

using namespace nrb;
using namespace nrb::capi;

namespace {

// The number of values of all coefficients: pieces * coefficients of a piece * width of a record.
int64_t power_size(const Spline &spline) {
    int64_t size = spline.width();
    for (int k = 0; k < spline.axes(); ++k) {
        const KnotVector &axis = spline.axis(k);
        size = checked_product(
            size, checked_product(axis.spans().size(), int64_t{axis.degree()} + 1, "coefficients"),
            "coefficients");
    }
    return size;
}

int64_t breaks_total(const Spline &spline) {
    int64_t total = 0;
    for (int k = 0; k < spline.axes(); ++k) {
        total += spline.axis(k).spans().size() + 1;
    }
    return total;
}

void write_form(const refine::PowerForm &form, double *coefficients, double *breaks) {
    if (coefficients != nullptr) {
        std::copy(form.coefficients.begin(), form.coefficients.end(), coefficients);
    }
    for (const std::vector<double> &axis : form.breaks) {
        if (breaks != nullptr) {
            breaks = std::copy(axis.begin(), axis.end(), breaks);
        }
    }
}

void check_break(const double *breaks, int64_t i, bool first) {
    if (!std::isfinite(breaks[i])) {
        fail(Status::knot_not_finite, "breaks[%lld] = %s is not finite", static_cast<long long>(i),
             Number(breaks[i]).text);
    }
    if (!first && !(breaks[i] > breaks[i - 1])) {
        fail(Status::knots_decreasing, "breaks[%lld] = %s, expected more than breaks[%lld] = %s",
             static_cast<long long>(i), Number(breaks[i]).text, static_cast<long long>(i - 1),
             Number(breaks[i - 1]).text);
    }
}

void check_piece_counts(const AxesData &axes, const int64_t *piece_counts) {
    require(piece_counts, "piece_counts");
    for (int k = 0; k < axes.size(); ++k) {
        if (piece_counts[k] < 1) {
            fail(Status::count, "piece_counts[%d] = %lld, expected at least 1", k,
                 static_cast<long long>(piece_counts[k]));
        }
    }
}

// The number of records of coefficients in all pieces. Refuses numbers of pieces that no array can have, and
// a wrong break_count.
int64_t check_totals(const AxesData &axes, const int64_t *piece_counts, int64_t break_count) {
    int64_t breaks = 0, records = 1;
    for (int k = 0; k < axes.size(); ++k) {
        breaks = checked_sum(breaks, checked_sum(piece_counts[k], 1, "breaks"), "breaks");
        const int64_t layers = checked_product(piece_counts[k], int64_t{axes[k].degree} + 1, "coefficients");
        records = checked_product(records, layers, "coefficients");
    }
    check_size(break_count, breaks, "break_count");
    return records;
}

std::vector<std::vector<double>> checked_breaks(const AxesData &axes, const int64_t *piece_counts,
                                                const double *breaks) {
    std::vector<std::vector<double>> result;
    int64_t offset = 0;
    for (int k = 0; k < axes.size(); ++k) {
        const int64_t end = offset + piece_counts[k] + 1;
        for (int64_t i = offset; i < end; ++i) {
            check_break(breaks, i, i == offset);
        }
        if (!std::isfinite(breaks[end - 1] - breaks[offset])) {
            fail(Status::knot_not_finite, "breaks[%lld] - breaks[%lld] overflows",
                 static_cast<long long>(end - 1), static_cast<long long>(offset));
        }
        result.emplace_back(breaks + offset, breaks + end);
        offset = end;
    }
    return result;
}

int record_width(int32_t dim, uint32_t flags) {
    if ((flags & ~NURBS_HOMOGENEOUS) != 0) {
        fail(Status::flags, "flags = 0x%x, expected NURBS_HOMOGENEOUS or 0", flags);
    }
    check_dimension(dim);
    return dim + (flags != 0 ? 1 : 0);
}

} // namespace

nurbs_status nurbs_to_power(const nurbs *g, int64_t cap, double *coefficients, double *breaks,
                            int64_t *piece_counts, int64_t *count) {
    return guard([&] {
        const Spline &spline = spline_of(g);
        const int64_t size = power_size(spline);
        const int64_t filled = checked_cap(cap, size);
        check_apart({memory("coefficients", coefficients, filled),
                     memory("breaks", breaks, filled == 0 ? 0 : breaks_total(spline)),
                     memory("piece_counts", piece_counts, spline.axes()), memory("count", count, 1)},
                    {});
        if (filled != 0) {
            write_form(refine::to_power(g->spline), coefficients, breaks);
        }
        for (int k = 0; k < spline.axes() && piece_counts != nullptr; ++k) {
            piece_counts[k] = spline.axis(k).spans().size();
        }
        put(count, size);
    });
}

nurbs_status nurbs_create_power(int32_t axes, const int32_t *degrees, const int64_t *piece_counts,
                                const double *breaks, int64_t break_count, int32_t dim,
                                const double *coefficients, int64_t coefficient_stride,
                                int64_t coefficient_component_stride, uint32_t flags, nurbs **out) {
    return guard([&] {
        require_out(out);
        const AxesData data(axes, degrees);
        check_piece_counts(data, piece_counts);
        const int64_t records = check_totals(data, piece_counts, break_count);
        require(breaks, "breaks");
        const int width = record_width(dim, flags);
        const std::vector<double> values = packed(input("coefficients", coefficients, records, width,
                                                        coefficient_stride, coefficient_component_stride));
        give(refine::from_power(
                 {{degrees, degrees + axes}, checked_breaks(data, piece_counts, breaks), width, values},
                 flags != 0),
             out);
    });
}
