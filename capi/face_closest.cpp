// SPDX-License-Identifier: MIT
// Closest points of faces.
#include "checks.h"
#include "guard.h"
#include "outputs.h"
#include "watched.h"

#include "base/tolerance.h"
#include "eval/evaluate.h"
#include "face/near/face_locator.h"
#include "numeric/norm.h"

#include <cmath>
#include <vector>

using namespace nrb;
using namespace nrb::capi;

namespace {

constexpr int64_t work_of_a_point = 1000;

// Evaluates the point x of a foot on the surface and replaces the distance of the foot by that of x. If what
// was proven of the foot does not hold for x, the foot is no longer certified but coarse.
void settle(const Spline &surface, const double *point, double tolerance, closest::Foot &foot, double *x) {
    eval::AxisRules rules;
    for (size_t k = 0; k < 2; ++k) {
        rules[k].nan = true;
        rules[k].left = (foot.left >> k & 1U) != 0;
    }
    const int dim = surface.dim();
    eval::evaluate_points(surface, rules, 0, {foot.params.data(), 1, 2, 2, 1}, {x, 1, dim, dim, 1});
    const double distance = norm_of(dim, [&](int c) { return x[c] - point[c]; });
    const double allowed = foot.distance + tolerance + foot.noise;
    closest::settle(foot, distance, distance <= allowed && std::isfinite(allowed));
}

struct Feet {
    std::vector<closest::Foot> places;
    std::vector<double> points; // [n][dim]
};

// All feet are found before the first result is written, since any of them may run out of memory.
Feet feet_of(const face::Face &own, const ConstRecords &points, double tolerance) {
    const Spline &surface = *own.surface();
    std::vector<double> point(static_cast<size_t>(surface.dim())), x(point.size());
    face::FaceLocator locator(own);
    const LimitedSearch search;
    Steps steps(points.count);
    Feet feet;
    for (int64_t i = 0; i < points.count; ++i, steps.next(work_of_a_point)) {
        for (size_t c = 0; c < point.size(); ++c) {
            point[c] = points(i, static_cast<int64_t>(c));
        }
        closest::Foot foot = locator.nearest(point.data(), tolerance).foot;
        settle(surface, point.data(), tolerance, foot, x.data());
        feet.places.push_back(foot);
        feet.points.insert(feet.points.end(), x.begin(), x.end());
    }
    return feet;
}

} // namespace

nurbs_status nurbs_face_closest_points(const nurbs_face *face, int64_t n, const double *points,
                                       int64_t point_stride, int64_t point_component_stride, double tolerance,
                                       double *params, double *feet, double *distances, int32_t *status) {
    return guard([&] {
        require(face, "face");
        const face::Face &own = *face->face;
        const int dim = own.surface()->dim();
        check_length(n, "n");
        const ConstRecords from = input("points", points, n, dim, point_stride, point_component_stride);
        check_tolerance(tolerance);
        Outputs outputs(n, status);
        const Records at = outputs.add({"params", params, 2, 0, 0}),
                      on = outputs.add({"feet", feet, dim, 0, 0}),
                      away = outputs.add({"distances", distances, 1, 0, 0});
        outputs.check("points", from);
        check_points("points", from);
        const Feet found = feet_of(own, from, tolerance);
        for (size_t i = 0; i < found.places.size(); ++i) {
            const closest::Foot &foot = found.places[i];
            put(at.data, 2 * i, foot.params[0]);
            put(at.data, 2 * i + 1, foot.params[1]);
            put(away.data, i, foot.distance);
            put(status, i, foot.status);
        }
        put_all(on.data, found.points);
    });
}

nurbs_status nurbs_face_closest_points_with(const nurbs_face *face, int64_t n, const double *points,
                                            int64_t point_stride, int64_t point_component_stride,
                                            double tolerance, double *params, double *feet, double *distances,
                                            int32_t *status, const nurbs_call_options *call) {
    return watched(call, [&] {
        return nurbs_face_closest_points(face, n, points, point_stride, point_component_stride, tolerance,
                                         params, feet, distances, status);
    });
}
