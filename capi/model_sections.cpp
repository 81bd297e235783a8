// SPDX-License-Identifier: MIT
// Plane sections of models.
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

std::vector<model::SectionPlane> checked_planes(int64_t n, const double *normals, const double *offsets) {
    check_length(n, "n");
    checked_product(n, 3, "normals");
    if (n > 0) {
        require(normals, "normals");
    }
    const std::span<const double> all = checked_values(n, offsets, "offsets");
    std::vector<model::SectionPlane> planes;
    for (int64_t i = 0; i < n; ++i) {
        const double *normal = normals + 3 * i;
        check_direction("normals", normal, i);
        planes.push_back({{normal[0], normal[1], normal[2]}, all[static_cast<size_t>(i)]});
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
