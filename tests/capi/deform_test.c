/* SPDX-License-Identifier: MIT */
/* The group "deform". */
#include "check.h"
#include "shapes.h"

#define VALUES(...) ((const double[]){__VA_ARGS__})
#define INTS(...) ((const int32_t[]){__VA_ARGS__})

static void point_at(const nurbs *g, double t, double *at) {
    CHECK_OK(nurbs_eval(g, 1, &t, 0, 0, at, 0, 0, 0));
}

static void warp(void) {
    nurbs *g = make(arch()), *h = NULL;
    double at[2], before[4], after[4];
    for (int32_t order = 0; order <= 7; ++order) {
        CHECK_OK(nurbs_warp(g, VALUES(0.25, 0.75), VALUES(0, 4), 2, order, &h));
        point_at(h, 0.5, at);
        CHECK_NEAR(at, VALUES(2, 3.5), 2, 1e-13);
        int32_t degree = 0;
        CHECK_OK(nurbs_degree(h, 0, &degree));
        CHECK_INT(degree, order < 3 ? 3 : order + 1);
        for (int i = 0; i <= 8; ++i) { /* outside nothing moves */
            const double t = i < 5 ? i / 16.0 : 1 - (i - 5) / 16.0;
            point_at(g, t, before);
            point_at(h, t, after);
            CHECK(i == 4 || (i > 4 && i < 5) ? 1 : fabs(before[1] - after[1]) < 1e-14);
            CHECK(fabs(before[0] - after[0]) < 1e-14);
        }
        nurbs_destroy(h);
    }
    CHECK_OK(nurbs_warp(g, NULL, VALUES(1, 0), -1, 2, &h));
    point_at(h, 0.5, at);
    CHECK_NEAR(at, VALUES(1, 1.5), 2, 1e-14);
    nurbs_destroy(h);
    CHECK_NO_HANDLE(h, nurbs_warp(g, VALUES(0.5, 0.5), VALUES(0, 1), 1, 1, &h), NURBS_ERROR_EMPTY_DOMAIN,
                    "range[0] = [0.5, 0.5]");
    CHECK_NO_HANDLE(h, nurbs_warp(g, VALUES(0.5, nextafter(0.5, 1)), VALUES(0, 1), 1, 1, &h),
                    NURBS_ERROR_KNOTS_MERGE, "range[0]|too few doubles for 4 knots");
    CHECK_NO_HANDLE(h, nurbs_warp(g, VALUES(0.5, 1.5), VALUES(0, 1), 1, 1, &h), NURBS_ERROR_OUTSIDE_DOMAIN,
                    "range = 1.5|axis 0");
    CHECK_NO_HANDLE(h, nurbs_warp(g, VALUES(NAN, 1), VALUES(0, 1), 1, 1, &h),
                    NURBS_ERROR_PARAMETER_NOT_FINITE, "range");
    CHECK_NO_HANDLE(h, nurbs_warp(g, NULL, VALUES(0, 0), 1, 1, &h), NURBS_ERROR_DIRECTION,
                    "direction is zero");
    CHECK_NO_HANDLE(h, nurbs_warp(g, NULL, NULL, 1, 1, &h), NURBS_ERROR_NULL, "direction is NULL");
    CHECK_NO_HANDLE(h, nurbs_warp(g, NULL, VALUES(0, 1), INFINITY, 1, &h), NURBS_ERROR_LENGTH,
                    "distance = inf");
    CHECK_NO_HANDLE(h, nurbs_warp(g, NULL, VALUES(0, 1), 1, 8, &h), NURBS_ERROR_ORDER, "order = 8");
    CHECK_NO_HANDLE(h, nurbs_warp(g, NULL, VALUES(0, 1), 1, -1, &h), NURBS_ERROR_ORDER, "order = -1");
    CHECK_NO_HANDLE(h, nurbs_warp(g, NULL, VALUES(0, 1), 1.7e308, 1, &h), NURBS_ERROR_NOT_REPRESENTABLE,
                    "overflows");
    CHECK_NO_HANDLE(h, nurbs_warp(NULL, NULL, VALUES(0, 1), 1, 1, &h), NURBS_ERROR_NULL, "g is NULL");
    CHECK_FAILS(nurbs_warp(g, NULL, VALUES(0, 1), 1, 1, NULL), NURBS_ERROR_NULL, "out is NULL");
    nurbs_destroy(g);
    g = make(loop()); /* a periodic curve stays one */
    CHECK_OK(nurbs_warp(g, VALUES(2.5, 4), VALUES(1, 0), 1, 1, &h));
    int32_t form = 0;
    CHECK_OK(nurbs_knot_form(h, 0, &form));
    CHECK((form & NURBS_FORM_PERIODIC) != 0);
    point_at(g, 3.25, before);
    point_at(h, 3.25, after);
    CHECK(fabs(after[0] - before[0] - 1) < 1e-14 && after[1] == before[1]);
    nurbs_destroy(h);
    nurbs_destroy(g);
    g = make(circle()); /* weights: degrees add up */
    CHECK_OK(nurbs_warp(g, VALUES(0, 0.25), VALUES(1, 1), 1, 0, &h));
    int32_t degree = 0;
    CHECK_OK(nurbs_degree(h, 0, &degree));
    CHECK_INT(degree, 3);
    point_at(h, 0.125, at);
    CHECK_NEAR(at, VALUES(2 * HALF_ROOT, 2 * HALF_ROOT), 2, 1e-14);
    nurbs_destroy(h);
    nurbs_destroy(g);
}

static void flatten(void) {
    nurbs *g = make(arch()), *h = NULL;
    double moved = -1, at[2], before[2];
    CHECK_OK(nurbs_flatten(g, NULL, VALUES(0, 1), VALUES(0, 2), NULL, &moved, &h));
    CHECK_POINTS(h, VALUES(0, 1, 1, 1, 3, 1, 4, 1));
    CHECK(moved == 1);
    nurbs_destroy(h);
    CHECK_OK(nurbs_flatten(g, NULL, VALUES(0, 1), VALUES(0, 2), VALUES(1, 1), &moved, &h));
    CHECK_POINTS(h, VALUES(1, 1, 0, 1, 2, 1, 5, 1));
    CHECK(fabs(moved - sqrt(2)) < 1e-15);
    nurbs_destroy(h);
    CHECK_OK(nurbs_flatten(g, VALUES(0.25, 0.75), VALUES(0, 1), VALUES(0, 1), NULL, &moved, &h));
    point_at(h, 0.5, at);
    CHECK(fabs(at[0] - 2) < 1e-14 && fabs(at[1] - 1) < 1e-14);
    point_at(h, 0.25, at);
    point_at(g, 0.25, before);
    CHECK_NEAR(at, before, 2, 1e-14);
    CHECK(moved > 0.4 && moved < 0.6);
    nurbs_destroy(h);
    CHECK_NO_HANDLE(h, nurbs_flatten(g, NULL, VALUES(0, 1), VALUES(0, 0), NULL, NULL, &h),
                    NURBS_ERROR_DIRECTION, "normal is zero");
    CHECK_NO_HANDLE(h, nurbs_flatten(g, NULL, VALUES(0, 1), VALUES(0, 1), VALUES(1, 0), NULL, &h),
                    NURBS_ERROR_DIRECTION, "parallel to the plane");
    CHECK_NO_HANDLE(h, nurbs_flatten(g, NULL, VALUES(0, 1), VALUES(0, 1), VALUES(1, INFINITY), NULL, &h),
                    NURBS_ERROR_DIRECTION, "direction[1]");
    CHECK_NO_HANDLE(h, nurbs_flatten(g, NULL, VALUES(NAN, 1), VALUES(0, 1), NULL, NULL, &h),
                    NURBS_ERROR_POINT_NOT_FINITE, "point[0]");
    CHECK_NO_HANDLE(h, nurbs_flatten(g, NULL, NULL, VALUES(0, 1), NULL, NULL, &h), NURBS_ERROR_NULL,
                    "point is NULL");
    CHECK_NO_HANDLE(h, nurbs_flatten(g, NULL, VALUES(0, 1), NULL, NULL, NULL, &h), NURBS_ERROR_NULL,
                    "normal is NULL");
    CHECK_NO_HANDLE(h, nurbs_flatten(g, VALUES(1, 0), VALUES(0, 1), VALUES(0, 1), NULL, NULL, &h),
                    NURBS_ERROR_EMPTY_DOMAIN, "range[0]");
    CHECK_NO_HANDLE(h, nurbs_flatten(NULL, NULL, VALUES(0, 1), VALUES(0, 1), NULL, NULL, &h),
                    NURBS_ERROR_NULL, "g is NULL");
    nurbs_destroy(g);
}

/* A control point at infinity moves infinitely far: this half circle moves from (0, 1) to (0, 0). */
static void flatten_infinite_points(void) {
    const double knots[] = {0, 0, 0, 1, 1, 1}, records[] = {1, 0, 1, 0, 1, 0, -1, 0, 1};
    const int64_t count = 3;
    nurbs *g = NULL, *h = NULL;
    double moved = 0, at[2];
    CHECK_OK(nurbs_create_homogeneous(1, INTS(2), &count, knots, 6, 2, records, 0, 0, 0, &g));
    CHECK_OK(nurbs_flatten(g, NULL, VALUES(0, 0), VALUES(0, 1), NULL, &moved, &h));
    point_at(h, 0.5, at);
    CHECK(at[1] == 0 && moved >= 1);
    nurbs_destroy(h);
    CHECK_OK(nurbs_flatten(g, NULL, VALUES(1, 0), VALUES(1, 0), NULL, &moved, &h)); /* the other two move */
    CHECK(moved == 2);
    nurbs_destroy(h);
    nurbs_destroy(g);
}

/* Directions whose length overflows, or its square underflows. */
static void long_directions(void) {
    nurbs *g = make(arch()), *h = NULL;
    double at[2];
    for (int i = 0; i < 2; ++i) {
        const double size = i == 0 ? 1.5e308 : 1e-320, direction[] = {-size, size};
        CHECK_OK(nurbs_warp(g, NULL, direction, sqrt(2), 2, &h));
        point_at(h, 0.5, at);
        CHECK_NEAR(at, VALUES(1, 2.5), 2, 1e-13);
        nurbs_destroy(h);
        CHECK_OK(nurbs_flatten(g, NULL, VALUES(0, 1), direction, direction, NULL, &h));
        point_at(h, 0, at);
        CHECK_NEAR(at, VALUES(-0.5, 0.5), 2, 1e-13);
        nurbs_destroy(h);
    }
    nurbs_destroy(g);
}

/* A region up to an end of the domain holds the end, clamped or not. */
static void flatten_to_an_end(void) {
    for (int open = 0; open < 2; ++open) {
        nurbs *g = make(open ? hill() : arch()), *h = NULL;
        int32_t dim = 0;
        double domain[2], at[2];
        CHECK_OK(nurbs_dimension(g, &dim));
        CHECK_OK(nurbs_domain(g, 0, domain));
        const double middle = (domain[0] + domain[1]) / 2, *up = open ? VALUES(1) : VALUES(0, 1);
        for (int end = 0; end < 2; ++end) {
            const double range[] = {end == 0 ? domain[0] : middle, end == 0 ? middle : domain[1]};
            CHECK_OK(nurbs_flatten(g, range, open ? VALUES(7) : VALUES(0, 7), up, NULL, NULL, &h));
            point_at(h, domain[end], at);
            CHECK(fabs(at[dim - 1] - 7) < 1e-14);
            point_at(h, domain[1 - end], at);
            CHECK(at[dim - 1] < 2);
            nurbs_destroy(h);
        }
        nurbs_destroy(g);
    }
}

/* Homogeneous records are flattened like points: their weights stay. */
static void flatten_records(void) {
    const double knots[] = {0, 0, 0, 1, 1, 1}, records[] = {0, 0, 1, 4, 8, 4, 1, 0, 0.5};
    const int64_t count = 3;
    nurbs *g = NULL, *h = NULL;
    double points[6], weights[3], moved = 0;
    CHECK_OK(nurbs_create_homogeneous(1, INTS(2), &count, knots, 6, 2, records, 0, 0, 0, &g));
    CHECK_OK(nurbs_flatten(g, NULL, VALUES(0, 3), VALUES(0, 1), VALUES(1, 1), &moved, &h));
    CHECK_OK(nurbs_points(h, 3, points, 0, 0));
    CHECK_NEAR(points, VALUES(3, 3, 2, 3, 5, 3), 6, 1e-14);
    CHECK_OK(nurbs_weights(h, 3, weights, 0));
    CHECK_DOUBLES(weights, VALUES(1, 4, 0.5), 3);
    CHECK(fabs(moved - 3 * sqrt(2)) < 1e-14);
    nurbs_destroy(h);
    nurbs_destroy(g);
}

typedef struct Bend {
    double origin, curvature, lower, upper; /* along X and across Y, about (origin, 0) */
} Bend;

/* The distance of (x, y) from the exact image of (a, b). */
static long double off_the_bend(const Bend *r, double a, double b, const double *got) {
    const long double k = r->curvature, along = (long double)a - r->origin,
                      u = along < r->lower   ? r->lower
                          : along > r->upper ? r->upper
                                             : along,
                      turn = k * u, far = along - u;
    const long double x = (1 / k + b) * sinl(turn) + far * cosl(turn),
                      y = b * cosl(turn) - 2 / k * sinl(turn / 2) * sinl(turn / 2) - far * sinl(turn);
    return hypotl(got[0] - r->origin - x, got[1] - y);
}

/* What is proven of the bend of a segment holds. */
static void check_bound(const Bend *r, const double *ends, double tolerance) {
    static const int32_t line = 1;
    nurbs *g = NULL, *h = NULL;
    double deviation = -1, at[2];
    int32_t proven = -1;
    CHECK_OK(nurbs_create_bezier(1, &line, 2, ends, 0, 0, NULL, 0, &g));
    CHECK_OK(nurbs_bend(g, VALUES(r->origin, 0), VALUES(1, 0), VALUES(0, 1), r->curvature, r->lower, r->upper,
                        tolerance, &deviation, &proven, &h));
    for (int i = 0; i <= 16; ++i) {
        const double t = i / 16.0, a = ends[0] + t * (ends[2] - ends[0]),
                     b = ends[1] + t * (ends[3] - ends[1]);
        point_at(h, t, at);
        CHECK(proven == 0 || off_the_bend(r, a, b, at) <= deviation);
    }
    nurbs_destroy(h);
    nurbs_destroy(g);
}

/* Rounding of coordinates far from 0, of large angles, and of a centre of rotation far away. */
static void bends_off_by_rounding(void) {
    const Bend far = {1e10, 1, -INFINITY, INFINITY}, sharp = {0, 3e8, -INFINITY, INFINITY},
               before = {0, 1e-12, 1e12, 2e12};
    check_bound(&far, VALUES(1e10 + 1, 0, 1e10 + 1, 1), 1e-5);
    check_bound(&sharp, VALUES(0.1, 0, 0.1, 1), 1e-6);
    check_bound(&before, VALUES(0, 0, 1, 0), 1e-2);
}

/* A segment of length pi bent to a half circle of radius 1. */
static void bend(void) {
    static const int32_t degree = 3;
    const double pi = 3.14159265358979312;
    const double points[] = {0, 0, pi / 3, 0, 2 * pi / 3, 0, pi, 0};
    nurbs *g = NULL, *h = NULL;
    double deviation = -1;
    int32_t proven = -1;
    CHECK_OK(nurbs_create_bezier(1, &degree, 2, points, 0, 0, NULL, 0, &g));
    CHECK_OK(nurbs_bend(g, VALUES(0, 0), VALUES(1, 0), VALUES(0, 1), 1, -INFINITY, INFINITY, 1e-8, &deviation,
                        &proven, &h));
    CHECK(deviation > 0 && deviation <= 1e-8 && (proven == 0 || proven == 1));
    for (int i = 0; i <= 20; ++i) {
        double at[2];
        point_at(h, i / 20.0, at);
        CHECK(fabs(at[0] - sin(pi * i / 20)) < 1e-8 && fabs(at[1] - (cos(pi * i / 20) - 1)) < 1e-8);
    }
    nurbs_destroy(h);
    CHECK_OK(
        nurbs_bend(g, VALUES(0, 0), VALUES(1, 0), VALUES(0, 1), 1, 0, pi / 2, 1e-6, &deviation, NULL, &h));
    double at[2];
    point_at(h, 1, at); /* straight on from (1, -1) */
    CHECK_NEAR(at, VALUES(1, -1 - pi / 2), 2, 2e-6);
    nurbs_destroy(h);
    CHECK_OK(
        nurbs_bend(g, VALUES(0, 0), VALUES(1, 0), VALUES(0, 1), 0, -1, 1, 1e-8, &deviation, &proven, &h));
    CHECK(deviation == 0 && proven == 1);
    nurbs_destroy(h);
    CHECK_NO_HANDLE(h, nurbs_bend(g, VALUES(0, 0), VALUES(1, 0), VALUES(2, 0), 1, 0, 1, 1e-8, NULL, NULL, &h),
                    NURBS_ERROR_DIRECTION, "across is parallel to along");
    CHECK_NO_HANDLE(h, nurbs_bend(g, VALUES(0, 0), VALUES(0, 0), VALUES(2, 0), 1, 0, 1, 1e-8, NULL, NULL, &h),
                    NURBS_ERROR_DIRECTION, "along is zero");
    CHECK_NO_HANDLE(h,
                    nurbs_bend(g, VALUES(0, NAN), VALUES(1, 0), VALUES(0, 1), 1, 0, 1, 1e-8, NULL, NULL, &h),
                    NURBS_ERROR_POINT_NOT_FINITE, "origin[1]");
    CHECK_NO_HANDLE(h,
                    nurbs_bend(g, VALUES(0, 0), VALUES(1, 0), VALUES(0, 1), NAN, 0, 1, 1e-8, NULL, NULL, &h),
                    NURBS_ERROR_FACTOR, "curvature = nan");
    CHECK_NO_HANDLE(h, nurbs_bend(g, VALUES(0, 0), VALUES(1, 0), VALUES(0, 1), 1, 1, 1, 1e-8, NULL, NULL, &h),
                    NURBS_ERROR_EMPTY_DOMAIN, "lower = 1");
    CHECK_NO_HANDLE(h, nurbs_bend(g, VALUES(0, 0), VALUES(1, 0), VALUES(0, 1), 1, 0, 1, 0, NULL, NULL, &h),
                    NURBS_ERROR_TOLERANCE, "tolerance = 0");
    CHECK_NO_HANDLE(
        h, nurbs_bend(g, VALUES(0, 0), VALUES(1, 0), VALUES(0, 1), 1, -10, 10, 1e-25, NULL, NULL, &h),
        NURBS_ERROR_NOT_CONVERGED, "tolerance = 1e-25");
    CHECK_NO_HANDLE(h, nurbs_bend(g, NULL, VALUES(1, 0), VALUES(0, 1), 1, 0, 1, 1, NULL, NULL, &h),
                    NURBS_ERROR_NULL, "origin is NULL");
    nurbs_destroy(g);
    g = make(hill());
    CHECK_NO_HANDLE(h, nurbs_bend(g, VALUES(0), VALUES(1), VALUES(1), 1, 0, 1, 1, NULL, NULL, &h),
                    NURBS_ERROR_DIMENSION, "dimension 1 of g");
    nurbs_destroy(g);
}

static void free_form(void) {
    nurbs *g = make(arch()), *v = NULL, *h = NULL;
    static const int32_t degrees[] = {2, 1};
    double deviation = -1, at[2], before[2];
    int32_t proven = -1;
    /* V(x, y) = (x, y + x^2) over the unit square */
    CHECK_OK(nurbs_create_bezier(2, degrees, 2, VALUES(0, 0, 0, 1, 0.5, 0, 0.5, 1, 1, 1, 1, 2), 0, 0, NULL, 0,
                                 &v));
    CHECK_OK(nurbs_free_form_deform(g, v, VALUES(0, 0), VALUES(4, 2), 1e-6, &deviation, &proven, &h));
    CHECK(proven == 1 && deviation <= 1e-6 && deviation > 0);
    for (int i = 0; i <= 16; ++i) {
        point_at(g, i / 16.0, before);
        point_at(h, i / 16.0, at);
        const double x = before[0] / 4, y = before[1] / 2;
        CHECK(fabs(at[0] - x) < 1e-6 && fabs(at[1] - (y + x * x)) < 1e-6);
    }
    nurbs_destroy(h);
    CHECK_NO_HANDLE(h, nurbs_free_form_deform(g, v, VALUES(0, 0), VALUES(3, 2), 1e-6, NULL, NULL, &h),
                    NURBS_ERROR_OUTSIDE_DOMAIN, "");
    CHECK_NO_HANDLE(h, nurbs_free_form_deform(g, v, VALUES(0, 0), VALUES(4, 0), 1e-6, NULL, NULL, &h),
                    NURBS_ERROR_EMPTY_DOMAIN, "lower[1] = 0");
    CHECK_NO_HANDLE(h, nurbs_free_form_deform(g, v, VALUES(0, NAN), VALUES(4, 2), 1e-6, NULL, NULL, &h),
                    NURBS_ERROR_POINT_NOT_FINITE, "lower[1]");
    CHECK_NO_HANDLE(h, nurbs_free_form_deform(g, v, VALUES(0, 0), VALUES(4, 2), 0, NULL, NULL, &h),
                    NURBS_ERROR_TOLERANCE, "tolerance = 0");
    CHECK_NO_HANDLE(h, nurbs_free_form_deform(g, g, VALUES(0, 0), VALUES(4, 2), 1, NULL, NULL, &h),
                    NURBS_ERROR_DIMENSION, "dimension 2 of g and 2 of volume, expected 1");
    CHECK_NO_HANDLE(h, nurbs_free_form_deform(g, NULL, VALUES(0, 0), VALUES(4, 2), 1, NULL, NULL, &h),
                    NURBS_ERROR_NULL, "volume is NULL");
    CHECK_NO_HANDLE(h, nurbs_free_form_deform(g, v, NULL, VALUES(4, 2), 1, NULL, NULL, &h), NURBS_ERROR_NULL,
                    "lower is NULL");
    nurbs_destroy(g);
    g = make(circle());
    CHECK_OK(nurbs_free_form_deform(g, v, VALUES(-1, -1), VALUES(1, 1), 1e-5, &deviation, &proven, &h));
    CHECK(proven == 0 && deviation <= 1e-5);
    nurbs_destroy(h);
    nurbs_destroy(g);
    nurbs_destroy(v);
}

/* Parameters are rounded like 1e8, and what is proven says so: V(1e8 + x, 1e8 + y) = (x, y). */
static void free_form_far_away(void) {
    static const int32_t degrees[] = {1, 1}, line = 1;
    static const int64_t counts[] = {2, 2};
    static const double ends[] = {0.1, 0.3, 0.7, 0.9}, net[] = {0, 0, 0, 1, 1, 0, 1, 1};
    static const double knots[] = {1e8, 1e8, 1e8 + 1, 1e8 + 1, 1e8, 1e8, 1e8 + 1, 1e8 + 1};
    nurbs *g = NULL, *v = NULL, *h = NULL;
    double deviation = -1, at[2];
    int32_t proven = -1;
    CHECK_OK(nurbs_create_bezier(1, &line, 2, ends, 0, 0, NULL, 0, &g));
    CHECK_OK(nurbs_create(2, degrees, counts, knots, 8, 2, net, 0, 0, NULL, 0, 0, &v));
    CHECK_OK(nurbs_free_form_deform(g, v, VALUES(0, 0), VALUES(1, 1), 1e-5, &deviation, &proven, &h));
    for (int i = 0; i < 2; ++i) {
        point_at(h, i, at);
        CHECK(proven == 1 && hypot(at[0] - ends[2 * i], at[1] - ends[2 * i + 1]) <= deviation);
    }
    nurbs_destroy(h);
    nurbs_destroy(v);
    nurbs_destroy(g);
}

static void fair(void) {
    static const double points[] = {0, 0, 1, 1, 2, -1, 3, 1, 4, -1, 5, 1, 6, 0};
    static const int32_t degree = 3;
    static const int64_t count = 7;
    static const double knots[] = {0, 0, 0, 0, 1, 2, 3, 4, 4, 4, 4};
    nurbs *g = NULL, *h = NULL;
    double energies[2] = {-1, -1}, bound = -1, at[2];
    CHECK_OK(nurbs_create(1, &degree, &count, knots, 11, 2, points, 0, 0, NULL, 0, 0, &g));
    CHECK_OK(nurbs_fair(g, 2, NULL, 0.25, energies, &bound, &h));
    CHECK(energies[1] < 0.5 * energies[0] && bound <= 0.25 && bound > 0.15);
    point_at(h, 0, at);
    CHECK_DOUBLES(at, VALUES(0, 0), 2);
    point_at(h, 4, at);
    CHECK_DOUBLES(at, VALUES(6, 0), 2);
    nurbs_destroy(h);
    CHECK_OK(nurbs_fair(g, 2, NULL, 10, energies, &bound, &h)); /* far enough for a straight line */
    CHECK(energies[1] < 1e-9 * energies[0]);
    nurbs_destroy(h);
    CHECK_OK(nurbs_fair(g, 2, NULL, 0, energies, &bound, &h));
    CHECK(energies[1] == energies[0] && bound == 0);
    CHECK_POINTS(h, points);
    nurbs_destroy(h);
    CHECK_NO_HANDLE(h, nurbs_fair(g, 0, NULL, 1, energies, &bound, &h), NURBS_ERROR_ORDER, "order = 0");
    CHECK_NO_HANDLE(h, nurbs_fair(g, 4, NULL, 1, energies, &bound, &h), NURBS_ERROR_ORDER, "order = 4");
    CHECK_NO_HANDLE(h, nurbs_fair(g, 2, INTS(-2, 0), 1, energies, &bound, &h), NURBS_ERROR_ORDER,
                    "keep[0][0] = -2");
    CHECK_NO_HANDLE(h, nurbs_fair(g, 2, NULL, NAN, energies, &bound, &h), NURBS_ERROR_TOLERANCE,
                    "tolerance = nan");
    CHECK_NO_HANDLE(h, nurbs_fair(g, 2, NULL, 1, energies, energies + 1, &h), NURBS_ERROR_OVERLAP,
                    "energies|bound");
    CHECK_NO_HANDLE(h, nurbs_fair(NULL, 2, NULL, 1, energies, &bound, &h), NURBS_ERROR_NULL, "g is NULL");
    nurbs_destroy(g);
    g = make(patch());
    CHECK_NO_HANDLE(h, nurbs_fair(g, 2, NULL, 1, energies, &bound, &h), NURBS_ERROR_DEGREE, "order = 2");
    nurbs_destroy(g);
}

/* Without a tolerance to speak of w (P - centre) becomes linear, whatever the weights are. */
static void fair_with_weights(void) {
    const double points[] = {0, 0, 1, 2, 2, -1, 3, 3, 4, 0, 5, 1}, weights[] = {1, 4, 0.5, 2, 3, 1};
    const double knots[] = {0, 0, 0, 0, 1, 2, 3, 3, 3, 3};
    double energies[2];
    nurbs *g = NULL, *h = NULL;
    const int64_t count = 6;
    CHECK_OK(nurbs_create(1, INTS(3), &count, knots, 10, 2, points, 0, 0, weights, 0, 0, &g));
    CHECK_OK(nurbs_fair(g, 2, NULL, 1e3, energies, NULL, &h));
    CHECK(energies[1] < 1e-9 * energies[0]);
    nurbs_destroy(h);
    nurbs_destroy(g);
}

/* An infinite tolerance also allows what has no bound: this curve goes to infinity where its weight is 0. */
static void fair_without_a_tolerance(void) {
    const double records[] = {0, 0, 1, 1, 2, 1, -6, -12, -3, 3, 1, 1, 4, 3, 1, 5, 0, 1};
    const double knots[] = {0, 0, 0, 0, 1, 2, 3, 3, 3, 3};
    double energies[2], bound = -1;
    nurbs *g = NULL, *h = NULL;
    const int64_t count = 6;
    CHECK_OK(nurbs_create_homogeneous(1, INTS(3), &count, knots, 10, 2, records, 0, 0, 0, &g));
    CHECK_OK(nurbs_fair(g, 2, NULL, INFINITY, energies, &bound, &h));
    CHECK(energies[1] < 1e-9 * energies[0] && bound > 0);
    nurbs_destroy(h);
    nurbs_destroy(g);
}

/* The square along one axis of a volume: the integral of 2^2, whichever axis it is. */
static void energy_of_a_volume(void) {
    for (int32_t axis = 0; axis < 3; ++axis) {
        int32_t degrees[] = {1, 1, 1};
        double points[12], energies[2];
        nurbs *g = NULL, *h = NULL;
        degrees[axis] = 2;
        const int inner = axis == 0 ? 4 : axis == 1 ? 2 : 1;
        for (int i = 0; i < 12; ++i) {
            points[i] = i / inner % 3 == 2 ? 1 : 0;
        }
        CHECK_OK(nurbs_create_bezier(3, degrees, 1, points, 0, 0, NULL, 0, &g));
        CHECK_OK(nurbs_fair(g, 2, NULL, 0, energies, NULL, &h));
        CHECK_NEAR(energies, VALUES(4), 1, 1e-14);
        nurbs_destroy(h);
        nurbs_destroy(g);
    }
}

static void snap_boundary(void) {
    nurbs *g = make(arch()), *f = NULL, *h = NULL;
    double bound = -1, derivs[4];
    static const int32_t line = 1;
    CHECK_OK(nurbs_create_bezier(1, &line, 2, VALUES(-3, 1, 0, 1), 0, 0, NULL, 0, &f));
    CHECK_OK(nurbs_snap_boundary(g, 0, NURBS_START, f, 0, NURBS_END, 0, 0, &bound, &h));
    CHECK_POINTS(h, VALUES(0, 1, 1, 2, 3, 2, 4, 0));
    CHECK(bound >= 1 && bound < 1 + 1e-12);
    nurbs_destroy(h);
    CHECK_OK(nurbs_snap_boundary(g, 0, NURBS_START, f, 0, NURBS_END, 1, 0, &bound, &h));
    CHECK_OK(nurbs_eval_derivs(h, 1, 1, VALUES(0), 0, 0, derivs, 0, 0, 0));
    CHECK_NEAR(derivs, VALUES(0, 1, sqrt(45), 0), 4, 1e-14); /* as long as (3, 6) was */
    nurbs_destroy(h);
    CHECK_OK(nurbs_snap_boundary(g, 0, NURBS_END, f, 0, NURBS_END, 1, 0, &bound, &h));
    CHECK_OK(nurbs_eval_derivs(h, 1, 1, VALUES(1), 0, 0, derivs, 0, 0, 0));
    CHECK_NEAR(derivs, VALUES(0, 1, -sqrt(45), 0), 4, 1e-14); /* away from the line on the way in */
    nurbs_destroy(h);
    CHECK_NO_HANDLE(h, nurbs_snap_boundary(g, 1, 0, f, 0, 1, 0, 0, NULL, &h), NURBS_ERROR_AXIS, "axis = 1");
    CHECK_NO_HANDLE(h, nurbs_snap_boundary(g, 0, 2, f, 0, 1, 0, 0, NULL, &h), NURBS_ERROR_END, "end = 2");
    CHECK_NO_HANDLE(h, nurbs_snap_boundary(g, 0, 0, f, 0, -1, 0, 0, NULL, &h), NURBS_ERROR_END,
                    "other_end = -1");
    CHECK_NO_HANDLE(h, nurbs_snap_boundary(g, 0, 0, f, 0, 1, 2, 0, NULL, &h), NURBS_ERROR_ORDER, "order = 2");
    CHECK_NO_HANDLE(h, nurbs_snap_boundary(g, 0, 0, f, 0, 1, 0, NURBS_REVERSED, NULL, &h), NURBS_ERROR_FLAGS,
                    "flags = 0x4000000");
    CHECK_NO_HANDLE(h, nurbs_snap_boundary(g, 0, 0, NULL, 0, 1, 0, 0, NULL, &h), NURBS_ERROR_NULL,
                    "other is NULL");
    nurbs_destroy(f);
    f = make(patch());
    CHECK_NO_HANDLE(h, nurbs_snap_boundary(g, 0, 0, f, 0, 1, 0, 0, NULL, &h), NURBS_ERROR_AXES, "other 2");
    nurbs_destroy(f);
    f = make(loop());
    CHECK_NO_HANDLE(h, nurbs_snap_boundary(g, 0, 0, f, 0, 1, 0, 0, NULL, &h), NURBS_ERROR_PERIODIC,
                    "axis 0 of other");
    nurbs_destroy(f);
    f = make(hill());
    CHECK_NO_HANDLE(h, nurbs_snap_boundary(g, 0, 0, f, 0, 1, 0, 0, NULL, &h), NURBS_ERROR_INCOMPATIBLE,
                    "dimension 1 of other");
    nurbs *steps = make(stairs());
    CHECK_NO_HANDLE(h, nurbs_snap_boundary(f, 0, 0, steps, 0, 1, 1, 0, NULL, &h), NURBS_ERROR_DEGREE,
                    "degree 0 of other");
    nurbs_destroy(steps);
    nurbs_destroy(f);
    CHECK_OK(nurbs_create_bezier(1, &line, 2, VALUES(0, 1, 0, 1), 0, 0, NULL, 0, &f));
    CHECK_NO_HANDLE(h, nurbs_snap_boundary(g, 0, 0, f, 0, 1, 1, 0, NULL, &h), NURBS_ERROR_TANGENT, "other");
    nurbs_destroy(f);
    nurbs_destroy(g);
    g = make(patch()); /* the edge u = 1 onto v = 0 of the trough, run the other way */
    f = make(trough());
    CHECK_OK(nurbs_snap_boundary(g, 0, NURBS_END, f, 1, NURBS_START, 1, NURBS_REVERSED, &bound, &h));
    for (int i = 0; i <= 8; ++i) {
        const double v = i / 8.0;
        double at[9], on[9];
        CHECK_OK(nurbs_eval_derivs(h, 1, 1, VALUES(1, v), 0, 0, at, 0, 0, 0));
        CHECK_OK(nurbs_eval_derivs(f, 1, 1, VALUES(1 - v, 0), 0, 0, on, 0, 0, 0));
        CHECK_NEAR(at, on, 3, 1e-14);
        /* the derivative across is a multiple of -dS/dv, inwards */
        const double scale = at[4] / on[7];
        CHECK(scale > 0);
        CHECK(fabs(at[3] - scale * on[6]) < 1e-14 && fabs(at[5] - scale * on[8]) < 1e-14);
    }
    nurbs_destroy(h);
    nurbs_destroy(f);
    nurbs_destroy(g);
}

/* Where a weight of the other boundary is 0, the one next to it would be that of a difference. */
static void snap_to_a_weight_of_0(void) {
    static const int32_t degrees[] = {1, 2};
    const double net[] = {0, 0, 0, 0, 1, 1, 0, 2, 0, 1, 0, 0, 1, 1, 1, 1, 2, 0};
    nurbs *g = NULL, *f = NULL, *h = NULL;
    CHECK_OK(nurbs_create_bezier(2, degrees, 3, net, 0, 0, NULL, 0, &g));
    CHECK_OK(nurbs_create_bezier(2, degrees, 3, net, 0, 0, VALUES(1, 0, 1, 1, 1, 1), 0, &f));
    CHECK_NO_HANDLE(h, nurbs_snap_boundary(g, 0, NURBS_END, f, 0, NURBS_START, 1, 0, NULL, &h),
                    NURBS_ERROR_WEIGHT_SIGN, "next to the boundary");
    nurbs_destroy(f);
    nurbs_destroy(g);
}

int main(void) {
    warp();
    flatten();
    flatten_to_an_end();
    flatten_records();
    flatten_infinite_points();
    long_directions();
    bend();
    bends_off_by_rounding();
    free_form();
    free_form_far_away();
    fair();
    fair_with_weights();
    fair_without_a_tolerance();
    energy_of_a_volume();
    snap_boundary();
    snap_to_a_weight_of_0();
    return check_summary("deform");
}
