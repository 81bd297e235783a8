// SPDX-License-Identifier: MIT
#include "refine/knots/axis_table.h"

#include "base/watch.h"
#include "refine/knots/batched_blossoms.h"
#include "refine/periodic/periodic.h"

#include <algorithm>
#include <iterator>

namespace nrb::refine {

LayerTable rows_of(const Refinement &refinement, int64_t first, int64_t end) {
    constexpr int64_t rows_between_counts = 256;
    constexpr int64_t most_alike = 8192;    // made without counting work between
    constexpr int64_t many = row_lanes / 2; // from this many alike rows on it pays
    const int degree = refinement.width() - 1;
    LayerTable table;
    table.reserve(end - first, refinement.width(), row_lanes);
    BatchedBlossoms batches(degree);
    double room[max_basis];
    for (int64_t j = first; j < end; ++j) {
        if ((j - first) % rows_between_counts == 0) {
            count_work(rows_between_counts * refinement.width() * refinement.width());
        }
        if (j > first && refinement.repeats(j)) {
            table.repeat_row();
            continue;
        }
        const auto [layer, steps, left, right, arguments] = refinement.blossom(j, room);
        if (steps == 0) {
            table.add_copy(layer);
            continue;
        }
        const int64_t alike = steps == degree ? refinement.alike(j, std::min(end, j + most_alike)) : 1;
        if (alike >= many) {
            count_work(alike * refinement.width() * refinement.width());
            sliding_blossom_rows(degree, left, right, arguments, alike, table.room(0));
            const LayerTable::Row row{layer, degree + 1, 0};
            table.add_pattern({&row, 1}, alike, 0, degree + 1);
            j += alike - 1;
        } else {
            batches.add(steps, left, right, arguments, table.add_later(layer, steps + 1));
        }
    }
    batches.finish();
    return table;
}

LayerTable rows_over(const KnotVector &axis, std::span<const double> fine) {
    const Refinement refinement(axis.degree(), axis.knots(), fine);
    return rows_of(refinement, 0, refinement.rows());
}

std::vector<double> merged(std::span<const double> knots, std::span<const double> more) {
    std::vector<double> result;
    result.reserve(knots.size() + more.size());
    std::merge(knots.begin(), knots.end(), more.begin(), more.end(), std::back_inserter(result));
    return result;
}

AxisTable refine_axis(const KnotVector &axis, std::span<const double> knots) {
    if (axis.periodic()) {
        return refine_periodic(axis, knots);
    }
    std::vector<double> fine = merged(axis.knots(), knots);
    LayerTable table = rows_over(axis, fine);
    return {std::make_shared<const KnotVector>(axis.degree(), std::move(fine)), std::move(table)};
}

Spline::Axes with_axis(const Spline &spline, int k, KnotVectorPtr axis) {
    Spline::Axes axes = spline.knot_vectors();
    axes[static_cast<size_t>(k)] = std::move(axis);
    return axes;
}

SplinePtr with_axis(const Spline &spline, int k, const AxisTable &made) {
    Net net = apply_along(spline, k, made.table);
    return make_result(with_axis(spline, k, made.axis), spline.dim(), spline.form(), std::move(net.points),
                       std::move(net.weights));
}

SplinePtr with_axis(const Spline &spline, int k, KnotVectorPtr axis, int64_t unit, const RowSource &rows) {
    constexpr int64_t few = 512; // rows whose table fits into the cache
    const int64_t count = axis->count();
    LayerMaker maker(spline, k, count);
    const int64_t part = maker.in_parts() ? std::max(few / unit, int64_t{1}) * unit : count;
    for (int64_t first = 0; first < count; first += part) {
        maker.append(rows(first, std::min(first + part, count)));
    }
    Net net = maker.finish();
    return make_result(with_axis(spline, k, std::move(axis)), spline.dim(), spline.form(),
                       std::move(net.points), std::move(net.weights));
}

} // namespace nrb::refine
