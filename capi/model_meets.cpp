// SPDX-License-Identifier: MIT
// Intersections of two models, and the faces of the second one on which their branches and nodes lie.
#include "checks.h"
#include "guard.h"
#include "meets.h"
#include "outputs.h"
#include "watched.h"

#include "base/tolerance.h"
#include "model/meets/model_meets.h"

#include <utility>
#include <vector>

using namespace nrb;
using namespace nrb::capi;

namespace {

const model::Model &named_model(const nurbs_model *model, const char *name) {
    require(model, name);
    return *model->model;
}

// Stores the face and the instance of the second model for each branch, or for each node.
template <class Of>
void put_second(const std::vector<Of> &all, int64_t cap, int64_t *own_faces, int64_t *own_instances,
                int64_t *count) {
    const int64_t filled = checked_cap(cap, std::ssize(all));
    check_apart({memory("own_faces", own_faces, filled), memory("own_instances", own_instances, filled),
                 memory("count", count, 1)},
                {});
    for (size_t i = 0; std::cmp_less(i, filled); ++i) {
        put(own_faces, i, all[i].second_face);
        put(own_instances, i, all[i].second_instance);
    }
    put(count, int64_t{std::ssize(all)});
}

} // namespace

nurbs_status nurbs_model_intersections(const nurbs_model *a, const nurbs_model *b, double tolerance,
                                       nurbs_meet **out) {
    return guard([&] {
        require_out(out);
        const model::Model &first = named_model(a, "a"), &second = named_model(b, "b");
        check_positive_tolerance(tolerance);
        give_meet(model::model_intersections(first, second, tolerance), out);
    });
}

nurbs_status nurbs_model_intersections_with(const nurbs_model *a, const nurbs_model *b, double tolerance,
                                            const nurbs_call_options *call, nurbs_meet **out) {
    return watched(call, out, [&] { return nurbs_model_intersections(a, b, tolerance, out); });
}

nurbs_status nurbs_meet_faces_second(const nurbs_meet *meet, int64_t cap, int64_t *own_faces,
                                     int64_t *own_instances, int64_t *count) {
    return guard([&] {
        require(meet, "meet");
        put_second(meet->meet->branches, cap, own_faces, own_instances, count);
    });
}

nurbs_status nurbs_meet_joints_second(const nurbs_meet *meet, int64_t cap, int64_t *own_faces,
                                      int64_t *own_instances, int64_t *count) {
    return guard([&] {
        require(meet, "meet");
        put_second(meet->meet->nodes, cap, own_faces, own_instances, count);
    });
}
