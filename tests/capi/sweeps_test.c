/* SPDX-License-Identifier: MIT */
/* Extruded, revolved, ruled, tensor and swung shapes: known control points, and what is refused. */
#include "check.h"
#include "shapes.h"

#define VALUES(...) ((const double[]){__VA_ARGS__})
#define PI 3.14159265358979323846

/* A Bezier curve. */
static nurbs *bezier(int32_t degree, int32_t dim, const double *points) {
    nurbs *g = NULL;
    CHECK_OK(nurbs_create_bezier(1, &degree, dim, points, 0, 0, NULL, 0, &g));
    return g;
}

/* A quarter of the unit circle in dimension 2 as homogeneous records. */
static nurbs *homogeneous_quarter(double scale) {
    static const int32_t degree = 2;
    static const int64_t count = 3;
    static const double knots[] = {0, 0, 0, 1, 1, 1};
    const double records[] = {scale, 0, 1, scale * HALF_ROOT, scale * HALF_ROOT, HALF_ROOT, 0, scale, 1};
    nurbs *g = NULL;
    CHECK_OK(nurbs_create_homogeneous(1, &degree, &count, knots, 6, 2, records, 0, 0, 0, &g));
    return g;
}

static void check_axes(nurbs *g, int32_t expected) {
    int32_t axes = 0;
    CHECK_OK(nurbs_axes(g, &axes));
    CHECK_INT(axes, expected);
    nurbs_destroy(g);
}

static void extruded(void) {
    nurbs *g = make(loop()), *out = NULL;
    CHECK_OK(nurbs_extrude(g, VALUES(10, 0), &out));
    CHECK_POINTS(out,
                 VALUES(1, 1, 11, 1, -1, 1, 9, 1, -1, -1, 9, -1, 1, -1, 11, -1, 1, 1, 11, 1, -1, 1, 9, 1));
    CHECK_KNOTS(out, 0, loop().knots);
    CHECK_KNOTS(out, 1, VALUES(0, 0, 1, 1));
    int32_t forms = 0;
    CHECK_OK(nurbs_knot_form(out, 0, &forms));
    CHECK_INT(forms & NURBS_FORM_PERIODIC, NURBS_FORM_PERIODIC);
    nurbs_destroy(g);
    nurbs_destroy(out);
    g = homogeneous_quarter(1);
    CHECK_OK(nurbs_extrude(g, VALUES(0, 2), &out));
    double records[18];
    CHECK_OK(nurbs_homogeneous_points(out, 6, records, 0, 0));
    CHECK_NEAR(records,
               VALUES(1, 0, 1, 1, 2, 1, HALF_ROOT, HALF_ROOT, HALF_ROOT, HALF_ROOT, 3 * HALF_ROOT, HALF_ROOT,
                      0, 1, 1, 0, 3, 1),
               18, 5e-16);
    nurbs_destroy(g);
    nurbs_destroy(out);
    g = make(patch());
    CHECK_OK(nurbs_extrude(g, VALUES(0, 0, 1), &out));
    check_axes(out, 3);
    nurbs_destroy(g);
}

static void extrude_refused(void) {
    nurbs *g = make(twist()), *volume = make(cube()), *far = bezier(1, 1, VALUES(1e308, 0)), *out = NULL;
    CHECK_NO_HANDLE(out, nurbs_extrude(NULL, VALUES(1, 1, 1), &out), NURBS_ERROR_NULL, "g is NULL");
    CHECK_NO_HANDLE(out, nurbs_extrude(g, NULL, &out), NURBS_ERROR_NULL, "vector is NULL");
    CHECK_FAILS(nurbs_extrude(g, VALUES(1, 1, 1), NULL), NURBS_ERROR_NULL, "out is NULL");
    CHECK_NO_HANDLE(out, nurbs_extrude(g, VALUES(0, 0, 0), &out), NURBS_ERROR_DIRECTION, "vector is zero");
    nurbs *flat = make(arch());
    CHECK_NO_HANDLE(out, nurbs_extrude(flat, VALUES(0, 0, 1), &out), NURBS_ERROR_DIRECTION,
                    "vector is zero|dim = 2|nurbs_transform|3 x 2");
    CHECK_NO_HANDLE(out, nurbs_revolve(flat, NULL, NULL, 1, NURBS_ARC_QUARTERS, &out), NURBS_ERROR_DIMENSION,
                    "dimension 2 of g|3|nurbs_transform|3 x 2");
    CHECK_OK(nurbs_transform(flat, 3, VALUES(1, 0, 0, 1, 0, 0), NULL, &out)); /* what the message advises */
    nurbs_destroy(flat);
    flat = out;
    CHECK_OK(nurbs_extrude(flat, VALUES(0, 0, 1), &out));
    nurbs_destroy(out);
    nurbs_destroy(flat);
    CHECK_NO_HANDLE(out, nurbs_extrude(g, VALUES(0, NAN, 0), &out), NURBS_ERROR_DIRECTION, "vector[1] = nan");
    CHECK_NO_HANDLE(out, nurbs_extrude(volume, VALUES(1, 1, 1, 1), &out), NURBS_ERROR_AXES, "g has 3 axes");
    CHECK_NO_HANDLE(out, nurbs_extrude(far, VALUES(1e308), &out), NURBS_ERROR_NOT_REPRESENTABLE, "overflow");
    nurbs_destroy(g);
    nurbs_destroy(volume);
    nurbs_destroy(far);
}

static void revolved(void) {
    nurbs *g = bezier(1, 3, VALUES(2, 0, 0, 0, 0, 7)), *out = NULL;
    CHECK_OK(nurbs_revolve(g, NULL, NULL, PI, NURBS_ARC_QUARTERS, &out));
    CHECK_POINTS(out, VALUES(2, 0, 0, 0, 0, 7, 2, 2, 0, 0, 0, 7, 0, 2, 0, 0, 0, 7, -2, 2, 0, 0, 0, 7, -2, 0,
                             0, 0, 0, 7));
    CHECK_WEIGHTS(out, VALUES(1, 1, HALF_ROOT, HALF_ROOT, 1, 1, HALF_ROOT, HALF_ROOT, 1, 1));
    CHECK_KNOTS(out, 0, VALUES(0, 0, 0, 0.5, 0.5, 1, 1, 1));
    CHECK_KNOTS(out, 1, VALUES(0, 0, 1, 1));
    nurbs_destroy(out);
    CHECK_OK(nurbs_revolve(g, VALUES(3, 0, 100), VALUES(0, 0, -0.5), PI / 2, NURBS_ARC_SMOOTH, &out));
    CHECK_POINTS(out, VALUES(2, 0, 0, 0, 0, 7, 2, 1, 0, 0, 3, 7, 3, 1, 0, 3, 3, 7));
    nurbs_destroy(out);
    nurbs_destroy(g);
    g = make(patch());
    CHECK_OK(nurbs_revolve(g, NULL, VALUES(1, 2, 3), -1, NURBS_ARC_THIRDS, &out));
    check_axes(out, 3);
    nurbs_destroy(g);
}

static void revolve_refused(void) {
    nurbs *g = make(twist()), *plane = make(arch()), *solid = NULL, *s = make(patch()), *out = NULL;
    CHECK_OK(nurbs_extrude(s, VALUES(0, 0, 1), &solid));
    CHECK_NO_HANDLE(out, nurbs_revolve(NULL, NULL, NULL, 1, 0, &out), NURBS_ERROR_NULL, "g is NULL");
    CHECK_FAILS(nurbs_revolve(g, NULL, NULL, 1, 0, NULL), NURBS_ERROR_NULL, "out is NULL");
    CHECK_NO_HANDLE(out, nurbs_revolve(plane, NULL, NULL, 1, 0, &out), NURBS_ERROR_DIMENSION,
                    "dimension 2 of g|expected 3");
    CHECK_NO_HANDLE(out, nurbs_revolve(solid, NULL, NULL, 1, 0, &out), NURBS_ERROR_AXES, "g has 3 axes");
    CHECK_NO_HANDLE(out, nurbs_revolve(g, VALUES(0, 0, NAN), NULL, 1, 0, &out), NURBS_ERROR_POINT_NOT_FINITE,
                    "point[2] = nan");
    CHECK_NO_HANDLE(out, nurbs_revolve(g, NULL, VALUES(0, 0, 0), 1, 0, &out), NURBS_ERROR_DIRECTION,
                    "axis is zero");
    CHECK_NO_HANDLE(out, nurbs_revolve(g, NULL, VALUES(INFINITY, 0, 0), 1, 0, &out), NURBS_ERROR_DIRECTION,
                    "axis[0] = inf");
    CHECK_NO_HANDLE(out, nurbs_revolve(g, NULL, NULL, 0, 0, &out), NURBS_ERROR_ANGLE, "sweep = 0");
    CHECK_NO_HANDLE(out, nurbs_revolve(g, NULL, NULL, 6.5, 0, &out), NURBS_ERROR_ANGLE, "sweep = 6.5");
    CHECK_NO_HANDLE(out, nurbs_revolve(g, NULL, NULL, NAN, 0, &out), NURBS_ERROR_ANGLE, "sweep = nan");
    CHECK_NO_HANDLE(out, nurbs_revolve(g, NULL, NULL, 1, 3, &out), NURBS_ERROR_FORM, "form = 3");
    nurbs_destroy(g);
    g = bezier(1, 3, VALUES(1e308, 0, 0, -1e308, 0, 0));
    CHECK_NO_HANDLE(out, nurbs_revolve(g, VALUES(-1e308, 0, 0), NULL, 1, 0, &out),
                    NURBS_ERROR_NOT_REPRESENTABLE, "overflow");
    nurbs_destroy(g);
    nurbs_destroy(plane);
    nurbs_destroy(solid);
    nurbs_destroy(s);
}

static void ruled(void) {
    nurbs *a = bezier(1, 2, VALUES(0, 0, 2, 0)), *b = bezier(2, 2, VALUES(0, 3, 1, 5, 2, 3)), *out = NULL;
    CHECK_OK(nurbs_ruled(a, b, 0, &out));
    CHECK_POINTS(out, VALUES(0, 0, 0, 3, 1, 0, 1, 5, 2, 0, 2, 3));
    nurbs_destroy(out);
    CHECK_OK(nurbs_ruled(b, a, NURBS_RULED_CARTESIAN, &out));
    CHECK_POINTS(out, VALUES(0, 3, 0, 0, 1, 5, 1, 0, 2, 3, 2, 0));
    nurbs_destroy(out);
    nurbs_destroy(b);
    b = homogeneous_quarter(2);
    const double at[] = {0.5, 0.5};
    double point[2], root = 1.4142135623730951;
    CHECK_OK(nurbs_ruled(a, b, 0, &out)); /* weights 1 and (1 + sqrt(1/2)) / 2 at u = 1/2 */
    CHECK_OK(nurbs_eval(out, 1, at, 0, 0, point, 0, 0, 0));
    const double w = (1 + HALF_ROOT) / 2;
    CHECK_NEAR(point, VALUES((1 + w * root) / (1 + w), w * root / (1 + w)), 2, 1e-15);
    nurbs_destroy(out);
    CHECK_OK(nurbs_ruled(a, b, NURBS_RULED_CARTESIAN, &out));
    CHECK_OK(nurbs_eval(out, 1, at, 0, 0, point, 0, 0, 0));
    CHECK_NEAR(point, VALUES((1 + root) / 2, root / 2), 2, 1e-15);
    int32_t degree = 0;
    CHECK_OK(nurbs_degree(out, 0, &degree));
    CHECK_INT(degree, 3);
    nurbs_destroy(out);
    nurbs_destroy(a);
    nurbs_destroy(b);
}

static void ruled_refused(void) {
    nurbs *a = make(arch()), *space = make(twist()), *surface = make(patch()), *volume = make(cube()),
          *out = NULL;
    CHECK_NO_HANDLE(out, nurbs_ruled(NULL, a, 0, &out), NURBS_ERROR_NULL, "a is NULL");
    CHECK_NO_HANDLE(out, nurbs_ruled(a, NULL, 0, &out), NURBS_ERROR_NULL, "b is NULL");
    CHECK_FAILS(nurbs_ruled(a, a, 0, NULL), NURBS_ERROR_NULL, "out is NULL");
    CHECK_NO_HANDLE(out, nurbs_ruled(a, a, 1, &out), NURBS_ERROR_FLAGS, "flags = 0x1|NURBS_RULED_CARTESIAN");
    CHECK_NO_HANDLE(out, nurbs_ruled(a, space, 0, &out), NURBS_ERROR_DIMENSION, "3 of b|expected 2");
    CHECK_NO_HANDLE(out, nurbs_ruled(space, surface, 0, &out), NURBS_ERROR_INCOMPATIBLE, "b has 2 axes");
    CHECK_NO_HANDLE(out, nurbs_ruled(volume, volume, 0, &out), NURBS_ERROR_AXES, "a has 3 axes");
    nurbs_destroy(surface);
    const int32_t degree = 20;
    double points[42] = {0}, weights[21];
    nurbs *high[2] = {NULL, NULL};
    for (int k = 0; k < 2; ++k) {
        for (int i = 0; i < 21; ++i) {
            weights[i] = 1 + i * k;
        }
        CHECK_OK(nurbs_create_bezier(1, &degree, 2, points, 0, 0, weights, 0, &high[k]));
    }
    CHECK_NO_HANDLE(out, nurbs_ruled(high[0], high[1], NURBS_RULED_CARTESIAN, &out), NURBS_ERROR_DEGREE,
                    "40|31");
    CHECK_OK(nurbs_ruled(high[0], high[1], 0, &out));
    nurbs_destroy(out);
    for (int k = 0; k < 2; ++k) {
        nurbs_destroy(high[k]);
    }
    const int32_t line = 1;
    const int64_t five = 5;
    nurbs *far =
        make((SplineArgs){1, &line, (const int64_t[]){2}, VALUES(0x1p53, 0x1p53, 0x1p53 + 4, 0x1p53 + 4), 4,
                          1, VALUES(0, 1), 0, 0, NULL, 0, 0});
    nurbs *fine = make((SplineArgs){1, &line, &five, VALUES(0, 0, 0.125, 0.25, 0.375, 1, 1), 7, 1,
                                    VALUES(0, 1, 2, 3, 4), 0, 0, NULL, 0, 0});
    CHECK_NO_HANDLE(out, nurbs_ruled(far, fine, 0, &out), NURBS_ERROR_KNOTS_MERGE, "0.125");
    CHECK_NO_HANDLE(out, nurbs_ruled(far, fine, NURBS_RULED_CARTESIAN, &out), NURBS_ERROR_KNOTS_MERGE,
                    "0.125");
    nurbs_destroy(far);
    nurbs_destroy(fine);
    nurbs_destroy(a);
    nurbs_destroy(space);
    nurbs_destroy(volume);
}

static void tensor(void) {
    nurbs *a = make(twist()), *b = bezier(1, 3, VALUES(0, 0, 1, 0, 0, 2)), *out = NULL;
    CHECK_OK(nurbs_tensor_sum(a, 2, b, -1, &out));
    CHECK_POINTS(out, VALUES(0, 0, -1, 0, 0, -2, 2, 0, -1, 2, 0, -2, 4, 2, -1, 4, 2, -2, 6, 6, 5, 6, 6, 4));
    CHECK_KNOTS(out, 0, twist().knots);
    CHECK_KNOTS(out, 1, VALUES(0, 0, 1, 1));
    nurbs_destroy(out);
    CHECK_OK(nurbs_tensor_product(b, a, &out));
    CHECK_POINTS(out, VALUES(0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 3, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 6));
    nurbs_destroy(out);
    nurbs *scalar = bezier(1, 1, VALUES(1, 2));
    CHECK_OK(nurbs_tensor_product(scalar, b, &out));
    CHECK_POINTS(out, VALUES(0, 0, 1, 0, 0, 2, 0, 0, 2, 0, 0, 4));
    nurbs_destroy(out);
    nurbs *quarter = homogeneous_quarter(1), *up = bezier(1, 2, VALUES(0, 0, 0, 4));
    CHECK_OK(nurbs_tensor_sum(quarter, 1, up, 0.5, &out));
    double point[2];
    CHECK_OK(nurbs_eval(out, 1, VALUES(0.5, 1), 0, 0, point, 0, 0, 0));
    CHECK_NEAR(point, VALUES(HALF_ROOT, HALF_ROOT + 2), 2, 1e-15);
    nurbs_destroy(out);
    nurbs_destroy(a);
    nurbs_destroy(b);
    nurbs_destroy(scalar);
    nurbs_destroy(quarter);
    nurbs_destroy(up);
}

static void tensor_refused(void) {
    nurbs *a = make(twist()), *b = make(arch()), *s = make(patch()),
          *huge = bezier(1, 3, VALUES(1e300, 0, 0, 0, 0, 0)), *out = NULL;
    CHECK_NO_HANDLE(out, nurbs_tensor_sum(NULL, 1, a, 1, &out), NURBS_ERROR_NULL, "a is NULL");
    CHECK_NO_HANDLE(out, nurbs_tensor_sum(a, 1, NULL, 1, &out), NURBS_ERROR_NULL, "b is NULL");
    CHECK_FAILS(nurbs_tensor_sum(a, 1, a, 1, NULL), NURBS_ERROR_NULL, "out is NULL");
    CHECK_NO_HANDLE(out, nurbs_tensor_sum(a, NAN, a, 1, &out), NURBS_ERROR_FACTOR, "alpha = nan");
    CHECK_NO_HANDLE(out, nurbs_tensor_sum(a, 1, a, INFINITY, &out), NURBS_ERROR_FACTOR, "beta = inf");
    CHECK_NO_HANDLE(out, nurbs_tensor_sum(a, 1, b, 1, &out), NURBS_ERROR_DIMENSION, "2 of b|expected 3");
    CHECK_NO_HANDLE(out, nurbs_tensor_sum(s, 1, s, 1, &out), NURBS_ERROR_AXES, "a has 2 axes and b 2");
    CHECK_NO_HANDLE(out, nurbs_tensor_sum(huge, 1e300, a, 1, &out), NURBS_ERROR_NOT_REPRESENTABLE,
                    "overflow");
    CHECK_NO_HANDLE(out, nurbs_tensor_product(NULL, a, &out), NURBS_ERROR_NULL, "a is NULL");
    CHECK_NO_HANDLE(out, nurbs_tensor_product(a, NULL, &out), NURBS_ERROR_NULL, "b is NULL");
    CHECK_FAILS(nurbs_tensor_product(a, a, NULL), NURBS_ERROR_NULL, "out is NULL");
    CHECK_NO_HANDLE(out, nurbs_tensor_product(a, b, &out), NURBS_ERROR_DIMENSION, "3 of a|2 of b|or 1");
    CHECK_NO_HANDLE(out, nurbs_tensor_product(s, s, &out), NURBS_ERROR_AXES, "at most 3");
    CHECK_NO_HANDLE(out, nurbs_tensor_product(huge, huge, &out), NURBS_ERROR_NOT_REPRESENTABLE, "overflow");
    const int32_t degree = 1;
    nurbs *light = NULL;
    CHECK_OK(nurbs_create_bezier(1, &degree, 3, VALUES(0, 0, 0, 1, 1, 1), 0, 0, VALUES(1e-300, 1e-300), 0,
                                 &light));
    CHECK_NO_HANDLE(out, nurbs_tensor_sum(light, 1, light, 1, &out), NURBS_ERROR_WEIGHTS_VANISH, "weight");
    nurbs_destroy(light);
    nurbs_destroy(a);
    nurbs_destroy(b);
    nurbs_destroy(s);
    nurbs_destroy(huge);
}

/* Records (w x, w y, w) of a quarter of the circle of radius 1, with weights other than 1 at its ends. */
static nurbs *quarter(void) {
    static const int32_t degree = 2;
    static const int64_t count = 3;
    const double knots[] = {0, 0, 0, 1, 1, 1}, records[] = {2, 0, 2, 1, 1, 1, 0, 1, 1};
    nurbs *g = NULL;
    CHECK_OK(nurbs_create_homogeneous(1, &degree, &count, knots, 6, 2, records, 0, 0, 0, &g));
    return g;
}

/* Weights of the trajectory are none of the heights: in the middle of the profile the radius is 2, the height
 * 5. */
static void swung_records(void) {
    const int32_t degree = 1;
    nurbs *trajectory = quarter(), *profile = NULL, *out = NULL;
    CHECK_OK(nurbs_create_bezier(1, &degree, 2, VALUES(1, 3, 3, 7), 0, 0, NULL, 0, &profile));
    CHECK_OK(nurbs_surface_swung(trajectory, profile, 1, &out));
    for (int i = 0; i <= 4; ++i) {
        double at[3];
        CHECK_OK(nurbs_eval(out, 1, VALUES(i / 4.0, 0.5), 0, 0, at, 0, 0, 0));
        CHECK(fabs(hypot(at[0], at[1]) - 2) < 1e-14 && fabs(at[2] - 5) < 1e-14);
    }
    nurbs_destroy(out);
    nurbs_destroy(profile);
    nurbs_destroy(trajectory);
}

static void swung(void) {
    nurbs *trajectory = make(circle()), *profile = bezier(1, 2, VALUES(1, 0, 3, 5)), *out = NULL;
    CHECK_OK(nurbs_surface_swung(trajectory, profile, 2, &out));
    double points[54];
    CHECK_OK(nurbs_points(out, 18, points, 0, 0));
    CHECK_DOUBLES(points, VALUES(2, 0, 0, 6, 0, 5, 2, 2, 0, 6, 6, 5), 12);
    double weights[18];
    CHECK_OK(nurbs_weights(out, 18, weights, 0));
    CHECK_DOUBLES(weights, VALUES(1, 1, HALF_ROOT, HALF_ROOT), 4);
    nurbs_destroy(out);
    nurbs *space = make(twist()), *s = make(patch());
    CHECK_NO_HANDLE(out, nurbs_surface_swung(NULL, profile, 1, &out), NURBS_ERROR_NULL, "trajectory is NULL");
    CHECK_NO_HANDLE(out, nurbs_surface_swung(trajectory, NULL, 1, &out), NURBS_ERROR_NULL, "profile is NULL");
    CHECK_FAILS(nurbs_surface_swung(trajectory, profile, 1, NULL), NURBS_ERROR_NULL, "out is NULL");
    CHECK_NO_HANDLE(out, nurbs_surface_swung(space, profile, 1, &out), NURBS_ERROR_DIMENSION,
                    "trajectory has dimension 3|expected 2");
    CHECK_NO_HANDLE(out, nurbs_surface_swung(trajectory, space, 1, &out), NURBS_ERROR_DIMENSION, "profile");
    CHECK_NO_HANDLE(out, nurbs_surface_swung(s, profile, 1, &out), NURBS_ERROR_AXES, "trajectory has 2 axes");
    CHECK_NO_HANDLE(out, nurbs_surface_swung(trajectory, s, 1, &out), NURBS_ERROR_AXES, "profile has 2 axes");
    CHECK_NO_HANDLE(out, nurbs_surface_swung(trajectory, profile, 0, &out), NURBS_ERROR_FACTOR, "scale = 0");
    CHECK_NO_HANDLE(out, nurbs_surface_swung(trajectory, profile, NAN, &out), NURBS_ERROR_FACTOR,
                    "scale = nan");
    CHECK_NO_HANDLE(out, nurbs_surface_swung(trajectory, profile, 1e308, &out), NURBS_ERROR_NOT_REPRESENTABLE,
                    "overflow");
    nurbs_destroy(space);
    nurbs_destroy(s);
    nurbs_destroy(trajectory);
    nurbs_destroy(profile);
}

int main(void) {
    extruded();
    extrude_refused();
    revolved();
    revolve_refused();
    ruled();
    ruled_refused();
    tensor();
    tensor_refused();
    swung();
    swung_records();
    return check_summary("sweeps");
}
