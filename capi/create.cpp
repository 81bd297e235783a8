// SPDX-License-Identifier: MIT
// Construction of handles.
#include "checks.h"
#include "guard.h"

#include "base/checked.h"
#include "spline_data.h"

#include <algorithm>
#include <cmath>

namespace {

using namespace nrb;
using namespace nrb::capi;

void check_short_degrees(const AxesData &axes) {
    for (int k = 0; k < axes.size(); ++k) {
        if (axes[k].degree < 1) {
            fail(Status::degree, "degrees[%d] = %d, expected 1 to %d with short knot vectors", k,
                 axes[k].degree, NURBS_MAX_DEGREE);
        }
    }
}

// The full vector repeats the end knots of a short one once more. An end knot that already occurs degree + 1
// times, or is not finite, is refused here, so that the message names the short vector.
void check_short_end(const double *given, int64_t end, int64_t inner, int degree, int64_t offset) {
    const long long at = offset + end;
    if (!std::isfinite(given[end])) {
        fail(Status::knot_not_finite, "knots[%lld] = %s is not finite", at, Number(given[end]).text);
    }
    if (given[end] == given[inner]) {
        fail(Status::end_multiplicity,
             "knots[%lld] = %s is the same knot as knots[%lld]; degree %d allows %d equal knots at the end "
             "of a short "
             "vector",
             at, Number(given[end]).text, static_cast<long long>(offset) + inner, degree, degree);
    }
}

// The full knots of an axis, from a short vector: one without the first and the last knot, which influence
// nothing inside the domain. These two become copies of the knots next to them. On a periodic axis they are
// the knots one period away, where those lie farther out.
std::vector<double> complete_knots(const AxisData &axis, const double *given, int64_t offset) {
    const int64_t last = axis.count + axis.degree - 2;
    std::vector<double> knots(static_cast<size_t>(last) + 3);
    std::copy_n(given, last + 1, knots.begin() + 1);
    knots.front() = given[0];
    knots.back() = given[last];
    if (axis.periodic) {
        const auto p = static_cast<size_t>(axis.degree);
        const auto count = static_cast<size_t>(axis.count);
        const double period = knots[count] - knots[p];
        knots.front() = std::min(knots.front(), knots[count - p] - period);
        knots.back() = std::max(knots.back(), knots[2 * p] + period);
    } else if (given[axis.degree - 1] !=
               given[axis.count - 1]) { // otherwise the domain is empty, which is reported later
        check_short_end(given, 0, axis.degree, axis.degree, offset);
        check_short_end(given, last, last - axis.degree, axis.degree, offset);
    }
    return knots;
}

// Checks the distinct knots of an axis and returns the sum of their multiplicities. `offset`: where the axis
// begins in the caller's arrays, for messages.
int64_t check_distinct_knots(const AxisData &axis, const double *distinct, const int32_t *multiplicities,
                             int64_t n, int64_t offset) {
    int64_t total = 0;
    for (int64_t i = 0; i < n; ++i) {
        const long long at = offset + i;
        if (multiplicities[i] < 1) {
            fail(Status::count, "multiplicities[%lld] = %d, expected at least 1", at, multiplicities[i]);
        }
        if (multiplicities[i] > axis.degree + 1) {
            const bool end = i == 0 || i + 1 == n;
            fail(end ? Status::end_multiplicity : Status::multiplicity,
                 "multiplicities[%lld] = %d, degree %d allows at most %d", at, multiplicities[i], axis.degree,
                 axis.degree + 1);
        }
        if (!std::isfinite(distinct[i])) {
            fail(Status::knot_not_finite, "distinct_knots[%lld] = %s is not finite", at,
                 Number(distinct[i]).text);
        }
        if (i > 0 && distinct[i] <= distinct[i - 1]) {
            fail(Status::knots_decreasing, "distinct_knots[%lld] = %s, expected more than %s before it", at,
                 Number(distinct[i]).text, Number(distinct[i - 1]).text);
        }
        total += multiplicities[i];
    }
    return total;
}

std::vector<double> expand_knots(const AxisData &axis, const double *distinct, const int32_t *multiplicities,
                                 int64_t n, int index, int64_t offset) {
    const int64_t total = check_distinct_knots(axis, distinct, multiplicities, n, offset);
    if (total != axis.count + axis.degree + 1) {
        fail(Status::size,
             "multiplicities of axis %d add up to %lld, expected counts[%d] + degrees[%d] + 1 = %lld", index,
             static_cast<long long>(total), index, index,
             static_cast<long long>(axis.count) + axis.degree + 1);
    }
    std::vector<double> knots;
    knots.reserve(static_cast<size_t>(total));
    for (int64_t i = 0; i < n; ++i) {
        knots.insert(knots.end(), static_cast<size_t>(multiplicities[i]), distinct[i]);
    }
    return knots;
}

Spline::Axes short_axes(const AxesData &axes, const double *knots, int64_t knot_count) {
    check_short_degrees(axes);
    check_size(knot_count, axes.knot_total(-1), "knot_count");
    require(knots, "knots");
    return axes.make(
        [&](const AxisData &axis, int, int64_t offset) {
            return std::pair(complete_knots(axis, knots + offset, offset), offset - 1);
        },
        -1);
}

Spline::Axes multiplicity_axes(const AxesData &axes, const int64_t *distinct_counts,
                               const double *distinct_knots, const int32_t *multiplicities) {
    require(distinct_counts, "distinct_counts");
    require(distinct_knots, "distinct_knots");
    require(multiplicities, "multiplicities");
    static_cast<void>(axes.knot_total(1)); // refuses counts so large that the sums below would overflow
    for (int k = 0; k < axes.size(); ++k) {
        if (distinct_counts[k] < 2 || distinct_counts[k] > axes[k].count + axes[k].degree + 1) {
            fail(distinct_counts[k] < 2 ? Status::count : Status::size,
                 "distinct_counts[%d] = %lld, expected 2 to counts[%d] + degrees[%d] + 1 = %lld", k,
                 static_cast<long long>(distinct_counts[k]), k, k,
                 static_cast<long long>(axes[k].count) + axes[k].degree + 1);
        }
    }
    int64_t offset = 0;
    return axes.make(
        [&](const AxisData &axis, int index, int64_t full_offset) {
            std::vector<double> knots = expand_knots(axis, distinct_knots + offset, multiplicities + offset,
                                                     distinct_counts[index], index, offset);
            offset += distinct_counts[index];
            return std::pair(std::move(knots), full_offset);
        },
        1);
}

Spline::Axes bezier_axes(const AxesData &axes) {
    return axes.make(
        [](const AxisData &axis, int, int64_t offset) {
            std::vector<double> knots(static_cast<size_t>(axis.degree) + 1, 0.0);
            knots.insert(knots.end(), static_cast<size_t>(axis.degree) + 1, 1.0);
            return std::pair(std::move(knots), offset);
        },
        1);
}

// The weights that a spline keeps with other points; none if it is polynomial. A homogeneous spline keeps its
// weights, too, but then becomes one of Cartesian points and weights.
std::vector<double> kept_weights(const Spline &spline) {
    std::vector<double> weights(spline.rational() ? static_cast<size_t>(spline.point_count()) : 0);
    for (size_t i = 0; i < weights.size(); ++i) {
        weights[i] = spline.weight(static_cast<int64_t>(i));
    }
    return weights;
}

} // namespace

nurbs_status nurbs_create(int32_t axes, const int32_t *degrees, const int64_t *counts, const double *knots,
                          int64_t knot_count, int32_t dim, const double *points, int64_t point_stride,
                          int64_t point_component_stride, const double *weights, int64_t weight_stride,
                          uint32_t flags, nurbs **out) {
    return guard([&] {
        require_out(out);
        const AxesData data(axes, degrees, counts, flags);
        const PointsData net{dim, points, point_stride, point_component_stride, weights, weight_stride};
        const int64_t count =
            data.point_count(); // refuses counts that no array can have, before knots are read
        give(net.make(data.with_knots(knots, knot_count), count), out);
    });
}

nurbs_status nurbs_create_homogeneous(int32_t axes, const int32_t *degrees, const int64_t *counts,
                                      const double *knots, int64_t knot_count, int32_t dim,
                                      const double *points, int64_t point_stride,
                                      int64_t point_component_stride, uint32_t flags, nurbs **out) {
    return guard([&] {
        require_out(out);
        const AxesData data(axes, degrees, counts, flags);
        const PointsData net{dim, points, point_stride, point_component_stride, nullptr, 0};
        const int64_t count = data.point_count();
        give(net.make_homogeneous(data.with_knots(knots, knot_count), count), out);
    });
}

nurbs_status nurbs_create_short(int32_t axes, const int32_t *degrees, const int64_t *counts,
                                const double *knots, int64_t knot_count, int32_t dim, const double *points,
                                int64_t point_stride, int64_t point_component_stride, const double *weights,
                                int64_t weight_stride, uint32_t flags, nurbs **out) {
    return guard([&] {
        require_out(out);
        const AxesData data(axes, degrees, counts, flags);
        const PointsData net{dim, points, point_stride, point_component_stride, weights, weight_stride};
        const int64_t count = data.point_count();
        give(net.make(short_axes(data, knots, knot_count), count), out);
    });
}

nurbs_status nurbs_create_multiplicities(int32_t axes, const int32_t *degrees, const int64_t *counts,
                                         const int64_t *distinct_counts, const double *distinct_knots,
                                         const int32_t *multiplicities, int32_t dim, const double *points,
                                         int64_t point_stride, int64_t point_component_stride,
                                         const double *weights, int64_t weight_stride, uint32_t flags,
                                         nurbs **out) {
    return guard([&] {
        require_out(out);
        const AxesData data(axes, degrees, counts, flags);
        const PointsData net{dim, points, point_stride, point_component_stride, weights, weight_stride};
        const int64_t count = data.point_count();
        give(net.make(multiplicity_axes(data, distinct_counts, distinct_knots, multiplicities), count), out);
    });
}

nurbs_status nurbs_create_bezier(int32_t axes, const int32_t *degrees, int32_t dim, const double *points,
                                 int64_t point_stride, int64_t point_component_stride, const double *weights,
                                 int64_t weight_stride, nurbs **out) {
    return guard([&] {
        require_out(out);
        const AxesData data(axes, degrees);
        const PointsData net{dim, points, point_stride, point_component_stride, weights, weight_stride};
        give(net.make(bezier_axes(data), data.point_count()), out);
    });
}

nurbs_status nurbs_with_points(const nurbs *g, const double *points, int64_t point_stride,
                               int64_t point_component_stride, const double *weights, int64_t weight_stride,
                               nurbs **out) {
    return guard([&] {
        require_out(out);
        const Spline &spline = spline_of(g);
        const PointsData net{spline.dim(),           points,  point_stride,
                             point_component_stride, weights, weight_stride};
        std::vector<double> kept = weights == nullptr ? kept_weights(spline) : std::vector<double>();
        give(net.make(spline.knot_vectors(), spline.point_count(), std::move(kept)), out);
    });
}

nurbs_status nurbs_clone(const nurbs *g, nurbs **out) {
    return guard([&] {
        require_out(out);
        require(g, "g");
        give(g->spline, out);
    });
}

void nurbs_destroy(nurbs *g) {
    delete g;
}
