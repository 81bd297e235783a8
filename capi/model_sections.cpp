// SPDX-License-Identifier: MIT
// Where planes cut models.
#include "checks.h"
#include "guard.h"
#include "meets.h"
#include "outputs.h"
#include "watched.h"

#include "base/checked.h"
#include "base/tolerance.h"
#include "model/sections/model_sections.h"

#include <cmath>
#include <vector>

using namespace nrb;
using namespace nrb::capi;

namespace {

model::SectionPlane checked_plane(const double *normal, double offset, int64_t i) {
    const auto number = static_cast<long long>(i);
    for (int c = 0; c < 3; ++c) {
        if (!std::isfinite(normal[c])) {
            fail(Status::direction, "normals[%lld] has the coordinate %s, expected a number", number,
                 Number(normal[c]).text);
        }
    }
    if (normal[0] == 0 && normal[1] == 0 && normal[2] == 0) {
        fail(Status::direction, "normals[%lld] is 0, expected a direction", number);
    }
    if (!std::isfinite(offset)) {
        fail(Status::point_not_finite, "offsets[%lld] = %s, expected a finite value", number,
             Number(offset).text);
    }
    return {{normal[0], normal[1], normal[2]}, offset};
}

std::vector<model::SectionPlane> checked_planes(int64_t n, const double *normals, const double *offsets) {
    check_length(n, "n");
    checked_product(n, 3, "normals");
    if (n > 0) {
        require(normals, "normals");
        require(offsets, "offsets");
    }
    std::vector<model::SectionPlane> planes;
    for (int64_t i = 0; i < n; ++i) {
        planes.push_back(checked_plane(normals + 3 * i, offsets[i], i));
    }
    return planes;
}

} // namespace

nurbs_status nurbs_model_sections(const nurbs_model *model, int64_t n, const double *normals,
                                  const double *offsets, double tolerance, nurbs_meet **out) {
    return guard([&] {
        require_out(out);
        const model::Model &own = model_of(model);
        const std::vector<model::SectionPlane> planes = checked_planes(n, normals, offsets);
        check_positive_tolerance(tolerance);
        give_meet(model::model_sections(own, planes, tolerance), out);
    });
}

nurbs_status nurbs_model_sections_with(const nurbs_model *model, int64_t n, const double *normals,
                                       const double *offsets, double tolerance,
                                       const nurbs_call_options *call, nurbs_meet **out) {
    return watched(call, out,
                   [&] { return nurbs_model_sections(model, n, normals, offsets, tolerance, out); });
}
