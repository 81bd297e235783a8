// SPDX-License-Identifier: MIT
// Closest points (foot points) on models.
#include "guard.h"
#include "outputs.h"
#include "ray_arguments.h"
#include "watched.h"

#include "base/tolerance.h"
#include "base/watch.h"
#include "model/near/model_locator.h"

#include <vector>

using namespace nrb;
using namespace nrb::capi;

namespace {

constexpr int64_t work_of_a_point = 1000;

// Finds all foot points before any is written to the caller's arrays, since each search may run out of
// memory.
std::vector<model::ModelFoot> feet_of(const model::Model &model, const ConstRecords &points,
                                      double tolerance) {
    model::ModelLocator locator(model);
    const LimitedSearch search;
    Steps steps(points.count);
    std::vector<model::ModelFoot> feet;
    for (int64_t i = 0; i < points.count; ++i, steps.next(work_of_a_point)) {
        feet.push_back(locator.nearest(row(points, i), tolerance));
    }
    return feet;
}

} // namespace

nurbs_status nurbs_model_closest_points(const nurbs_model *model, int64_t n, const double *points,
                                        int64_t point_stride, int64_t point_component_stride,
                                        double tolerance, double *params, double *feet, double *distances,
                                        int32_t *status, int64_t *places) {
    return guard([&] {
        const model::Model &own = model_of(model);
        check_length(n, "n");
        const ConstRecords from = input("points", points, n, 3, point_stride, point_component_stride);
        check_tolerance(tolerance);
        check_apart({memory("params", params, 2 * n), memory("feet", feet, 3 * n),
                     memory("distances", distances, n), memory("status", status, n),
                     memory("places", places, 2 * n)},
                    {memory("points", from.data, from.extent())});
        check_points("points", from);
        const std::vector<model::ModelFoot> found = feet_of(own, from, tolerance);
        for (size_t i = 0; i < found.size(); ++i) {
            const model::ModelFoot &near = found[i];
            put(params, 2 * i, near.foot.params[0]);
            put(params, 2 * i + 1, near.foot.params[1]);
            put(feet, 3 * i, near.point.x);
            put(feet, 3 * i + 1, near.point.y);
            put(feet, 3 * i + 2, near.point.z);
            put(distances, i, near.foot.distance);
            put(status, i, near.foot.status);
            put(places, 2 * i, near.face);
            put(places, 2 * i + 1, near.instance);
        }
    });
}

nurbs_status nurbs_model_closest_points_with(const nurbs_model *model, int64_t n, const double *points,
                                             int64_t point_stride, int64_t point_component_stride,
                                             double tolerance, double *params, double *feet,
                                             double *distances, int32_t *status, int64_t *places,
                                             const nurbs_call_options *call) {
    return watched(call, [&] {
        return nurbs_model_closest_points(model, n, points, point_stride, point_component_stride, tolerance,
                                          params, feet, distances, status, places);
    });
}
