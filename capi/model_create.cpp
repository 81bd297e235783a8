// SPDX-License-Identifier: MIT
// Models of faces: that know their common edges, and that are sewn.
#include "checks.h"
#include "guard.h"
#include "watched.h"

#include "base/checked.h"
#include "base/error.h"
#include "base/tolerance.h"
#include "model/from_faces.h"
#include "model/sewing/sew.h"

#include <cmath>

using namespace nrb;
using namespace nrb::capi;

namespace {

std::vector<face::FacePtr> faces_of(int64_t count, const nurbs_face *const *faces) {
    check_length(count, "count");
    checked_array(count, "faces");
    if (count > 0) {
        require(faces, "faces");
    }
    std::vector<face::FacePtr> given;
    for (int64_t i = 0; i < count; ++i) {
        if (faces[i] == nullptr) {
            fail(Status::null, "faces[%lld] is NULL", static_cast<long long>(i));
        }
        const int dim = faces[i]->face->surface()->dim();
        if (dim != 3) {
            fail(Status::dimension, "faces[%lld] has dimension %d, expected 3", static_cast<long long>(i),
                 dim);
        }
        given.push_back(faces[i]->face);
    }
    return given;
}

} // namespace

nurbs_status nurbs_model_create(int64_t count, const nurbs_face *const *faces, double metres,
                                nurbs_model **out) {
    return guard([&] {
        require_out(out);
        const std::vector<face::FacePtr> given = faces_of(count, faces);
        model::check_metres(metres);
        give(model::model_of_faces(given, metres), out);
    });
}

nurbs_status nurbs_model_sew(int64_t count, const nurbs_face *const *faces, double tolerance, double metres,
                             nurbs_model **out) {
    return guard([&] {
        require_out(out);
        check_at_least(count, 1, "count");
        const std::vector<face::FacePtr> given = faces_of(count, faces);
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
