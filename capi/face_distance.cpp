// SPDX-License-Identifier: MIT
// Smallest distances and Hausdorff distances of two faces.
#include "checks.h"
#include "guard.h"
#include "outputs.h"
#include "watched.h"

#include "base/tolerance.h"
#include "base/watch.h"
#include "face/near/face_distance.h"

#include <array>

using namespace nrb;
using namespace nrb::capi;

namespace {

int64_t work_of(const face::Face &a, const face::Face &b) noexcept {
    return usual_work(a.surface()->point_count() + b.surface()->point_count());
}

face::FaceDistance farthest(const face::Face &from, const face::Face &to, double tolerance) {
    const UsualLimit usual(work_of(from, to) / 2);
    return face::largest_distance(from, to, tolerance);
}

// The same with half of the work that the caller's limit leaves; the rest is for the opposite direction.
face::FaceDistance farthest_with_half(const face::Face &from, const face::Face &to, double tolerance) {
    const PartOfWork half;
    return farthest(from, to, tolerance);
}

} // namespace

nurbs_status nurbs_face_distance(const nurbs_face *a, const nurbs_face *b, double tolerance, double *at_least,
                                 double *at_most, double *params_a, double *params_b, int32_t *status) {
    return guard([&] {
        require(a, "a");
        require(b, "b");
        check_tolerance(tolerance);
        check_apart({memory("at_least", at_least, 1), memory("at_most", at_most, 1),
                     memory("params_a", params_a, 2), memory("params_b", params_b, 2),
                     memory("status", status, 1)},
                    {});
        const UsualLimit usual(work_of(*a->face, *b->face));
        const face::FaceDistance found = face::smallest_distance(*a->face, *b->face, tolerance);
        put(at_least, found.at_least);
        put(at_most, found.at_most);
        put_all(params_a, found.a);
        put_all(params_b, found.b);
        put(status, bounds_status(found.certified));
    });
}

nurbs_status nurbs_face_distance_with(const nurbs_face *a, const nurbs_face *b, double tolerance,
                                      double *at_least, double *at_most, double *params_a, double *params_b,
                                      int32_t *status, const nurbs_call_options *call) {
    return watched(call, [&] {
        return nurbs_face_distance(a, b, tolerance, at_least, at_most, params_a, params_b, status);
    });
}

nurbs_status nurbs_face_hausdorff_distance(const nurbs_face *a, const nurbs_face *b, double tolerance,
                                           double *at_least, double *at_most, double *params_a,
                                           double *params_b, int32_t *status) {
    return guard([&] {
        require(a, "a");
        require(b, "b");
        check_tolerance(tolerance);
        check_apart({memory("at_least", at_least, 2), memory("at_most", at_most, 2),
                     memory("params_a", params_a, 2), memory("params_b", params_b, 2),
                     memory("status", status, 1)},
                    {});
        const face::FaceDistance there = farthest_with_half(*a->face, *b->face, tolerance),
                                 back = farthest(*b->face, *a->face, tolerance);
        put_all(at_least, std::array{there.at_least, back.at_least});
        put_all(at_most, std::array{there.at_most, back.at_most});
        put_all(params_a, there.a);
        put_all(params_b, back.a);
        put(status, bounds_status(there.certified && back.certified));
    });
}

nurbs_status nurbs_face_hausdorff_distance_with(const nurbs_face *a, const nurbs_face *b, double tolerance,
                                                double *at_least, double *at_most, double *params_a,
                                                double *params_b, int32_t *status,
                                                const nurbs_call_options *call) {
    return watched(call, [&] {
        return nurbs_face_hausdorff_distance(a, b, tolerance, at_least, at_most, params_a, params_b, status);
    });
}
