// SPDX-License-Identifier: MIT
// Intersections: roots and levels of curves, hits of curves with curves and surfaces, and the common points
// of three surfaces.
#include "checks.h"
#include "guard.h"
#include "implicit_argument.h"
#include "outputs.h"

#include "base/tolerance.h"
#include "intersect/common/common_points.h"
#include "intersect/curve_level.h"
#include "intersect/curve_surface/curve_surface.h"
#include "intersect/pairs/curve_curve.h"
#include "spline/kind.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

using namespace nrb;
using namespace nrb::capi;

namespace {

// Output arrays for hits; each may be NULL.
struct HitArrays {
    double *params;
    int32_t *kinds;
    double *ranges;
    int64_t *count;
    int32_t *complete;
};

void put_hits(const intersect::CurveHits &hits, int64_t cap, const HitArrays &out,
              std::initializer_list<Memory> inputs) {
    const int64_t filled = checked_cap(cap, std::ssize(hits.list));
    check_apart({memory("params", out.params, filled), memory("kinds", out.kinds, filled),
                 memory("ranges", out.ranges, 2 * filled), memory("count", out.count, 1),
                 memory("complete", out.complete, 1)},
                inputs);
    for (size_t i = 0; std::cmp_less(i, filled); ++i) {
        const intersect::CurveHit &hit = hits.list[i];
        put(out.params, i, hit.at);
        put(out.kinds, i, static_cast<int32_t>(hit.kind));
        put(out.ranges, 2 * i, hit.range.lower);
        put(out.ranges, 2 * i + 1, hit.range.upper);
    }
    put(out.count, int64_t{std::ssize(hits.list)});
    put(out.complete, int32_t{hits.complete()});
}

struct PairArrays {
    double *params_a, *params_b;
    int32_t *kinds;
    double *ranges_a, *ranges_b;
    int64_t *count;
    int32_t *complete;
};

void put_hits(const intersect::PairHits &hits, int64_t cap, const PairArrays &out) {
    const int64_t filled = checked_cap(cap, std::ssize(hits.list));
    check_apart({memory("params_a", out.params_a, filled), memory("params_b", out.params_b, filled),
                 memory("kinds", out.kinds, filled), memory("ranges_a", out.ranges_a, 2 * filled),
                 memory("ranges_b", out.ranges_b, 2 * filled), memory("count", out.count, 1),
                 memory("complete", out.complete, 1)},
                {});
    for (size_t i = 0; std::cmp_less(i, filled); ++i) {
        const intersect::PairHit &hit = hits.list[i];
        put(out.params_a, i, hit.a);
        put(out.params_b, i, hit.b);
        put(out.kinds, i, static_cast<int32_t>(hit.kind));
        put(out.ranges_a, 2 * i, hit.range_a.lower);
        put(out.ranges_a, 2 * i + 1, hit.range_a.upper);
        put(out.ranges_b, 2 * i, hit.from_b);
        put(out.ranges_b, 2 * i + 1, hit.to_b);
    }
    put(out.count, int64_t{std::ssize(hits.list)});
    put(out.complete, int32_t{hits.complete});
}

struct SurfaceArrays {
    double *params_curve, *params_surface;
    int32_t *kinds;
    double *ranges_curve, *ranges_surface;
    int64_t *count;
    int32_t *complete;
};

void put_hits(const intersect::SurfaceHits &hits, int64_t cap, const SurfaceArrays &out) {
    const int64_t filled = checked_cap(cap, std::ssize(hits.list));
    check_apart({memory("params_curve", out.params_curve, filled),
                 memory("params_surface", out.params_surface, 2 * filled), memory("kinds", out.kinds, filled),
                 memory("ranges_curve", out.ranges_curve, 2 * filled),
                 memory("ranges_surface", out.ranges_surface, 4 * filled), memory("count", out.count, 1),
                 memory("complete", out.complete, 1)},
                {});
    for (size_t i = 0; std::cmp_less(i, filled); ++i) {
        const intersect::SurfaceHit &hit = hits.list[i];
        put(out.params_curve, i, hit.at[0]);
        put(out.kinds, i, static_cast<int32_t>(hit.kind));
        put(out.ranges_curve, 2 * i, hit.range[0].lower);
        put(out.ranges_curve, 2 * i + 1, hit.range[0].upper);
        for (size_t k = 0; k < 2; ++k) {
            put(out.params_surface, 2 * i + k, hit.at[k + 1]);
            put(out.ranges_surface, 4 * i + 2 * k, hit.range[k + 1].lower);
            put(out.ranges_surface, 4 * i + 2 * k + 1, hit.range[k + 1].upper);
        }
    }
    put(out.count, int64_t{std::ssize(hits.list)});
    put(out.complete, int32_t{hits.complete});
}

struct TripleArrays {
    double *params, *points;
    int32_t *kinds;
    double *ranges;
    int64_t *count;
    int32_t *complete;
};

void put_points(const intersect::CommonPoints &found, int64_t cap, const TripleArrays &out) {
    const int64_t filled = checked_cap(cap, std::ssize(found.list));
    check_apart({memory("params", out.params, 6 * filled), memory("points", out.points, 3 * filled),
                 memory("kinds", out.kinds, filled), memory("ranges", out.ranges, 12 * filled),
                 memory("count", out.count, 1), memory("complete", out.complete, 1)},
                {});
    for (size_t i = 0; std::cmp_less(i, filled); ++i) {
        const intersect::CommonPoint &x = found.list[i];
        put(out.kinds, i, static_cast<int32_t>(x.kind));
        for (size_t k = 0; k < 6; ++k) {
            put(out.params, 6 * i + k, x.at[k]);
            put(out.ranges, 12 * i + 2 * k, x.range[k].lower);
            put(out.ranges, 12 * i + 2 * k + 1, x.range[k].upper);
        }
        for (size_t c = 0; c < 3; ++c) {
            put(out.points, 3 * i + c, x.point[c]);
        }
    }
    put(out.count, int64_t{std::ssize(found.list)});
    put(out.complete, int32_t{found.complete()});
}

} // namespace

nurbs_status nurbs_roots(const nurbs *g, double value, double tolerance, int64_t cap, double *params,
                         int32_t *kinds, double *ranges, int64_t *count, int32_t *complete) {
    return guard([&] {
        const Spline &curve = curve_of(g);
        check_dimension(curve, 1, 1);
        if (!std::isfinite(value)) {
            fail(Status::point_not_finite, "value = %s, expected a finite value", Number(value).text);
        }
        check_tolerance(tolerance);
        check_length(cap, "cap");
        const std::array<double, 2> form{1, -value};
        put_hits(intersect::curve_level(curve, {1, 1, form}, tolerance), cap,
                 {params, kinds, ranges, count, complete}, {});
    });
}

nurbs_status nurbs_curve_level(const nurbs *g, int32_t degree, const double *coefficients, double tolerance,
                               int64_t cap, double *params, int32_t *kinds, double *ranges, int64_t *count,
                               int32_t *complete) {
    return guard([&] {
        const Spline &curve = curve_of(g);
        const intersect::ImplicitForm form = checked_form(curve.dim(), degree, coefficients);
        check_tolerance(tolerance);
        check_length(cap, "cap");
        put_hits(intersect::curve_level(curve, form, tolerance), cap,
                 {params, kinds, ranges, count, complete},
                 {memory("coefficients", coefficients, std::ssize(form.coefficients()))});
    });
}

nurbs_status nurbs_curve_intersections(const nurbs *a, const nurbs *b, double tolerance, int64_t cap,
                                       double *params_a, double *params_b, int32_t *kinds, double *ranges_a,
                                       double *ranges_b, int64_t *count, int32_t *complete) {
    return guard([&] {
        const Spline &first = named(a, "a"), &second = named(b, "b");
        check_kind(first, 1, "a");
        check_kind(second, 1, "b");
        check_tolerance(tolerance);
        check_length(cap, "cap");
        if (&first == &second) {
            fail(Status::same, "a and b are one curve, whose meets with itself are another question");
        }
        put_hits(intersect::curve_curve(first, second, tolerance), cap,
                 {params_a, params_b, kinds, ranges_a, ranges_b, count, complete});
    });
}

nurbs_status nurbs_curve_self_intersections(const nurbs *g, double tolerance, int64_t cap, double *params_a,
                                            double *params_b, int32_t *kinds, double *ranges_a,
                                            double *ranges_b, int64_t *count, int32_t *complete) {
    return guard([&] {
        const Spline &curve = curve_of(g);
        check_tolerance(tolerance);
        check_length(cap, "cap");
        put_hits(intersect::curve_itself(curve, tolerance), cap,
                 {params_a, params_b, kinds, ranges_a, ranges_b, count, complete});
    });
}

nurbs_status nurbs_curve_surface_intersections(const nurbs *curve, const nurbs *surface, double tolerance,
                                               int64_t cap, double *params_curve, double *params_surface,
                                               int32_t *kinds, double *ranges_curve, double *ranges_surface,
                                               int64_t *count, int32_t *complete) {
    return guard([&] {
        const Spline &first = named(curve, "curve"), &second = named(surface, "surface");
        check_kind(first, 1, "curve");
        check_kind(second, 2, "surface");
        check_tolerance(tolerance);
        check_length(cap, "cap");
        put_hits(intersect::curve_surface(first, second, tolerance), cap,
                 {params_curve, params_surface, kinds, ranges_curve, ranges_surface, count, complete});
    });
}

nurbs_status nurbs_surfaces_common_points(const nurbs *a, const nurbs *b, const nurbs *c, double tolerance,
                                          int64_t cap, double *params, double *points, int32_t *kinds,
                                          double *ranges, int64_t *count, int32_t *complete) {
    return guard([&] {
        const std::array<const Spline *, 3> surfaces{&named(a, "a"), &named(b, "b"), &named(c, "c")};
        for (size_t s = 0; s < 3; ++s) {
            check_kind(*surfaces[s], 2, std::array{"a", "b", "c"}[s]);
            check_dimension(*surfaces[s], 3, 3);
        }
        check_tolerance(tolerance);
        check_length(cap, "cap");
        put_points(intersect::common_points(surfaces, tolerance), cap,
                   {params, points, kinds, ranges, count, complete});
    });
}
