// SPDX-License-Identifier: MIT
// Periodic axes in unwrapped form, in which each control point and each knot of a period occurs once.
#include "guard.h"
#include "outputs.h"

#include "base/checked.h"
#include "refine/periodic/unwrapped.h"
#include "spline_data.h"

#include <algorithm>

namespace {

using namespace nrb;
using namespace nrb::capi;

// The number of stored control points along periodic axis k, `count` of which are distinct.
int64_t wrapped_count(int32_t degree, int64_t count, int k) {
    check_degree(degree, k);
    if (count < 1) {
        fail(Status::count, "counts[%d] = %lld, expected at least 1", k, static_cast<long long>(count));
    }
    return checked_sum(checked_array(count, "points"), degree, "points");
}

AxesData wrapped_axes(int32_t axes, const int32_t *degrees, const int64_t *counts, uint32_t flags) {
    check_axes(axes);
    require(degrees, "degrees");
    require(counts, "counts");
    std::array<int64_t, max_axes> all{};
    for (int k = 0; k < axes; ++k) {
        all[static_cast<size_t>(k)] =
            decode_periodic(flags, axes, k) ? wrapped_count(degrees[k], counts[k], k) : counts[k];
    }
    return {axes, degrees, all.data(), flags};
}

int64_t unwrapped_count(const AxisData &axis) noexcept {
    return axis.periodic ? axis.count - axis.degree : axis.count;
}

int64_t unwrapped_knot_count(const AxisData &axis) noexcept {
    return axis.periodic ? unwrapped_count(axis) + 1 : axis.count + axis.degree + 1;
}

std::pair<std::vector<double>, int64_t> all_knots(const AxisData &axis, std::span<const double> given, int k,
                                                  int64_t offset) {
    if (!axis.periodic) {
        return {{given.begin(), given.end()}, offset};
    }
    refine::check_period(axis.degree, given, k, offset);
    return {refine::wrapped_knots(axis.degree, given), offset - axis.degree};
}

Spline::Axes wrapped_knot_vectors(const AxesData &axes, const double *knots, int64_t knot_count) {
    static_cast<void>(axes.knot_total(1)); // refuses counts for which the sum below would overflow
    int64_t total = 0, offset = 0;
    for (int k = 0; k < axes.size(); ++k) {
        total += unwrapped_knot_count(axes[k]);
    }
    check_size(knot_count, total, "knot_count");
    require(knots, "knots");
    return axes.make(
        [&](const AxisData &axis, int k, int64_t) {
            const int64_t first = offset, size = unwrapped_knot_count(axis);
            offset += size;
            return all_knots(axis, {knots + first, static_cast<size_t>(size)}, k, first);
        },
        1);
}

// Checks values before they are wrapped, so that indices in messages are those of the caller's arrays.
SplinePtr wrapped_spline(Spline::Axes axes, const PointsData &net, int64_t count) {
    check_dimension(net.dim);
    std::vector<double> weights;
    const ConstRecords points = input("points", net.points, count, net.dim, net.stride, net.component_stride);
    if (net.weights != nullptr) {
        weights = packed(input("weights", net.weights, count, net.weight_stride));
    }
    std::vector<double> values = packed(points);
    check_values(net.dim, values, weights);
    values = refine::wrapped(std::move(values), axes, net.dim);
    weights = refine::wrapped(std::move(weights), axes, net.weights == nullptr ? 0 : 1);
    const Form form = net.weights == nullptr ? Form::polynomial : Form::rational;
    return make_spline(std::move(axes), net.dim, form, std::move(values), std::move(weights));
}

int64_t unwrapped_total(const Spline &spline) noexcept {
    int64_t total = 1;
    for (const KnotVectorPtr &axis : spline.knot_vectors()) {
        total *= axis->distinct_layers();
    }
    return total;
}

} // namespace

nurbs_status nurbs_create_periodic(int32_t axes, const int32_t *degrees, const int64_t *counts,
                                   const double *knots, int64_t knot_count, int32_t dim, const double *points,
                                   int64_t point_stride, int64_t point_component_stride,
                                   const double *weights, int64_t weight_stride, uint32_t flags,
                                   nurbs **out) {
    return guard([&] {
        require_out(out);
        const AxesData data = wrapped_axes(axes, degrees, counts, flags);
        const PointsData net{dim, points, point_stride, point_component_stride, weights, weight_stride};
        static_cast<void>(data.point_count()); // refuses counts that no array can have
        int64_t count = 1;
        for (int k = 0; k < axes; ++k) {
            count *= unwrapped_count(data[k]);
        }
        give(wrapped_spline(wrapped_knot_vectors(data, knots, knot_count), net, count), out);
    });
}

nurbs_status nurbs_unwrapped_count(const nurbs *g, int32_t axis, int64_t *count) {
    return guard([&] {
        const Spline &spline = spline_of(g);
        check_axis(spline, axis);
        require(count, "count");
        *count = spline.axis(axis).distinct_layers();
    });
}

nurbs_status nurbs_unwrapped_knots(const nurbs *g, int32_t axis, int64_t cap, double *knots, int64_t *count) {
    return guard([&] {
        const Spline &spline = spline_of(g);
        check_axis(spline, axis);
        give_knots(refine::unwrapped_knots(spline.axis(axis)), cap, knots, count);
    });
}

nurbs_status nurbs_unwrapped_points(const nurbs *g, int64_t cap, double *points, double *weights,
                                    int64_t *count) {
    return guard([&] {
        const Spline &spline = spline_of(g);
        const int64_t total = unwrapped_total(spline), dim = spline.dim();
        const int64_t filled = checked_cap(cap, total);
        check_apart({memory("points", points, filled * dim), memory("weights", weights, filled),
                     memory("count", count, 1)},
                    {});
        if (filled > 0) {
            refine::for_each_distinct(spline, [&](int64_t i, int64_t j) {
                for (int c = 0; c < spline.dim(); ++c) {
                    put(points, static_cast<size_t>(i * dim + c), spline.coordinate(j, c));
                }
                put(weights, static_cast<size_t>(i), spline.weight(j));
            });
        }
        put(count, total);
    });
}
