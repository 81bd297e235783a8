// SPDX-License-Identifier: MIT
// Models made of faces: by the keys of the edges that faces share, or by sewing boundaries that coincide.
#include "checks.h"
#include "guard.h"
#include "watched.h"

#include "base/error.h"
#include "base/tolerance.h"
#include "model/from_faces.h"
#include "model/sewing/sew.h"

#include <cmath>

using namespace nrb;
using namespace nrb::capi;

nurbs_status nurbs_model_create(int64_t count, const nurbs_face *const *faces, double metres,
                                nurbs_model **out) {
    return guard([&] {
        require_out(out);
        const std::vector<face::FacePtr> given = faces_in_space(count, faces, "count", "faces");
        model::check_metres(metres);
        give(model::model_of_faces(given, metres), out);
    });
}

nurbs_status nurbs_model_sew(int64_t count, const nurbs_face *const *faces, double tolerance, double metres,
                             nurbs_model **out) {
    return guard([&] {
        require_out(out);
        check_at_least(count, 1, "count");
        const std::vector<face::FacePtr> given = faces_in_space(count, faces, "count", "faces");
        check_positive_tolerance(tolerance);
        if (!std::isfinite(tolerance)) {
            fail(Status::tolerance, "tolerance = %s, expected a finite value > 0", Number(tolerance).text);
        }
        model::check_metres(metres);
        give(model::sew(given, tolerance, metres), out);
    });
}

nurbs_status nurbs_model_sew_with(int64_t count, const nurbs_face *const *faces, double tolerance,
                                  double metres, const nurbs_call_options *call, nurbs_model **out) {
    return watched(call, out, [&] { return nurbs_model_sew(count, faces, tolerance, metres, out); });
}
