// SPDX-License-Identifier: MIT
// Statistics for least squares fits: sums over the data in each cell of a grid, which can be added and
// subtracted.
#include "bytes.h"
#include "fit_arguments.h"
#include "guard.h"
#include "spline_data.h"
#include "structs.h"
#include "watched.h"

#include "base/checked.h"
#include "batch.h"
#include "fit/least_squares/fit_points.h"
#include "io/binary/statistics_bytes.h"

#include <cmath>

using namespace nrb;
using namespace nrb::capi;

namespace nrb::capi {

const fit::StatisticsPtr &statistics_of(const nurbs_statistics *statistics, const char *name) {
    require(statistics, name);
    return statistics->statistics;
}

eval::AxisRules data_rules(uint32_t flags, int axes, const char *where) {
    const eval::AxisRules rules = decode_rules(flags, axes);
    for (const eval::AxisRule &rule : rules) {
        if (rule.outside == eval::Outside::extrapolate) {
            fail(Status::flags, "%sflags = 0x%x: there are no cells to extrapolate to", where, flags);
        }
    }
    return rules;
}

CheckedData checked_data(const nurbs_data *data) {
    const nurbs_data &given = checked_struct("data", data);
    check_axes(given.axes);
    check_dimension(given.dim);
    check_length(given.n, "n");
    if (given.reserved != 0) {
        fail(Status::options, "data: reserved = %u, expected 0", given.reserved);
    }
    CheckedData checked{};
    checked.rules = data_rules(given.flags, given.axes, "data: ");
    checked.data.params =
        input("params", given.params, given.n, given.axes, given.param_stride, given.param_component_stride);
    checked.data.values =
        input("values", given.values, given.n, given.dim, given.value_stride, given.value_component_stride);
    if (given.weights != nullptr) {
        checked.data.weights = input("weights", given.weights, given.n, given.weight_stride);
    }
    return checked;
}

} // namespace nrb::capi

namespace {

int checked_scale(double scale, const char *name) {
    if (!(std::isfinite(scale) && scale > 0)) {
        fail(Status::factor, "%s = %s, expected a finite value > 0", name, Number(scale).text);
    }
    return fit::exponent_above(scale);
}

// The breaks of an axis, as a knot vector of degree 0, whose spans are the cells.
KnotVectorPtr checked_breaks(const double *breaks, int64_t count, int axis, int64_t offset) {
    for (int64_t i = 0; i < count; ++i) {
        if (!std::isfinite(breaks[i])) {
            fail(Status::knot_not_finite, "breaks[%lld] = %s is not finite",
                 static_cast<long long>(offset + i), Number(breaks[i]).text);
        }
        if (i > 0 && breaks[i] <= breaks[i - 1]) {
            fail(Status::knots_decreasing,
                 "breaks[%lld] = %s on axis %d, expected more than breaks[%lld] = %s",
                 static_cast<long long>(offset + i), Number(breaks[i]).text, axis,
                 static_cast<long long>(offset + i - 1), Number(breaks[i - 1]).text);
        }
    }
    return make_knot_vector(0, {breaks, breaks + count}, false, axis, offset);
}

std::shared_ptr<const fit::StatisticsForm> checked_form(int32_t axes, const int32_t *degrees,
                                                        const int64_t *break_counts, const double *breaks,
                                                        int64_t break_total) {
    check_axes(axes);
    require(degrees, "degrees");
    require(break_counts, "break_counts");
    fit::StatisticsForm form{{degrees, degrees + axes}, {}, 1, 0, 0};
    int64_t total = 0, cells = 1;
    for (int k = 0; k < axes; ++k) {
        check_degree(degrees[k], k);
        if (break_counts[k] < 2) {
            fail(Status::count, "break_counts[%d] = %lld, expected at least 2", k,
                 static_cast<long long>(break_counts[k]));
        }
        total = checked_sum(total, checked_array(break_counts[k], "breaks"), "breaks");
        cells = checked_product(cells, break_counts[k] - 1, "cells");
    }
    check_size(break_total, total, "break_total");
    require(breaks, "breaks");
    int64_t offset = 0;
    for (int k = 0; k < axes; ++k) {
        form.breaks.push_back(checked_breaks(breaks + offset, break_counts[k], k, offset));
        offset += break_counts[k];
    }
    return std::make_shared<const fit::StatisticsForm>(std::move(form));
}

void give(fit::Statistics made, nurbs_statistics **out) {
    *out = new nurbs_statistics{std::make_shared<const fit::Statistics>(std::move(made))};
}

void check_same(int32_t n, int64_t expected, Status status, const char *name) {
    if (n != expected) {
        fail(status, "data: %s = %d, that of the statistics is %lld", name, n,
             static_cast<long long>(expected));
    }
}

} // namespace

nurbs_status nurbs_data_init(nurbs_data *data, int64_t struct_size) {
    return guard([&] { clear_struct("data", data, struct_size); });
}

nurbs_status nurbs_statistics_create(int32_t axes, const int32_t *degrees, const int64_t *break_counts,
                                     const double *breaks, int64_t break_total, int32_t dim,
                                     double value_scale, double weight_scale, nurbs_statistics **out) {
    return guard([&] {
        require_out(out);
        fit::StatisticsForm form = *checked_form(axes, degrees, break_counts, breaks, break_total);
        check_dimension(dim);
        form.dim = dim;
        form.value_exponent = checked_scale(value_scale, "value_scale");
        form.weight_exponent = checked_scale(weight_scale, "weight_scale");
        give(fit::Statistics(std::make_shared<const fit::StatisticsForm>(std::move(form))), out);
    });
}

nurbs_status nurbs_statistics_add(const nurbs_statistics *statistics, const nurbs_data *data,
                                  nurbs_statistics **out) {
    return guard([&] {
        require_out(out);
        const fit::StatisticsPtr &before = statistics_of(statistics);
        const CheckedData more = checked_data(data);
        check_same(data->axes, before->form().axes(), Status::axes, "axes");
        check_same(data->dim, before->form().dim, Status::dimension, "dim");
        auto added = std::make_shared<const fit::Statistics>(
            fit::gather(before->shared_form(), more.data, more.rules));
        if (before->cells().empty()) {
            *out = new nurbs_statistics{std::move(added)};
            return;
        }
        const fit::StatisticsPtr both[] = {before, std::move(added)};
        give(fit::merged(both, {}), out);
    });
}

nurbs_status nurbs_statistics_add_with(const nurbs_statistics *statistics, const nurbs_data *data,
                                       const nurbs_call_options *call, nurbs_statistics **out) {
    return watched(call, out, [&] { return nurbs_statistics_add(statistics, data, out); });
}

nurbs_status nurbs_statistics_merge(int64_t count, const nurbs_statistics *const *parts, const int32_t *signs,
                                    nurbs_statistics **out) {
    return guard([&] {
        require_out(out);
        check_at_least(count, 1, "count");
        checked_array(count, "parts");
        require(parts, "parts");
        std::vector<fit::StatisticsPtr> all;
        for (int64_t i = 0; i < count; ++i) {
            if (parts[i] == nullptr) {
                fail(Status::null, "parts[%lld] is NULL", static_cast<long long>(i));
            }
            if (signs != nullptr && signs[i] != 1 && signs[i] != -1) {
                fail(Status::rule, "signs[%lld] = %d, expected 1 or -1", static_cast<long long>(i), signs[i]);
            }
            all.push_back(parts[i]->statistics);
        }
        const auto size = signs == nullptr ? 0 : static_cast<size_t>(count);
        give(fit::merged(all, {signs, size}), out);
    });
}

nurbs_status nurbs_statistics_clone(const nurbs_statistics *statistics, nurbs_statistics **out) {
    return guard([&] {
        require_out(out);
        *out = new nurbs_statistics{statistics_of(statistics)};
    });
}

void nurbs_statistics_destroy(nurbs_statistics *statistics) {
    delete statistics;
}

nurbs_status nurbs_statistics_size(const nurbs_statistics *statistics, int32_t *axes, int32_t *dim,
                                   int64_t *count, int64_t *cells, double *weight) {
    return guard([&] {
        const fit::Statistics &own = *statistics_of(statistics);
        check_apart({memory("axes", axes, 1), memory("dim", dim, 1), memory("count", count, 1),
                     memory("cells", cells, 1), memory("weight", weight, 1)},
                    {});
        const double sum = own.weight();
        put(axes, own.form().axes());
        put(dim, own.form().dim);
        put(count, own.data_count());
        put(cells, std::ssize(own.cells()));
        put(weight, sum);
    });
}

nurbs_status nurbs_statistics_to_bytes(const nurbs_statistics *statistics, int64_t cap, void *bytes,
                                       int64_t *length) {
    return guard([&] {
        const fit::Statistics &own = *statistics_of(statistics);
        give_bytes(io::size_in_bytes(own), cap, bytes, length,
                   [&](std::span<unsigned char> out) { io::write_bytes(own, out); });
    });
}

nurbs_status nurbs_statistics_from_bytes(const void *bytes, int64_t size, nurbs_statistics **out) {
    return guard([&] {
        require_out(out);
        give(io::statistics_from(checked_bytes(bytes, size)), out);
    });
}
