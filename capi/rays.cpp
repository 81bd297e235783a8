// SPDX-License-Identifier: MIT
// Ray casting on surfaces and faces.
#include "checks.h"
#include "guard.h"
#include "outputs.h"
#include "ray_arguments.h"
#include "watched.h"

#include "base/numbers.h"
#include "base/watch.h"
#include "face/face_rays.h"
#include "intersect/rays/rays.h"
#include "spline/kind.h"

#include <limits>
#include <memory>
#include <utility>

using namespace nrb;
using namespace nrb::capi;

namespace {

const Spline &surface_in_space(const nurbs *g) {
    const Spline &surface = surface_of(g);
    check_dimension(surface, 3, 3);
    return surface;
}

void put_rays(intersect::RayCaster &caster, const ConstRecords &origins, const ConstRecords &directions,
              double *params, double *distances, int32_t *status) {
    constexpr double none = std::numeric_limits<double>::quiet_NaN();
    const LimitedSearch search;
    Steps steps(origins.count);
    for (int64_t i = 0; i < origins.count; ++i, steps.next(work_of_a_ray)) {
        const intersect::RayAnswer answer =
            work_ended() ? intersect::RayAnswer{{none, none}, none, 0}
                         : caster.first({row(origins, i), row(directions, i)}).answer();
        const auto at = static_cast<size_t>(i);
        put(params, 2 * at, answer.params[0]);
        put(params, 2 * at + 1, answer.params[1]);
        put(distances, at, answer.t);
        put(status, at, answer.status);
    }
}

// The arguments of a call that casts a batch of rays.
struct RayArrays {
    int64_t n;
    const double *origins;
    int64_t origin_stride, origin_component_stride;
    const double *directions;
    int64_t direction_stride, direction_component_stride;
    double *params, *distances;
    int32_t *status;
};

template <class Make>
void cast_rays(const RayArrays &a, const Make &make_caster) {
    check_length(a.n, "n");
    const ConstRecords from = input("origins", a.origins, a.n, 3, a.origin_stride, a.origin_component_stride);
    const ConstRecords along =
        input("directions", a.directions, a.n, 3, a.direction_stride, a.direction_component_stride);
    Outputs outputs(a.n, a.status);
    const Records on = outputs.add({"params", a.params, 2, 0, 0}),
                  at = outputs.add({"distances", a.distances, 1, 0, 0});
    outputs.check("origins", from);
    outputs.check("directions", along);
    check_points("origins", from);
    check_directions("directions", along);
    const StagedRecords staged_params(on), staged_distances(at);
    StagedStatus staged_status(a.status, a.n);
    put_rays(*make_caster(), from, along, staged_params.view().data, staged_distances.view().data,
             staged_status.data());
    staged_params.commit();
    staged_distances.commit();
    staged_status.commit();
}

const face::Face &face_in_space(const nurbs_face *face) {
    require(face, "face");
    check_dimension(*face->face->surface(), 3, 3);
    return *face->face;
}

} // namespace

nurbs_status nurbs_surface_rays(const nurbs *g, int64_t n, const double *origins, int64_t origin_stride,
                                int64_t origin_component_stride, const double *directions,
                                int64_t direction_stride, int64_t direction_component_stride, double *params,
                                double *distances, int32_t *status) {
    return guard([&] {
        const Spline &surface = surface_in_space(g);
        cast_rays({n, origins, origin_stride, origin_component_stride, directions, direction_stride,
                   direction_component_stride, params, distances, status},
                  [&] { return std::make_unique<intersect::RayCaster>(surface); });
    });
}

nurbs_status nurbs_face_rays(const nurbs_face *face, int64_t n, const double *origins, int64_t origin_stride,
                             int64_t origin_component_stride, const double *directions,
                             int64_t direction_stride, int64_t direction_component_stride, double *params,
                             double *distances, int32_t *status) {
    return guard([&] {
        const face::Face &own = face_in_space(face);
        cast_rays(
            {n, origins, origin_stride, origin_component_stride, directions, direction_stride,
             direction_component_stride, params, distances, status},
            [&] { return std::make_unique<intersect::RayCaster>(*own.surface(), face::trim_filter(own)); });
    });
}

nurbs_status nurbs_surface_ray_hits(const nurbs *g, const double *origin, const double *direction,
                                    const double *range, int64_t cap, double *params, double *distances,
                                    int32_t *kinds, int64_t *count, int32_t *complete) {
    return guard([&] {
        const Spline &surface = surface_in_space(g);
        const intersect::RayQuery ray = checked_ray(origin, direction, range);
        check_length(cap, "cap");
        std::vector<intersect::RayAnswer> found;
        const bool sure = intersect::RayCaster(surface).all(ray, found);
        const int64_t filled = checked_cap(cap, std::ssize(found));
        check_apart(
            {memory("params", params, 2 * filled), memory("distances", distances, filled),
             memory("kinds", kinds, filled), memory("count", count, 1), memory("complete", complete, 1)},
            {memory("origin", origin, 3), memory("direction", direction, 3), memory("range", range, 2)});
        for (size_t i = 0; std::cmp_less(i, filled); ++i) {
            put(params, 2 * i, found[i].params[0]);
            put(params, 2 * i + 1, found[i].params[1]);
            put(distances, i, found[i].t);
            put(kinds, i, found[i].status);
        }
        put(count, int64_t{std::ssize(found)});
        put(complete, int32_t{sure});
    });
}
