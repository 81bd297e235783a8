// SPDX-License-Identifier: MIT
// Ray casting on models, point-in-solid classification, and the instances of parts.
#include "guard.h"
#include "outputs.h"
#include "ray_arguments.h"

#include "base/error.h"
#include "base/tolerance.h"
#include "base/watch.h"
#include "model/rays/classify.h"

#include <algorithm>
#include <utility>
#include <vector>

using namespace nrb;
using namespace nrb::capi;

namespace {

void put_place(int64_t *places, size_t i, const model::ModelAnswer &answer) {
    put(places, 2 * i, answer.face);
    put(places, 2 * i + 1, answer.instance);
}

// The answer for a ray that is not cast because the limit of work was reached.
model::ModelAnswer not_looked_at() {
    return {{{nan_value, nan_value}, nan_value, 0, {}, false}};
}

std::vector<model::ModelAnswer> first_answers(const model::Model &model, const ConstRecords &origins,
                                              const ConstRecords &directions) {
    model::ModelCaster caster(model, model::scene_of(model));
    const LimitedSearch search;
    Steps steps(origins.count);
    std::vector<model::ModelAnswer> answers;
    for (int64_t i = 0; i < origins.count; ++i, steps.next(work_of_a_ray)) {
        answers.push_back(work_ended() ? not_looked_at()
                                       : caster.first({row(origins, i), row(directions, i)}));
    }
    return answers;
}

// Classifies all points before any side is written to the caller's array, since each step may run out of
// memory.
std::vector<int32_t> sides_of(const model::Model &model, const ConstRecords &points, double tolerance) {
    const LimitedSearch search;
    model::Classifier classifier(model, tolerance);
    Steps steps(points.count);
    std::vector<int32_t> sides;
    for (int64_t i = 0; i < points.count; ++i, steps.next(work_of_a_ray)) {
        sides.push_back(work_ended() ? model::side_undecided : classifier.side(row(points, i)));
    }
    return sides;
}

} // namespace

nurbs_status nurbs_model_instances(const nurbs_model *model, int64_t cap, int64_t *parents,
                                   int64_t *last_uses, int64_t *own_parts, double *placements,
                                   int64_t *count) {
    return guard([&] {
        const model::Model &own = model_of(model);
        check_length(cap, "cap");
        const std::vector<model::Instance> found = model::instances_of(own);
        const int64_t filled = checked_cap(cap, std::ssize(found));
        check_apart({memory("parents", parents, filled), memory("last_uses", last_uses, filled),
                     memory("own_parts", own_parts, filled), memory("placements", placements, 12 * filled),
                     memory("count", count, 1)},
                    {});
        for (size_t i = 0; std::cmp_less(i, filled); ++i) {
            put(parents, i, found[i].parent);
            put(last_uses, i, found[i].use);
            put(own_parts, i, found[i].part);
            put_all(placements == nullptr ? nullptr : placements + 12 * i, found[i].placement);
        }
        put(count, int64_t{std::ssize(found)});
    });
}

nurbs_status nurbs_model_rays(const nurbs_model *model, int64_t n, const double *origins,
                              const double *directions, double *params, double *distances, int32_t *status,
                              int64_t *places) {
    return guard([&] {
        const model::Model &own = model_of(model);
        check_length(n, "n");
        const ConstRecords from = input("origins", origins, n, 3, 0, 0),
                           along = input("directions", directions, n, 3, 0, 0);
        check_apart({memory("params", params, 2 * n), memory("distances", distances, n),
                     memory("status", status, n), memory("places", places, 2 * n)},
                    {memory("origins", origins, 3 * n), memory("directions", directions, 3 * n)});
        check_points("origins", from);
        check_directions("directions", along);
        const std::vector<model::ModelAnswer> found = first_answers(own, from, along);
        for (size_t i = 0; i < found.size(); ++i) {
            const intersect::RayAnswer &answer = found[i].answer;
            put(params, 2 * i, answer.params[0]);
            put(params, 2 * i + 1, answer.params[1]);
            put(distances, i, answer.t);
            put(status, i, answer.status);
            put_place(places, i, found[i]);
        }
    });
}

nurbs_status nurbs_model_ray_hits(const nurbs_model *model, const double *origin, const double *direction,
                                  const double *range, int64_t cap, double *params, double *distances,
                                  int32_t *kinds, int64_t *places, int64_t *count, int32_t *complete) {
    return guard([&] {
        const model::Model &own = model_of(model);
        const intersect::RayQuery ray = checked_ray(origin, direction, range);
        check_length(cap, "cap");
        model::ModelCaster caster(own, model::scene_of(own));
        const LimitedSearch search;
        std::vector<model::PlacedMeet> found;
        const bool sure = caster.all(ray, found);
        const int64_t filled = checked_cap(cap, std::ssize(found));
        check_apart(
            {memory("params", params, 2 * filled), memory("distances", distances, filled),
             memory("kinds", kinds, filled), memory("places", places, 2 * filled), memory("count", count, 1),
             memory("complete", complete, 1)},
            {memory("origin", origin, 3), memory("direction", direction, 3), memory("range", range, 2)});
        for (size_t i = 0; std::cmp_less(i, filled); ++i) {
            const model::ModelAnswer answer = caster.answer(found[i]);
            put(params, 2 * i, answer.answer.params[0]);
            put(params, 2 * i + 1, answer.answer.params[1]);
            put(distances, i, answer.answer.t);
            put(kinds, i, answer.answer.status);
            put_place(places, i, answer);
        }
        put(count, int64_t{std::ssize(found)});
        put(complete, int32_t{sure});
    });
}

nurbs_status nurbs_model_classify(const nurbs_model *model, int64_t n, const double *points,
                                  int64_t point_stride, int64_t point_component_stride, double tolerance,
                                  int32_t *sides) {
    return guard([&] {
        const model::Model &own = model_of(model);
        check_length(n, "n");
        const ConstRecords places = input("points", points, n, 3, point_stride, point_component_stride);
        if (n > 0) {
            require(sides, "sides");
        }
        check_tolerance(tolerance);
        check_apart({memory("sides", sides, n)}, {memory("points", places.data, places.extent())});
        check_points("points", places);
        const std::vector<int32_t> found = sides_of(own, places, tolerance);
        std::copy(found.begin(), found.end(), sides);
    });
}
