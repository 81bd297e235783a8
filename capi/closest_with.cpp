// SPDX-License-Identifier: MIT
// Batches of closest points as long calls; structs replace their many arguments.
#include "structs.h"
#include "watched.h"

#include "base/error.h"

using namespace nrb;
using namespace nrb::capi;

namespace {

using Query = nurbs_closest_query;
using Answer = nurbs_closest_answer;

void require_unused(bool unused, const char *field) {
    if (!unused) {
        fail(Status::options, "%s is not used by this function, expected 0 or NULL", field);
    }
}

void check(const Query *query, const Answer *answer) {
    checked_struct("query", query);
    checked_struct("answer", answer);
    require_unused(query->reserved == 0, "query.reserved");
}

void no_guesses(const Query &query) {
    require_unused(query.guesses == nullptr, "query.guesses");
}

using Extremal = decltype(nurbs_closest_points);

nurbs_status extremal(Extremal *find, const nurbs *g, const Query &q, const Answer &a) {
    return find(g, q.n, q.points, q.point_stride, q.point_component_stride, q.range, q.tolerance, q.budget,
                a.params, a.param_stride, a.param_component_stride, a.feet, a.foot_stride,
                a.foot_component_stride, a.distances, a.distance_stride, a.status, q.flags);
}

nurbs_status watched_extremal(Extremal *find, const nurbs *g, const Query *query, const Answer *answer,
                              const nurbs_call_options *call) {
    return watched(call, [&] {
        check(query, answer);
        no_guesses(*query);
        return extremal(find, g, *query, *answer);
    });
}

} // namespace

nurbs_status nurbs_closest_points_with(const nurbs *g, const nurbs_closest_query *query,
                                       const nurbs_closest_answer *answer, const nurbs_call_options *call) {
    return watched_extremal(nurbs_closest_points, g, query, answer, call);
}

nurbs_status nurbs_farthest_points_with(const nurbs *g, const nurbs_closest_query *query,
                                        const nurbs_closest_answer *answer, const nurbs_call_options *call) {
    return watched_extremal(nurbs_farthest_points, g, query, answer, call);
}

nurbs_status nurbs_closest_local_with(const nurbs *g, const nurbs_closest_query *query,
                                      const nurbs_closest_answer *answer, const nurbs_call_options *call) {
    return watched(call, [&] {
        check(query, answer);
        require_unused(query->range == nullptr, "query.range");
        require_unused(query->tolerance == 0, "query.tolerance");
        require_unused(query->budget == 0, "query.budget");
        return nurbs_closest_local(
            g, query->n, query->points, query->point_stride, query->point_component_stride, query->guesses,
            query->guess_stride, query->guess_component_stride, answer->params, answer->param_stride,
            answer->param_component_stride, answer->feet, answer->foot_stride, answer->foot_component_stride,
            answer->distances, answer->distance_stride, answer->status, query->flags);
    });
}

nurbs_status nurbs_curve_signed_distances_with(const nurbs *g, const nurbs_closest_query *query,
                                               const nurbs_closest_answer *answer,
                                               const nurbs_call_options *call) {
    return watched(call, [&] {
        check(query, answer);
        no_guesses(*query);
        require_unused(query->range == nullptr, "query.range");
        require_unused(answer->feet == nullptr, "answer.feet");
        return nurbs_curve_signed_distances(g, query->n, query->points, query->point_stride,
                                            query->point_component_stride, query->tolerance, query->budget,
                                            answer->distances, answer->distance_stride, answer->params,
                                            answer->param_stride, answer->status, query->flags);
    });
}
