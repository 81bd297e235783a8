/* SPDX-License-Identifier: MIT */
/* nurbs_recognize(). */
#include "shapes.h"

typedef struct Found {
    int32_t shape;
    double placement[9], sizes[3], deviation;
} Found;

static nurbs_status try_recognize(const nurbs *g, double tolerance, Found *f) {
    return nurbs_recognize(g, tolerance, &f->shape, f->placement, f->sizes, &f->deviation);
}

/* Takes the handle. */
static void check_shape(nurbs *g, double tolerance, int32_t shape, const double *placement, double first,
                        double second) {
    Found f;
    memset(&f, 0x5a, sizeof f);
    CHECK_OK(try_recognize(g, tolerance, &f));
    CHECK_INT(f.shape, shape);
    CHECK_NEAR(f.placement, placement, 9, 1e-13);
    CHECK_NEAR(f.sizes, ((const double[]){first, second, 0}), 3, 1e-13);
    CHECK(f.deviation >= 0 && f.deviation <= tolerance);
    CHECK(f.deviation > 0 || shape == NURBS_SHAPE_NONE || shape == NURBS_SHAPE_POINT);
    nurbs_destroy(g);
}

#define PLACED(...) ((const double[9]){__VA_ARGS__})

static nurbs *bezier(int32_t axes, const int32_t *degrees, int32_t dim, const double *points,
                     const double *weights) {
    nurbs *g = NULL;
    CHECK_OK(nurbs_create_bezier(axes, degrees, dim, points, 0, 0, weights, 0, &g));
    return g;
}

static nurbs *conic(int32_t dim, const double *points, double middle) {
    const double weights[] = {1, middle, 1};
    return bezier(1, (const int32_t[]){2}, dim, points, weights);
}

/* The product of a quarter about z, of radius 1, and points (distance from the axis, height) with weights. */
static nurbs *quarter_turn(int32_t degree, const double *profile, const double *weights) {
    static const double turn[] = {1, 0, 1, 1, 0, 1};
    const int32_t degrees[] = {2, degree};
    double points[3 * 3 * 3], products[9];
    int at = 0;
    for (int i = 0; i < 3; ++i) {
        for (int j = 0; j <= degree; ++j, ++at) {
            points[3 * at] = turn[2 * i] * profile[2 * j];
            points[3 * at + 1] = turn[2 * i + 1] * profile[2 * j];
            points[3 * at + 2] = profile[2 * j + 1];
            products[at] = (i == 1 ? HALF_ROOT : 1) * weights[j];
        }
    }
    return bezier(2, degrees, 3, points, products);
}

static void curves(void) {
    static const double up[] = {0, 0, 0, 0, 0, 1, 0, 0, 2}, corner[] = {1, 0, 1, 1, 0, 1};
    static const double back[] = {0, 1, 1, 1, 1, 0}, bowl[] = {-1, 1, 0, -1, 1, 1},
                        one[] = {3, 4, 3, 4, 3, 4};
    check_shape(make(circle()), 1e-13, NURBS_SHAPE_CIRCLE, PLACED(0, 0, 0, 0, 0, 1, 1, 0, 0), 1, 0);
    check_shape(conic(2, corner, HALF_ROOT), 1e-13, NURBS_SHAPE_CIRCLE, PLACED(0, 0, 0, 0, 0, 1, 1, 0, 0), 1,
                0);
    check_shape(conic(2, back, HALF_ROOT), 1e-13, NURBS_SHAPE_CIRCLE, PLACED(0, 0, 0, 0, 0, -1, 0, 1, 0), 1,
                0);
    check_shape(conic(3, up, 2), 1e-13, NURBS_SHAPE_LINE, PLACED(0, 0, 0, 0, 0, 1, 0, 0, 0), 0, 0);
    check_shape(conic(2, one, 2), 1e-13, NURBS_SHAPE_POINT, PLACED(3, 4), 0, 0);
    /* y = x^2, run through with y = axis x x falling */
    check_shape(conic(2, bowl, 1), 1e-13, NURBS_SHAPE_PARABOLA, PLACED(0, 0, 0, 0, 0, -1, 0, 1, 0), 0.25, 0);
    /* cosh, sinh from 0 to u where e^u = 5 */
    static const double branch[] = {1, 0, 1, 2. / 3, 2.6, 2.4};
    check_shape(conic(2, branch, sqrt(1.8)), 1e-13, NURBS_SHAPE_HYPERBOLA, PLACED(0, 0, 0, 0, 0, 1, 1, 0, 0),
                1, 1);
    static const double wide[] = {3, 0, 3, 1, 0, 1};
    check_shape(conic(2, wide, HALF_ROOT), 1e-13, NURBS_SHAPE_ELLIPSE, PLACED(0, 0, 0, 0, 0, 1, 1, 0, 0), 3,
                1);
    check_shape(make(arch()), 1e-5, NURBS_SHAPE_NONE, PLACED(0), 0, 0);
    check_shape(make(loop()), 1e-5, NURBS_SHAPE_NONE, PLACED(0), 0, 0);
    check_shape(make(twist()), 1e-5, NURBS_SHAPE_NONE, PLACED(0), 0, 0);
}

/* cosh, sinh from 0 to u where e^u = 2. What moves the curve by d moves the centre of so short a piece by up
   to 550 d: 18 e for weights off by a part e, which move it by 0.033 e. */
static void short_branch(void) {
    static const double branch[] = {1, 0, 1, 1. / 3, 1.25, 0.75};
    nurbs *g = conic(2, branch, sqrt(1.125));
    Found f;
    CHECK_OK(try_recognize(g, 1e-13, &f));
    CHECK_INT(f.shape, NURBS_SHAPE_HYPERBOLA);
    CHECK(hypot(f.placement[0], f.placement[1]) <= 550 * f.deviation);
    nurbs_destroy(g);
}

static void surfaces(void) {
    static const int32_t bilinear[] = {1, 1};
    static const double plate[] = {0, 0, 1, 0, 2, 1, 2, 0, 1, 2, 2, 1};
    Found f;
    nurbs *g = bezier(2, bilinear, 3, plate, NULL);
    CHECK_OK(try_recognize(g, 1e-13, &f));
    CHECK_INT(f.shape, NURBS_SHAPE_PLANE);
    CHECK_NEAR(f.placement + 2, ((const double[]){1, 0, 0, 1, 1, 0, 0}), 7, 1e-13);
    nurbs_destroy(g);
    static const double ones[] = {1, 1, 1}, round[] = {1, HALF_ROOT, 1};
    static const double wall[] = {2, 1, 2, 4}, tip[] = {0, 0, 1, 1};
    static const double dome[] = {1, 0, 1, 1, 0, 1}, ring[] = {3, 0, 3, 1, 2, 1};
    check_shape(quarter_turn(1, wall, ones), 1e-13, NURBS_SHAPE_CYLINDER, PLACED(0, 0, 1, 0, 0, 1, 1, 0, 0),
                2, 0);
    check_shape(quarter_turn(1, tip, ones), 1e-13, NURBS_SHAPE_CONE, PLACED(0, 0, 0, 0, 0, 1, 1, 0, 0),
                atan(1), 0);
    check_shape(quarter_turn(2, dome, round), 1e-12, NURBS_SHAPE_SPHERE, PLACED(0), 1, 0);
    check_shape(quarter_turn(2, ring, round), 1e-12, NURBS_SHAPE_TORUS, PLACED(0, 0, 0, 0, 0, 1, 1, 0, 0), 2,
                1);
    check_shape(quarter_turn(2, ring, ones), 1e-3, NURBS_SHAPE_NONE, PLACED(0), 0, 0);
    check_shape(make(patch()), 1e-5, NURBS_SHAPE_NONE, PLACED(0), 0, 0);
}

/* Lines run as the curve does, normals of planes are on the side of S_u x S_v. */
static void both_ways(void) {
    static const int32_t line[] = {1}, bilinear[] = {1, 1};
    for (int back = 0; back < 2; ++back) {
        const double sign = back ? -1 : 1, ends[] = {5, 6, 5, 6 + 4 * sign};
        const double plate[] = {0, 0, 0, 0, sign, 0, 2, 0, 0, 2, sign, 0};
        check_shape(bezier(1, line, 2, ends, NULL), 1e-13, NURBS_SHAPE_LINE,
                    PLACED(5, 6, 0, 0, sign, 0, 0, 0, 0), 0, 0);
        nurbs *g = bezier(2, bilinear, 3, plate, NULL);
        Found f;
        CHECK_OK(try_recognize(g, 1e-13, &f));
        CHECK_INT(f.shape, NURBS_SHAPE_PLANE);
        CHECK_NEAR(f.placement + 3, ((const double[]){0, 0, sign, 1, 0, 0}), 6, 1e-13);
        nurbs_destroy(g);
    }
}

/* The dimension does not matter, nor do outputs that are not asked for. */
static void scales(void) {
    static const double sizes[] = {1e-300, 1e-6, 1e6, 1e300};
    nurbs *unit = make(circle());
    for (int i = 0; i < 4; ++i) {
        const double s = sizes[i], matrix[] = {s, 0, 0, s}, shift[] = {3 * s, -s};
        nurbs *g = NULL;
        Found f;
        CHECK_OK(nurbs_transform(unit, 2, matrix, shift, &g));
        CHECK_OK(try_recognize(g, 1e-12 * s, &f));
        CHECK_INT(f.shape, NURBS_SHAPE_CIRCLE);
        CHECK_NEAR(f.sizes, &s, 1, 1e-14 * s);
        CHECK_NEAR(f.placement, shift, 2, 1e-14 * s);
        CHECK_OK(nurbs_recognize(g, 1e-17 * s, &f.shape, NULL, NULL, NULL));
        CHECK_INT(f.shape, NURBS_SHAPE_NONE);
        nurbs_destroy(g);
    }
    nurbs_destroy(unit);
}

static nurbs *records(double middle) {
    static const int32_t degree = 2;
    static const int64_t count = 3;
    static const double knots[] = {0, 0, 0, 1, 1, 1};
    const double points[] = {1, 0, 1, middle, 1, middle, -1, 0, 1};
    nurbs *g = NULL;
    CHECK_OK(nurbs_create_homogeneous(1, &degree, &count, knots, 6, 2, points, 0, 0, 0, &g));
    return g;
}

/* Control points at infinity are no obstacle, weights without a certain sign are one. */
static void other_weights(void) {
    check_shape(records(0), 1e-12, NURBS_SHAPE_CIRCLE, PLACED(0, 0, 0, 0, 0, 1, 1, 0, 0), 1, 0);
    Found f;
    nurbs *g = records(-2);
    CHECK_OK(try_recognize(g, 1e-3, &f));
    CHECK_INT(f.shape, NURBS_SHAPE_NONE);
    CHECK_DOUBLE(f.deviation, 0);
    nurbs_destroy(g);
    /* one record that is 0 altogether and adds nothing */
    static const int32_t degree = 2;
    static const int64_t count = 3;
    static const double knots[] = {0, 0, 0, 1, 1, 1}, ends[] = {0, 0, 1, 0, 0, 0, 2, 0, 1};
    CHECK_OK(nurbs_create_homogeneous(1, &degree, &count, knots, 6, 2, ends, 0, 0, 0, &g));
    check_shape(g, 1e-12, NURBS_SHAPE_LINE, PLACED(0, 0, 0, 1, 0, 0, 0, 0, 0), 0, 0);
}

static void bad_input(void) {
    Found f;
    FILL(f.placement);
    FILL(f.sizes);
    nurbs *g = make(circle());
    CHECK_FAILS(try_recognize(NULL, 1, &f), NURBS_ERROR_NULL, "g");
    CHECK_FAILS(nurbs_recognize(g, 1, NULL, f.placement, f.sizes, &f.deviation), NURBS_ERROR_NULL, "shape");
    CHECK_FAILS(try_recognize(g, 0, &f), NURBS_ERROR_TOLERANCE, "tolerance|0|> 0");
    CHECK_FAILS(try_recognize(g, -1, &f), NURBS_ERROR_TOLERANCE, "tolerance|-1");
    CHECK_FAILS(try_recognize(g, NAN, &f), NURBS_ERROR_TOLERANCE, "tolerance|nan");
    CHECK_FAILS(nurbs_recognize(g, 1, &f.shape, f.placement, f.placement + 7, NULL), NURBS_ERROR_OVERLAP,
                "placement|sizes");
    nurbs_destroy(g);
    g = make(hill());
    CHECK_FAILS(try_recognize(g, 1, &f), NURBS_ERROR_DIMENSION, "1|2 or 3");
    nurbs_destroy(g);
    g = make(cube());
    CHECK_FAILS(try_recognize(g, 1, &f), NURBS_ERROR_AXES, "3");
    nurbs_destroy(g);
    CHECK_UNTOUCHED(f.placement);
    CHECK_UNTOUCHED(f.sizes);
}

/* Coordinates whose squares overflow: found or not, but no crash. */
static void enormous(void) {
    static const int32_t degree = 2;
    static const double weights[] = {1, 1e-160, 1};
    for (double size = 1e140; size < 1e170; size *= 100) {
        const double points[] = {1, 0, 0, size, -1, 0};
        nurbs *g = NULL;
        int32_t shape = -1;
        CHECK_OK(nurbs_create_bezier(1, &degree, 2, points, 0, 0, weights, 0, &g));
        nurbs_status status = nurbs_recognize(g, 1e-3, &shape, NULL, NULL, NULL);
        CHECK(status == NURBS_OK || status == NURBS_ERROR_NOT_REPRESENTABLE);
        nurbs_destroy(g);
    }
}

int main(void) {
    curves();
    short_branch();
    surfaces();
    both_ways();
    scales();
    other_weights();
    bad_input();
    enormous();
    return check_summary("recognize");
}
