// SPDX-License-Identifier: MIT
// Regions of the plane bounded by closed curves, Boolean operations on regions, and faces split by curves or
// trimmed by surfaces.
#include "checks.h"
#include "guard.h"
#include "watched.h"

#include "base/checked.h"
#include "base/error.h"
#include "base/tolerance.h"
#include "face/arrange/regions.h"
#include "face/arrange/split.h"
#include "face/kept/kept_side.h"
#include "model/from_faces.h"
#include "spline/kind.h"

#include <cmath>

using namespace nrb;
using namespace nrb::capi;

namespace {

static_assert(static_cast<int>(face::FillRule::non_zero) == NURBS_FILL_NON_ZERO);
static_assert(static_cast<int>(face::FillRule::even_odd) == NURBS_FILL_EVEN_ODD);
static_assert(static_cast<int>(face::FillRule::positive) == NURBS_FILL_POSITIVE);
static_assert(static_cast<int>(face::RegionRule::either) == NURBS_REGION_UNION);
static_assert(static_cast<int>(face::RegionRule::both) == NURBS_REGION_INTERSECTION);
static_assert(static_cast<int>(face::RegionRule::difference) == NURBS_REGION_DIFFERENCE);
static_assert(static_cast<int>(face::RegionRule::one) == NURBS_REGION_EITHER);

static_assert(static_cast<int>(face::SurfaceSide::front) == NURBS_TRIM_FRONT);
static_assert(static_cast<int>(face::SurfaceSide::back) == NURBS_TRIM_BACK);

void check_side(int32_t side) {
    if (side != NURBS_TRIM_FRONT && side != NURBS_TRIM_BACK) {
        fail(Status::rule, "side = %d, expected one of the NURBS_TRIM_ constants", side);
    }
}

void check_rule(int32_t rule, int32_t last, const char *names) {
    if (rule < 1 || rule > last) {
        fail(Status::rule, "rule = %d, expected one of the %s constants", rule, names);
    }
}

void check_finite_tolerance(double tolerance) {
    check_tolerance(tolerance);
    if (!std::isfinite(tolerance)) {
        fail(Status::tolerance, "tolerance = %s, expected a finite value", Number(tolerance).text);
    }
}

SplinePtr region_curve(const nurbs *const *curves, int64_t i) {
    if (curves[i] == nullptr) {
        fail(Status::null, "curves[%lld] is NULL", static_cast<long long>(i));
    }
    check_kind(*curves[i]->spline, 1, "curves", i);
    check_dimension(*curves[i]->spline, 2, 2, "curves", i);
    return curves[i]->spline;
}

void check_count(int64_t count, const char *name, const char *array) {
    check_length(count, name);
    checked_array(count, array);
}

std::vector<SplinePtr> region_curves(int64_t count, const nurbs *const *curves) {
    check_count(count, "count", "curves");
    if (count > 0) {
        require(curves, "curves");
    }
    std::vector<SplinePtr> result;
    for (int64_t i = 0; i < count; ++i) {
        result.push_back(region_curve(curves, i));
    }
    return result;
}

} // namespace

nurbs_status nurbs_region_create(int64_t count, const nurbs *const *curves, int32_t rule, double tolerance,
                                 nurbs_model **out) {
    return guard([&] {
        require_out(out);
        const std::vector<SplinePtr> given = region_curves(count, curves);
        check_rule(rule, NURBS_FILL_POSITIVE, "NURBS_FILL_");
        check_finite_tolerance(tolerance);
        const auto faces = face::region_of(given, static_cast<face::FillRule>(rule), tolerance);
        give(model::model_of_faces(faces, 0), out);
    });
}

nurbs_status nurbs_region_create_with(int64_t count, const nurbs *const *curves, int32_t rule,
                                      double tolerance, const nurbs_call_options *call, nurbs_model **out) {
    return watched(call, out, [&] { return nurbs_region_create(count, curves, rule, tolerance, out); });
}

nurbs_status nurbs_region_combine(int32_t rule, int64_t count_a, const nurbs_face *const *a, int64_t count_b,
                                  const nurbs_face *const *b, double tolerance, nurbs_model **out) {
    return guard([&] {
        require_out(out);
        check_count(count_a, "count_a", "a");
        check_count(count_b, "count_b", "b");
        const std::vector<face::FacePtr> first = faces_in_space(count_a, a, "count_a", "a"),
                                         second = faces_in_space(count_b, b, "count_b", "b");
        check_rule(rule, NURBS_REGION_EITHER, "NURBS_REGION_");
        check_finite_tolerance(tolerance);
        const auto faces = face::combined(first, second, static_cast<face::RegionRule>(rule), tolerance);
        give(model::model_of_faces(faces, 0), out);
    });
}

nurbs_status nurbs_region_combine_with(int32_t rule, int64_t count_a, const nurbs_face *const *a,
                                       int64_t count_b, const nurbs_face *const *b, double tolerance,
                                       const nurbs_call_options *call, nurbs_model **out) {
    return watched(call, out,
                   [&] { return nurbs_region_combine(rule, count_a, a, count_b, b, tolerance, out); });
}

nurbs_status nurbs_face_split(const nurbs_face *face, int64_t count, const nurbs *const *curves,
                              double tolerance, nurbs_model **out) {
    return guard([&] {
        require_out(out);
        check_count(count, "count", "curves");
        const face::Face &own = face_of(face);
        check_dimension(*own.surface(), 3, 3, "the surface");
        const std::vector<SplinePtr> given = region_curves(count, curves);
        check_finite_tolerance(tolerance);
        give(model::model_of_faces(face::split(own, given, tolerance), 0), out);
    });
}

nurbs_status nurbs_face_split_with(const nurbs_face *face, int64_t count, const nurbs *const *curves,
                                   double tolerance, const nurbs_call_options *call, nurbs_model **out) {
    return watched(call, out, [&] { return nurbs_face_split(face, count, curves, tolerance, out); });
}

nurbs_status nurbs_face_trim(const nurbs_face *face, const nurbs *surface, int32_t side, double tolerance,
                             nurbs_model **out) {
    return guard([&] {
        require_out(out);
        const face::Face &own = face_of(face);
        check_dimension(*own.surface(), 3, 3, "the surface of the face");
        const Spline &other = named(surface, "surface");
        check_kind(other, 2, "surface");
        check_dimension(other, 3, 3, "surface");
        check_side(side);
        check_positive_tolerance(tolerance);
        check_finite_tolerance(tolerance);
        const auto kept =
            face::kept_side(own, surface->spline, static_cast<face::SurfaceSide>(side), tolerance);
        give(model::model_of_faces(kept, 0), out);
    });
}

nurbs_status nurbs_face_trim_with(const nurbs_face *face, const nurbs *surface, int32_t side,
                                  double tolerance, const nurbs_call_options *call, nurbs_model **out) {
    return watched(call, out, [&] { return nurbs_face_trim(face, surface, side, tolerance, out); });
}
