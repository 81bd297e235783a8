// SPDX-License-Identifier: MIT
// Getters, all of which copy what they return, and local hull sizes.
#include "batch.h"
#include "guard.h"
#include "outputs.h"

#include "eval/active.h"

#include <algorithm>
#include <utility>

using namespace nrb;
using namespace nrb::capi;

namespace {

const KnotVector &axis_of(const nurbs *g, int32_t axis) {
    const Spline &spline = spline_of(g);
    check_axis(spline, axis);
    return spline.axis(axis);
}

template <class T>
void store(T value, T *target, const char *name) {
    require(target, name);
    *target = value;
}

} // namespace

nurbs_status nurbs_axes(const nurbs *g, int32_t *axes) {
    return guard([&] { store(spline_of(g).axes(), axes, "axes"); });
}

nurbs_status nurbs_dimension(const nurbs *g, int32_t *dim) {
    return guard([&] { store(spline_of(g).dim(), dim, "dim"); });
}

nurbs_status nurbs_degree(const nurbs *g, int32_t axis, int32_t *degree) {
    return guard([&] { store(axis_of(g, axis).degree(), degree, "degree"); });
}

nurbs_status nurbs_count(const nurbs *g, int32_t axis, int64_t *count) {
    return guard([&] { store(axis_of(g, axis).count(), count, "count"); });
}

nurbs_status nurbs_point_count(const nurbs *g, int64_t *count) {
    return guard([&] { store(spline_of(g).point_count(), count, "count"); });
}

nurbs_status nurbs_is_rational(const nurbs *g, int32_t *rational) {
    return guard([&] { store(int32_t{spline_of(g).rational()}, rational, "rational"); });
}

nurbs_status nurbs_is_homogeneous(const nurbs *g, int32_t *homogeneous) {
    return guard(
        [&] { store(int32_t{spline_of(g).form() == Form::homogeneous}, homogeneous, "homogeneous"); });
}

nurbs_status nurbs_knots(const nurbs *g, int32_t axis, int64_t knot_count, double *knots) {
    return guard([&] {
        const std::span<const double> stored = axis_of(g, axis).knots();
        check_size(knot_count, static_cast<int64_t>(stored.size()), "knot_count");
        require(knots, "knots");
        std::copy(stored.begin(), stored.end(), knots);
    });
}

nurbs_status nurbs_short_knots(const nurbs *g, int32_t axis, int64_t cap, double *knots, int64_t *count) {
    return guard([&] {
        const KnotVector &own = axis_of(g, axis);
        if (own.degree() < 1) {
            fail(Status::degree, "axis %d has degree 0, expected at least 1 for a short knot vector", axis);
        }
        give_knots(own.knots().subspan(1, own.knots().size() - 2), cap, knots, count);
    });
}

nurbs_status nurbs_distinct_knots(const nurbs *g, int32_t axis, int64_t cap, double *knots,
                                  int32_t *multiplicities, int64_t *count) {
    return guard([&] {
        require(count, "count");
        check_length(cap, "cap");
        const std::vector<KnotGroup> groups = distinct_knots(axis_of(g, axis).knots());
        const auto needed = static_cast<int64_t>(groups.size());
        const int64_t filled = checked_cap(cap, needed);
        check_apart({memory("knots", knots, filled), memory("multiplicities", multiplicities, filled),
                     memory("count", count, 1)},
                    {});
        for (size_t i = 0; std::cmp_less(i, filled); ++i) {
            put(knots, i, groups[i].knot);
            put(multiplicities, i, int32_t{groups[i].multiplicity});
        }
        *count = needed;
    });
}

nurbs_status nurbs_knot_form(const nurbs *g, int32_t axis, int32_t *form) {
    return guard([&] {
        const KnotVector &knots = axis_of(g, axis);
        const int32_t bits = (knots.clamped_start() ? NURBS_FORM_CLAMPED_START : 0) |
                             (knots.clamped_end() ? NURBS_FORM_CLAMPED_END : 0) |
                             (knots.periodic() ? NURBS_FORM_PERIODIC : 0);
        store(bits, form, "form");
    });
}

nurbs_status nurbs_domain(const nurbs *g, int32_t axis, double *domain) {
    return guard([&] {
        const Interval interval = axis_of(g, axis).domain();
        require(domain, "domain");
        domain[0] = interval.lower;
        domain[1] = interval.upper;
    });
}

nurbs_status nurbs_greville(const nurbs *g, int32_t axis, int64_t count, double *abscissae) {
    return guard([&] {
        const KnotVector &knots = axis_of(g, axis);
        check_size(count, knots.count(), "count");
        require(abscissae, "abscissae");
        for (int64_t i = 0; i < count; ++i) {
            abscissae[i] = greville(knots, i);
        }
    });
}

nurbs_status nurbs_points(const nurbs *g, int64_t count, double *points, int64_t point_stride,
                          int64_t point_component_stride) {
    return guard([&] {
        const Spline &spline = spline_of(g);
        check_size(count, spline.point_count(), "count");
        const Records out =
            output("points", points, count, spline.dim(), point_stride, point_component_stride);
        for (int64_t i = 0; i < count; ++i) {
            for (int c = 0; c < spline.dim(); ++c) {
                out(i, c) = spline.coordinate(i, c);
            }
        }
    });
}

nurbs_status nurbs_weights(const nurbs *g, int64_t count, double *weights, int64_t weight_stride) {
    return guard([&] {
        const Spline &spline = spline_of(g);
        check_size(count, spline.point_count(), "count");
        const Records out = output("weights", weights, count, 1, weight_stride, 0);
        for (int64_t i = 0; i < count; ++i) {
            out(i, 0) = spline.weight(i);
        }
    });
}

nurbs_status nurbs_homogeneous_points(const nurbs *g, int64_t count, double *points, int64_t point_stride,
                                      int64_t point_component_stride) {
    return guard([&] {
        const Spline &spline = spline_of(g);
        check_size(count, spline.point_count(), "count");
        const int dim = spline.dim();
        const Records out =
            output("points", points, count, int64_t{dim} + 1, point_stride, point_component_stride);
        const bool stored = spline.form() == Form::homogeneous;
        for (int64_t i = 0; i < count; ++i) {
            for (int c = 0; c < dim; ++c) {
                out(i, c) = stored ? spline.points()[static_cast<size_t>(i * (dim + 1) + c)]
                                   : spline.weight(i) * spline.coordinate(i, c);
            }
            out(i, dim) = spline.weight(i);
        }
    });
}

nurbs_status nurbs_hull_size(const nurbs *g, int64_t n, const double *params, int64_t param_stride,
                             int64_t param_component_stride, double *sizes, int64_t size_stride,
                             uint32_t flags) {
    return guard([&] {
        const SplineBatch batch = spline_batch(g, n, params, param_stride, param_component_stride, flags);
        const Records out = output("sizes", sizes, n, 1, size_stride, 0);
        check_overlap("sizes", out, "params", batch.params);
        check_values(batch);
        eval::hull_sizes(batch.spline, batch.rules, batch.params, out);
    });
}
