/* SPDX-License-Identifier: MIT */
/* nurbs_curve_shape_factor(). */
#include "shapes.h"

static const int32_t degree = 2;
static const int64_t count = 3;
static const double knots[] = {0, 0, 0, 1, 1, 1};
static const double corner[] = {0, 0, 1, 1, 2, 0};

static nurbs *segment(const double *points, double w0, double w1, double w2) {
    const double weights[] = {w0, w1, w2};
    const SplineArgs args = {1, &degree, &count, knots, 6, 2, points, 0, 0, weights, 0, 0};
    return make(args);
}

static void check_factor(nurbs *g, double factor, int32_t type) {
    double found;
    int32_t kind = 0;
    CHECK_OK(nurbs_curve_shape_factor(g, &found, &kind));
    CHECK_DOUBLE(found, factor);
    CHECK_INT(kind, type);
    nurbs_destroy(g);
}

static nurbs *homogeneous(double w0, double w1, double w2) {
    const double points[] = {w0, 0, w0, 0, 1, w1, -w2, 0, w2};
    nurbs *g = NULL;
    CHECK_OK(nurbs_create_homogeneous(1, &degree, &count, knots, 6, 2, points, 0, 0, 0, &g));
    return g;
}

static void kinds(void) {
    check_factor(segment(corner, 1, 0.5, 1), 0.25, NURBS_CONIC_ELLIPSE);
    check_factor(segment(corner, 2, 2, 2), 1, NURBS_CONIC_PARABOLA);
    check_factor(segment(corner, 1, 2, 4), 1, NURBS_CONIC_PARABOLA);
    check_factor(segment(corner, 1, 3, 1), 9, NURBS_CONIC_HYPERBOLA);
    check_factor(segment(corner, 1, 0, 1), 0, NURBS_CONIC_CHORD);
    check_factor(segment(corner, 1e-300, 1e300, 1), INFINITY, NURBS_CONIC_HYPERBOLA);
    const double straight[] = {0, 0, 0.1, 0.3, 0.2, 0.6};
    check_factor(segment(straight, 1, 2, 1), 4, NURBS_CONIC_LINE);
    const double outside[] = {0, 0, 0.3, 0.9, 0.2, 0.6};
    check_factor(segment(outside, 1, 1, 1), 1, NURBS_CONIC_LINE);
    check_factor(homogeneous(1, 0, 1), 0,
                 NURBS_CONIC_ELLIPSE); /* half an ellipse, its middle point infinite */
    check_factor(homogeneous(1, -0.5, 1), 0.25, NURBS_CONIC_ELLIPSE);
    check_factor(homogeneous(1, 1, 1), 1, NURBS_CONIC_PARABOLA);
}

/* The same parabola over unclamped knots: its Bezier weights are the means of the others. */
static void unclamped(void) {
    static const double uniform[] = {0, 1, 2, 3, 4, 5};
    static const double weights[] = {1, 3, 5};
    const SplineArgs args = {1, &degree, &count, uniform, 6, 2, corner, 0, 0, weights, 0, 0};
    check_factor(make(args), 9. / 8, NURBS_CONIC_HYPERBOLA);
}

static void bad_input(void) {
    double factor;
    int32_t type = 0;
    nurbs *g = segment(corner, 1, 1, 1);
    CHECK_FAILS(nurbs_curve_shape_factor(NULL, &factor, &type), NURBS_ERROR_NULL, "g");
    CHECK_FAILS(nurbs_curve_shape_factor(g, NULL, &type), NURBS_ERROR_NULL, "factor");
    CHECK_FAILS(nurbs_curve_shape_factor(g, &factor, NULL), NURBS_ERROR_NULL, "type");
    nurbs_destroy(g);
    g = make(circle());
    CHECK_FAILS(nurbs_curve_shape_factor(g, &factor, &type), NURBS_ERROR_COUNT, "9|3");
    nurbs_destroy(g);
    g = make(arch());
    CHECK_FAILS(nurbs_curve_shape_factor(g, &factor, &type), NURBS_ERROR_DEGREE, "3|2");
    nurbs_destroy(g);
    static const int32_t degrees[] = {2, 1};
    const double flat[] = {0, 0, 0, 1, 1, 0, 1, 1, 2, 0, 2, 1};
    CHECK_OK(nurbs_create_bezier(2, degrees, 2, flat, 0, 0, NULL, 0, &g));
    CHECK_FAILS(nurbs_curve_shape_factor(g, &factor, &type), NURBS_ERROR_AXES, "2");
    nurbs_destroy(g);
    g = homogeneous(1, 1, -1);
    CHECK_FAILS(nurbs_curve_shape_factor(g, &factor, &type), NURBS_ERROR_WEIGHT_SIGN, "-1");
    nurbs_destroy(g);
}

int main(void) {
    kinds();
    unclamped();
    bad_input();
    return check_summary("shape_factor");
}
