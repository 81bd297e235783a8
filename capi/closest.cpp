// SPDX-License-Identifier: MIT
// Closest and farthest points, critical points of the distance, and signed distances.
#include "checks.h"
#include "guard.h"
#include "outputs.h"
#include "part.h"
#include "watched.h"

#include "base/tolerance.h"
#include "closest/closest.h"
#include "closest/signed_distance.h"
#include "spline/kind.h"

#include <cmath>
#include <cstdio>
#include <utility>

using namespace nrb;
using namespace nrb::capi;

namespace {

bool check_flag(uint32_t flags) {
    if ((flags & ~NURBS_NAN_POINTS) != 0) {
        fail(Status::flags, "flags = 0x%08x, expected NURBS_NAN_POINTS or 0", flags);
    }
    return flags != 0;
}

void check_guesses(const Spline &spline, const ConstRecords &guesses) {
    for (int64_t i = 0; i < guesses.count; ++i) {
        for (int k = 0; k < spline.axes(); ++k) {
            char name[48];
            std::snprintf(name, sizeof name, "guesses[%lld]", static_cast<long long>(i));
            check_place(guesses(i, k), spline.axis(k).domain(), name, k);
        }
    }
}

// The arguments that all batches of query points share.
struct PointBatch {
    const Spline &spline;
    ConstRecords points;
    bool allow_nan;

    void check_values() const {
        if (!allow_nan) {
            check_points("points", points);
        }
    }
};

PointBatch point_batch(const nurbs *g, int64_t n, const double *points, int64_t stride,
                       int64_t component_stride, uint32_t flags) {
    const Spline &spline = spline_of(g);
    const bool allow_nan = check_flag(flags);
    check_length(n, "n");
    return {spline, input("points", points, n, spline.dim(), stride, component_stride), allow_nan};
}

// The output arrays of a batch.
struct FeetArrays {
    FeetArrays(const PointBatch &batch, const Wanted &params, const Wanted &wanted_feet,
               const Wanted &distances, int32_t *status)
        : outputs(batch.points.count, status), feet{outputs.add(params), outputs.add(wanted_feet),
                                                    outputs.add(distances), status} {
        outputs.check("points", batch.points);
    }

    // Calls fill(outputs), which writes results as it finds them, and commits them.
    template <class Fill>
    void fill(Fill &&fill) const {
        const StagedRecords params(feet.params), points(feet.feet), distances(feet.distances);
        StagedStatus status(feet.status, feet.params.count);
        fill(closest::FeetOutputs{params.view(), points.view(), distances.view(), status.data()});
        params.commit();
        points.commit();
        distances.commit();
        status.commit();
    }

    Outputs outputs;
    closest::FeetOutputs feet;
};

void extremal_points(const PointBatch &batch, const double *range, double tolerance, int64_t budget,
                     bool farthest, const FeetArrays &arrays) {
    check_tolerance(tolerance);
    const Part part = checked_part(batch.spline, range);
    const closest::Query query{nullptr, range == nullptr ? nullptr : part.data(), tolerance,
                               checked_budget(budget, closest::usual_budget(batch.spline)), farthest};
    arrays.outputs.check(memory("range", range, 2 * int64_t{batch.spline.axes()}));
    batch.check_values();
    arrays.fill([&](const closest::FeetOutputs &out) {
        closest::closest_points(batch.spline, batch.points, query, out);
    });
}

// A query for a single point.
struct PointQuery {
    PointQuery(const nurbs *g, const double *point, const double *range_values, double tolerance,
               int64_t budget)
        : spline(spline_of(g)), range(range_values) {
        require(point, "point");
        part = checked_part(spline, range);
        check_tolerance(tolerance);
        query = {point, range == nullptr ? nullptr : part.data(), tolerance,
                 checked_budget(budget, pieces::default_budget)};
    }
    [[nodiscard]] const closest::Locator &locator() const { return closest::locator_of(spline); }

    const Spline &spline;
    const double *range;
    Part part;
    closest::Query query{};
};

struct CriticalOutputs {
    int64_t cap;
    double *params;
    double *distances;
    int32_t *kinds;
    int64_t *count;
    int32_t *status;

    void check(const PointQuery &query) const {
        check_length(cap, "cap");
        check_points("point", {query.query.point, 1, query.spline.dim(), query.spline.dim(), 1});
    }
    void write(const PointQuery &query, const closest::CriticalSet &found) const {
        const int64_t filled = checked_cap(cap, std::ssize(found.points)), dim = query.spline.dim();
        const auto axes = static_cast<size_t>(query.spline.axes());
        check_apart({memory("params", params, filled * query.spline.axes()),
                     memory("distances", distances, filled), memory("kinds", kinds, filled),
                     memory("count", count, 1), memory("status", status, 1)},
                    {memory("point", query.query.point, dim),
                     memory("range", query.range, 2 * int64_t{query.spline.axes()})});
        for (size_t i = 0; std::cmp_less(i, filled); ++i) {
            const closest::CriticalPoint &one = found.points[i];
            for (size_t k = 0; k < axes; ++k) {
                put(params, i * axes + k, one.foot.params[k]);
            }
            put(distances, i, one.foot.distance);
            put(kinds, i, one.kind);
        }
        put(count, int64_t{std::ssize(found.points)});
        put(status, found.status);
    }
};

nurbs_status extremal_points(bool farthest, const nurbs *g, int64_t n, const double *points,
                             int64_t point_stride, int64_t point_component_stride, const double *range,
                             double tolerance, int64_t budget, double *params, int64_t param_stride,
                             int64_t param_component_stride, double *feet, int64_t foot_stride,
                             int64_t foot_component_stride, double *distances, int64_t distance_stride,
                             int32_t *status, uint32_t flags) {
    return guard([&] {
        const PointBatch batch = point_batch(g, n, points, point_stride, point_component_stride, flags);
        const FeetArrays arrays(batch,
                                {"params", params, batch.spline.axes(), param_stride, param_component_stride},
                                {"feet", feet, batch.spline.dim(), foot_stride, foot_component_stride},
                                {"distances", distances, 1, distance_stride, 0}, status);
        extremal_points(batch, range, tolerance, budget, farthest, arrays);
    });
}

} // namespace

nurbs_status nurbs_closest_points(const nurbs *g, int64_t n, const double *points, int64_t point_stride,
                                  int64_t point_component_stride, const double *range, double tolerance,
                                  int64_t budget, double *params, int64_t param_stride,
                                  int64_t param_component_stride, double *feet, int64_t foot_stride,
                                  int64_t foot_component_stride, double *distances, int64_t distance_stride,
                                  int32_t *status, uint32_t flags) {
    return extremal_points(false, g, n, points, point_stride, point_component_stride, range, tolerance,
                           budget, params, param_stride, param_component_stride, feet, foot_stride,
                           foot_component_stride, distances, distance_stride, status, flags);
}

nurbs_status nurbs_farthest_points(const nurbs *g, int64_t n, const double *points, int64_t point_stride,
                                   int64_t point_component_stride, const double *range, double tolerance,
                                   int64_t budget, double *params, int64_t param_stride,
                                   int64_t param_component_stride, double *feet, int64_t foot_stride,
                                   int64_t foot_component_stride, double *distances, int64_t distance_stride,
                                   int32_t *status, uint32_t flags) {
    return extremal_points(true, g, n, points, point_stride, point_component_stride, range, tolerance, budget,
                           params, param_stride, param_component_stride, feet, foot_stride,
                           foot_component_stride, distances, distance_stride, status, flags);
}

nurbs_status nurbs_closest_local(const nurbs *g, int64_t n, const double *points, int64_t point_stride,
                                 int64_t point_component_stride, const double *guesses, int64_t guess_stride,
                                 int64_t guess_component_stride, double *params, int64_t param_stride,
                                 int64_t param_component_stride, double *feet, int64_t foot_stride,
                                 int64_t foot_component_stride, double *distances, int64_t distance_stride,
                                 int32_t *status, uint32_t flags) {
    return guard([&] {
        const PointBatch batch = point_batch(g, n, points, point_stride, point_component_stride, flags);
        const ConstRecords starts =
            input("guesses", guesses, n, batch.spline.axes(), guess_stride, guess_component_stride);
        const FeetArrays arrays(batch,
                                {"params", params, batch.spline.axes(), param_stride, param_component_stride},
                                {"feet", feet, batch.spline.dim(), foot_stride, foot_component_stride},
                                {"distances", distances, 1, distance_stride, 0}, status);
        arrays.outputs.check("guesses", starts);
        check_guesses(batch.spline, starts);
        batch.check_values();
        arrays.fill([&](const closest::FeetOutputs &out) {
            closest::closest_local(batch.spline, batch.points, starts, out);
        });
    });
}

nurbs_status nurbs_closest_all(const nurbs *g, const double *point, const double *range, double tolerance,
                               int64_t budget, int64_t cap, double *params, double *distances, int64_t *count,
                               int32_t *status) {
    return guard([&] {
        const PointQuery query(g, point, range, tolerance, budget);
        const CriticalOutputs out{cap, params, distances, nullptr, count, status};
        out.check(query);
        out.write(query, query.locator().minima(query.query));
    });
}

nurbs_status nurbs_critical_points(const nurbs *g, const double *point, const double *range, double tolerance,
                                   int64_t budget, int64_t cap, double *params, double *distances,
                                   int32_t *kinds, int64_t *count, int32_t *status) {
    return guard([&] {
        const PointQuery query(g, point, range, tolerance, budget);
        const CriticalOutputs out{cap, params, distances, kinds, count, status};
        out.check(query);
        out.write(query, query.locator().critical(query.query));
    });
}

nurbs_status nurbs_curve_signed_distances(const nurbs *g, int64_t n, const double *points,
                                          int64_t point_stride, int64_t point_component_stride,
                                          double tolerance, int64_t budget, double *distances,
                                          int64_t distance_stride, double *params, int64_t param_stride,
                                          int32_t *status, uint32_t flags) {
    return guard([&] {
        check_dimension(curve_of(g), 2, 2);
        const PointBatch batch = point_batch(g, n, points, point_stride, point_component_stride, flags);
        if (n > 0) {
            require(distances, "distances");
        }
        const FeetArrays arrays(batch, {"params", params, 1, param_stride, 0}, {"feet", nullptr, 2, 0, 0},
                                {"distances", distances, 1, distance_stride, 0}, status);
        check_tolerance(tolerance);
        const closest::Query query{nullptr, nullptr, tolerance,
                                   checked_budget(budget, closest::usual_budget(batch.spline))};
        batch.check_values();
        arrays.fill([&](const closest::FeetOutputs &out) {
            closest::signed_distances(batch.spline, batch.points, query, out);
        });
    });
}
