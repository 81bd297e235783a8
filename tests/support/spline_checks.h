// Points and domains of splines in tests of the readers.
#pragma once

#include "eval/evaluate.h"
#include "numeric/vector3.h"

#include <gtest/gtest.h>

namespace spline_checks {

// The point at the parameters of a curve or surface.
inline nrb::Vector3 point_of(const nrb::Spline &spline, double u, double v = 0) {
    const double params[2] = {u, v};
    double out[3] = {0, 0, 0};
    const int axes = spline.axes(), dim = spline.dim();
    nrb::eval::evaluate_points(spline, {}, 0, {params, 1, axes, axes, 1}, {out, 1, dim, dim, 1});
    return {out[0], out[1], out[2]};
}

inline void expect_near(const nrb::Vector3 &found, const nrb::Vector3 &expected, double tolerance = 1e-14) {
    EXPECT_LE(nrb::length(found - expected), tolerance)
        << "found (" << found.x << ", " << found.y << ", " << found.z << "), expected (" << expected.x << ", "
        << expected.y << ", " << expected.z << ")";
}

inline void expect_domain(const nrb::Spline &spline, int axis, double lower, double upper) {
    EXPECT_EQ(spline.axis(axis).domain().lower, lower);
    EXPECT_EQ(spline.axis(axis).domain().upper, upper);
}

} // namespace spline_checks
