// Curves in the domain of a surface, in the parameters of its spline.
#include "build/polylines.h"
#include "eval/curve_point.h"
#include "io/faces/domain_curve.h"
#include "model/shapes/curve_spline.h"
#include "model/shapes/surface_spline.h"
#include "support/step_reading.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

namespace domain_curve_test {

namespace {

using namespace nrb;
using namespace nrb::model;

// A line, an arc that ends in it, and a line on from there, in the plane of x and z.
CurveShapePtr hook() {
    const double start[3] = {2, 0, -1}, centre[3] = {3, 0, 0}, end[3] = {3, 0, 1}, up[3] = {0, 0, 1},
                 back[3] = {0, 1, 0}, left[3] = {-1, 0, 0}, right[3] = {1, 0, 0};
    CurveShape line{CurveKind::line, build::make_placement(3, start, back, up, "line"), {1, 0}, nullptr, {}},
        arc{CurveKind::circle, build::make_placement(3, centre, back, left, "arc"), {1, 0}, nullptr, {}},
        rest{CurveKind::line, build::make_placement(3, end, back, right, "rest"), {1, 0}, nullptr, {}};
    return composite_curve({{std::make_shared<const CurveShape>(line), {0, 1}},
                            {std::make_shared<const CurveShape>(arc), {0, turn / 4}},
                            {std::make_shared<const CurveShape>(rest), {0, 2}}},
                           1e-12);
}

SurfaceShape extruded(const CurveShapePtr &profile) {
    SurfaceShape surface{};
    surface.kind = SurfaceKind::extrusion;
    surface.curve = profile;
    surface.vector = {0, 2, 0};
    return surface;
}

SurfaceShape revolved(const CurveShapePtr &profile) {
    SurfaceShape surface{};
    surface.kind = SurfaceKind::revolution;
    surface.place = build::make_placement(3, nullptr, nullptr, nullptr, "axis");
    surface.curve = profile;
    return surface;
}

// Fitted curves may leave the domain by as much as they are off.
Vector3 at(const SplinePtr &spline, std::vector<double> place) {
    for (const int k : {0, 1}) {
        const Interval domain = spline->axis(k).domain();
        double &x = place[static_cast<size_t>(k)];
        x = std::clamp(x, domain.lower, domain.upper);
    }
    return step_test::point_of(*spline, place[0], place[1]);
}

} // namespace

// The pieces of a composite profile have laws of their own. Each check is of a place on a line in the parameters as stated.
TEST(DomainCurves, over_composite_profiles_follow_each_piece) {
    const CurveShapePtr profile = hook();
    const double all = 3 + turn / 4;
    const SurfaceShape walls[] = {extruded(profile), revolved(profile)};
    for (const bool turned : {false, true}) {
        SCOPED_TRACE(turned);
        const Interval along{0, all}, across{0, 1};
        const SurfaceShape &shape = walls[turned ? 1 : 0];
        const SplinePtr spline =
            surface_spline(shape, turned ? Rectangle{across, along} : Rectangle{along, across});
        const SplinePtr stated =
            turned ? build::polyline(2, {0, 0, 1, all}, {0, 1}) : build::polyline(2, {0, 0, all, 1}, {0, 1});
        const SplinePtr made = io::in_spline_parameters(shape, *spline, stated);
        for (int i = 0; i <= 64; ++i) {
            const double t = i / 64.0;
            const double s = to_spline_parameter(*profile, *profile->spline, t * all);
            const Vector3 on = step_test::point_of(*profile->spline, s);
            const Vector3 wanted =
                turned ? Vector3{on.x * std::cos(t), on.x * std::sin(t), on.z} : on + Vector3{0, 2 * t, 0};
            EXPECT_LT(nrb::length(at(spline, eval::curve_point(*made, t, false)) - wanted), 1e-7) << t;
        }
    }
}

} // namespace domain_curve_test
