/* SPDX-License-Identifier: MIT */
/* Boxes, cones and extreme points: closed forms, both ends of the tolerance, and what is refused. */
#include "shapes.h"

#define PI 3.14159265358979323846

static nurbs *sphere(void) {
    nurbs *g = NULL;
    CHECK_OK(nurbs_surface_sphere(NULL, NULL, NULL, 2, NURBS_ARC_QUARTERS, &g));
    return g;
}

static void box_of_known_shapes(void) {
    nurbs *g = make(arch());
    double lower[3], upper[3], gap = -1;
    CHECK_OK(nurbs_box(g, NULL, 1e-12, lower, upper, &gap));
    double low[] = {0, 0}, high[] = {4, 1.5}; /* 6 t - 6 t^2 */
    CHECK_NEAR(lower, low, 2, 1e-12);
    CHECK_NEAR(upper, high, 2, 1e-12);
    CHECK(lower[0] <= 0 && lower[1] <= 0 && upper[0] >= 4 && upper[1] >= 1.5);
    CHECK(gap >= upper[1] - 1.5 && gap <= 1.1e-12);
    CHECK_OK(nurbs_box(g, NULL, INFINITY, lower, upper, &gap));
    high[1] = 2; /* Bezier points */
    CHECK_NEAR(upper, high, 2, 1e-13);
    CHECK(gap >= 0.5 && gap <= 2.01);
    double range[] = {0, 0.25};
    CHECK_OK(nurbs_box(g, range, 0, lower, upper, NULL));
    high[0] = 3 * 0.25 + 3 * 0.0625 - 2 * 0.015625;
    high[1] = 6 * 0.25 - 6 * 0.0625;
    CHECK_NEAR(upper, high, 2, 1e-13);
    nurbs_destroy(g);

    g = make(circle());
    CHECK_OK(nurbs_box(g, NULL, 0, lower, upper, &gap));
    double one[] = {1, 1}, minus[] = {-1, -1};
    CHECK_NEAR(lower, minus, 2, 2e-14);
    CHECK_NEAR(upper, one, 2, 2e-14);
    nurbs_destroy(g);

    g = make(jump());
    CHECK_OK(nurbs_box(g, NULL, 0, lower, upper, NULL));
    CHECK(lower[0] <= 0 && lower[0] > -1e-13 && upper[0] >= 6 && upper[0] < 6 + 1e-13);
    nurbs_destroy(g);

    g = make(cube());
    double below[4], above[4], zeros[] = {0, 0, 0, 0}, ones[] = {1, 1, 1, 1};
    CHECK_OK(nurbs_box(g, NULL, 0, below, above, NULL));
    CHECK_NEAR(below, zeros, 4, 4e-14);
    CHECK_NEAR(above, ones, 4, 4e-14);
    nurbs_destroy(g);
}

/* A homogeneous curve whose weight 1 - 2 t has a zero: nothing bounds it. */
static void box_of_a_pole(void) {
    const int32_t degree = 1;
    const int64_t count = 2;
    const double knots[] = {0, 0, 1, 1}, records[] = {1, 1, 1, -1};
    double lower[1], upper[1], gap, direction[1], angle;
    nurbs *g = NULL;
    CHECK_OK(nurbs_create_homogeneous(1, &degree, &count, knots, 4, 1, records, 0, 0, 0, &g));
    CHECK_OK(nurbs_box(g, NULL, 1e-3, lower, upper, &gap));
    CHECK(isinf(lower[0]) && isinf(upper[0]) && isinf(gap));
    CHECK_FAILS(nurbs_oriented_box(g, 1, lower, direction, &angle), NURBS_ERROR_NOT_REPRESENTABLE, "box");
    const double up = 1;
    double value, bound;
    CHECK_OK(nurbs_extreme_point(g, &up, NULL, 0, NULL, &value, &bound));
    CHECK(isinf(bound) && value >= 1);
    nurbs_destroy(g);
}

static void oriented_boxes(void) {
    const double a[] = {1, 2, 3}, b[] = {5, 5, 3};
    double center[3], axes[9], half[3];
    nurbs *g = NULL;
    CHECK_OK(nurbs_curve_line(3, a, b, &g));
    CHECK_OK(nurbs_oriented_box(g, 0, center, axes, half));
    const double middle[] = {3, 3.5, 3}, sides[] = {2.5, 0, 0};
    CHECK_NEAR(center, middle, 3, 1e-14);
    CHECK_NEAR(half, sides, 3, 1e-13);
    CHECK(fabs(fabs(axes[0] * 0.8 + axes[1] * 0.6) - 1) < 1e-14);
    nurbs_destroy(g);
    g = make(circle()); /* no direction is better than another: those of the coordinates */
    CHECK_OK(nurbs_oriented_box(g, 1e-9, center, axes, half));
    const double ones[] = {1, 1};
    CHECK_NEAR(half, ones, 2, 2e-9);
    nurbs_destroy(g);
}

static void tangent_cones(void) {
    double direction[3], angle, range[] = {0.1, 0.15};
    nurbs *g = make(circle());
    CHECK_OK(nurbs_tangent_cone(g, 0, NULL, 0.1, direction, &angle));
    CHECK_DOUBLE(angle, 3.141592653589793);
    range[0] = 0;
    range[1] = 0.25;
    CHECK_OK(nurbs_tangent_cone(g, 0, range, 1e-9, direction, &angle));
    const double back[] = {-HALF_ROOT, HALF_ROOT};
    CHECK_NEAR(direction, back, 2, 1e-8);
    CHECK(angle >= PI / 4 - 1e-15 && angle < PI / 4 + 1e-8);
    nurbs_destroy(g);
    g = make(trough()); /* S_v = (0, 1, 1) */
    CHECK_OK(nurbs_tangent_cone(g, 1, NULL, 0, direction, &angle));
    const double along[] = {0, HALF_ROOT, HALF_ROOT};
    CHECK_NEAR(direction, along, 3, 1e-14);
    CHECK(angle >= 0 && angle < 1e-12);
    nurbs_destroy(g);
    g = make(stairs()); /* no derivative at all */
    CHECK_OK(nurbs_tangent_cone(g, 0, NULL, 0, direction, &angle));
    CHECK_DOUBLE(fabs(direction[0]), 1);
    nurbs_destroy(g);
}

static void normal_cones(void) {
    double direction[3], angle;
    nurbs *g = make(patch()); /* (1, 0, v) x (0, 1, u) = (-v, -u, 1) */
    CHECK_OK(nurbs_normal_cone(g, NULL, 1e-9, direction, &angle));
    const double third = 1 / sqrt(3.0);
    const double corner[] = {-third, -third, third};
    double dot = -1;
    for (int i = 0; i < 3; ++i) {
        dot += i == 0 ? 1 + direction[i] * corner[i] : direction[i] * corner[i];
    }
    CHECK(acos(dot) <= angle + 1e-15);
    CHECK(acos(direction[2]) <= angle + 1e-15);
    CHECK(angle < 0.6);
    nurbs_destroy(g);
    g = sphere();
    double range[4];
    CHECK_OK(nurbs_domain(g, 0, range));
    CHECK_OK(nurbs_domain(g, 1, range + 2));
    CHECK_OK(nurbs_normal_cone(g, NULL, 0.1, direction, &angle));
    CHECK_DOUBLE(angle, 3.141592653589793);
    nurbs_destroy(g);
}

static void extreme_points(void) {
    nurbs *g = make(circle());
    const double direction[] = {3, 4};
    double param, value, bound, point[2];
    CHECK_OK(nurbs_extreme_point(g, direction, NULL, 1e-13, &param, &value, &bound));
    CHECK(fabs(value - 5) < 1e-12 && bound >= 5 - 1e-14 && bound <= value + 1e-11 && bound >= value);
    CHECK_OK(nurbs_eval(g, 1, &param, 0, 0, point, 0, 0, 0));
    CHECK(fabs(3 * point[0] + 4 * point[1] - value) < 1e-14);
    const double huge[] = {3e300, 4e300};
    CHECK_OK(nurbs_extreme_point(g, huge, NULL, 1e-6, NULL, &value, NULL));
    CHECK(fabs(value / 5e300 - 1) < 2e-6);
    nurbs_destroy(g);
    g = make(patch());
    const double up[] = {0, 0, 1};
    double params[2], range[] = {0, 0.5, 0, 0.75};
    CHECK_OK(nurbs_extreme_point(g, up, range, 0, params, &value, &bound));
    CHECK(params[0] == 0.5 && params[1] == 0.75 && value == 0.375);
    nurbs_destroy(g);
}

static void refused(void) {
    nurbs *g = make(trough()), *c = make(arch());
    double a[3], b[9], d[3];
    const double outside[] = {0, 1, 0, 4}, empty[] = {0, 1, 2, 2}, nan[] = {0, NAN, 0, 1}, up[] = {0, 0, 1};
    const double bad[] = {0, INFINITY, 0}, zero[] = {0, 0, 0};
    FILL(a);
    FILL(b);
    FILL(d);
    CHECK_FAILS(nurbs_box(NULL, NULL, 0, a, b, NULL), NURBS_ERROR_NULL, "g is NULL");
    CHECK_FAILS(nurbs_box(g, NULL, 0, NULL, b, NULL), NURBS_ERROR_NULL, "lower");
    CHECK_FAILS(nurbs_box(g, NULL, 0, a, NULL, NULL), NURBS_ERROR_NULL, "upper");
    CHECK_FAILS(nurbs_box(g, NULL, 0, a, a, NULL), NURBS_ERROR_OVERLAP, "upper|lower");
    CHECK_FAILS(nurbs_box(g, NULL, -1, a, b, NULL), NURBS_ERROR_TOLERANCE, "tolerance = -1");
    CHECK_FAILS(nurbs_box(g, NULL, NAN, a, b, NULL), NURBS_ERROR_TOLERANCE, "tolerance");
    CHECK_FAILS(nurbs_box(g, outside, 0, a, b, NULL), NURBS_ERROR_OUTSIDE_DOMAIN, "range = 4|axis 1");
    CHECK_FAILS(nurbs_box(g, empty, 0, a, b, NULL), NURBS_ERROR_EMPTY_DOMAIN, "range|axis 1|[2, 2]");
    CHECK_FAILS(nurbs_box(g, nan, 0, a, b, NULL), NURBS_ERROR_PARAMETER_NOT_FINITE, "range|axis 0");
    CHECK_FAILS(nurbs_oriented_box(NULL, 0, a, b, d), NURBS_ERROR_NULL, "g is NULL");
    CHECK_FAILS(nurbs_oriented_box(g, 0, NULL, b, d), NURBS_ERROR_NULL, "center");
    CHECK_FAILS(nurbs_oriented_box(g, 0, a, NULL, d), NURBS_ERROR_NULL, "axes");
    CHECK_FAILS(nurbs_oriented_box(g, 0, a, b, NULL), NURBS_ERROR_NULL, "half");
    CHECK_FAILS(nurbs_oriented_box(g, 0, a, b, b + 2), NURBS_ERROR_OVERLAP, "half|axes");
    CHECK_FAILS(nurbs_oriented_box(g, -1, a, b, d), NURBS_ERROR_TOLERANCE, "tolerance");
    CHECK_FAILS(nurbs_tangent_cone(NULL, 0, NULL, 0, a, d), NURBS_ERROR_NULL, "g is NULL");
    CHECK_FAILS(nurbs_tangent_cone(g, 2, NULL, 0, a, d), NURBS_ERROR_AXIS, "axis");
    CHECK_FAILS(nurbs_tangent_cone(g, 0, outside, 0, a, d), NURBS_ERROR_OUTSIDE_DOMAIN, "range");
    CHECK_FAILS(nurbs_tangent_cone(g, 0, NULL, -1, a, d), NURBS_ERROR_TOLERANCE, "tolerance");
    CHECK_FAILS(nurbs_tangent_cone(g, 0, NULL, 0, NULL, d), NURBS_ERROR_NULL, "direction");
    CHECK_FAILS(nurbs_tangent_cone(g, 0, NULL, 0, a, NULL), NURBS_ERROR_NULL, "angle");
    CHECK_FAILS(nurbs_tangent_cone(g, 0, NULL, 0, a, a + 1), NURBS_ERROR_OVERLAP, "angle");
    CHECK_FAILS(nurbs_normal_cone(NULL, NULL, 0, a, d), NURBS_ERROR_NULL, "g is NULL");
    CHECK_FAILS(nurbs_normal_cone(c, NULL, 0, a, d), NURBS_ERROR_AXES, "surface");
    CHECK_FAILS(nurbs_normal_cone(g, empty, 0, a, d), NURBS_ERROR_EMPTY_DOMAIN, "range");
    CHECK_FAILS(nurbs_normal_cone(g, NULL, NAN, a, d), NURBS_ERROR_TOLERANCE, "tolerance");
    CHECK_FAILS(nurbs_normal_cone(g, NULL, 0, NULL, d), NURBS_ERROR_NULL, "direction");
    CHECK_FAILS(nurbs_normal_cone(g, NULL, 0, a, NULL), NURBS_ERROR_NULL, "angle");
    CHECK_FAILS(nurbs_extreme_point(NULL, up, NULL, 0, a, b, d), NURBS_ERROR_NULL, "g is NULL");
    CHECK_FAILS(nurbs_extreme_point(g, NULL, NULL, 0, a, b, d), NURBS_ERROR_NULL, "direction");
    CHECK_FAILS(nurbs_extreme_point(g, bad, NULL, 0, a, b, d), NURBS_ERROR_DIRECTION, "direction[1]");
    CHECK_FAILS(nurbs_extreme_point(g, zero, NULL, 0, a, b, d), NURBS_ERROR_DIRECTION, "direction is zero");
    CHECK_FAILS(nurbs_extreme_point(g, up, nan, 0, a, b, d), NURBS_ERROR_PARAMETER_NOT_FINITE, "range");
    CHECK_FAILS(nurbs_extreme_point(g, up, NULL, -1, a, b, d), NURBS_ERROR_TOLERANCE, "tolerance");
    CHECK_FAILS(nurbs_extreme_point(g, up, NULL, 0, a, a, d), NURBS_ERROR_OVERLAP, "value|params");
    CHECK_UNTOUCHED(a);
    CHECK_UNTOUCHED(b);
    CHECK_UNTOUCHED(d);
    nurbs_destroy(c);
    nurbs_destroy(g);
}

static void of_other_dimensions(void) {
    const double corners[] = {0, 0, 1, 0, 0, 1, 1, 1};
    const int32_t degrees[] = {1, 1};
    nurbs *g = NULL;
    double a[3], d[1];
    CHECK_OK(nurbs_create_bezier(2, degrees, 2, corners, 0, 0, NULL, 0, &g));
    CHECK_FAILS(nurbs_normal_cone(g, NULL, 0, a, d), NURBS_ERROR_DIMENSION, "dimension 2");
    nurbs_destroy(g);
    double points[34] = {0}, many[17 * 17], b[17], c[17];
    const int32_t degree = 1;
    points[17] = 1;
    CHECK_OK(nurbs_create_bezier(1, &degree, 17, points, 0, 0, NULL, 0, &g));
    CHECK_FAILS(nurbs_oriented_box(g, 0, b, many, c), NURBS_ERROR_DIMENSION, "dimension 17|16");
    CHECK_OK(nurbs_box(g, NULL, 0, b, c, NULL));
    nurbs_destroy(g);
}

int main(void) {
    box_of_known_shapes();
    box_of_a_pole();
    oriented_boxes();
    tangent_cones();
    normal_cones();
    extreme_points();
    refused();
    of_other_dimensions();
    return check_summary("bounds");
}
