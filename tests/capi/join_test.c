/* SPDX-License-Identifier: MIT */
/* nurbs_join(). */
#include "check.h"
#include "shapes.h"

#include <stdint.h>

#define VALUES(...) ((const double[]){__VA_ARGS__})

static nurbs *line(double t0, double t1, double x0, double x1, double w0, double w1) {
    static const int32_t degree = 1;
    static const int64_t count = 2;
    const double knots[] = {t0, t0, t1, t1}, points[] = {x0, x1}, weights[] = {w0, w1};
    nurbs *g = NULL;
    CHECK_OK(nurbs_create(1, &degree, &count, knots, 4, 1, points, 0, 0, w0 == 0 ? NULL : weights, 0, 0, &g));
    return g;
}

static void meeting_ends(void) {
    nurbs *a = line(0, 1, 0, 2, 0, 0), *b = line(5, 8, 2, 3, 0, 0), *h = NULL;
    const nurbs *parts[] = {a, b, a};
    double gap = -1;
    CHECK_OK(nurbs_join(2, parts, 0, 0, 0, &gap, &h));
    CHECK_DOUBLE(gap, 0);
    CHECK_KNOTS(h, 0, VALUES(0, 0, 1, 4, 4));
    CHECK_POINTS(h, VALUES(0, 2, 3));
    nurbs_destroy(h);
    CHECK_OK(nurbs_join(1, parts, 0, 0, 0, NULL, &h));
    CHECK_POINTS(h, VALUES(0, 2));
    nurbs_destroy(h);
    gap = -1;
    CHECK_NO_HANDLE(h, nurbs_join(3, parts, 0, 2.5, 0, &gap, &h), NURBS_ERROR_GAP,
                    "parts[2]|3 away|parts[1]|2.5");
    CHECK_DOUBLE(gap, -1);
    CHECK_OK(nurbs_join(3, parts, 0, 2.5, NURBS_KEEP_GAPS, &gap, &h));
    CHECK_DOUBLE(gap, 3);
    CHECK_KNOTS(h, 0, VALUES(0, 0, 1, 4, 4, 5, 5));
    CHECK_POINTS(h, VALUES(0, 2, 3, 0, 2));
    nurbs_destroy(h);
    CHECK_OK(nurbs_join(3, parts, 0, INFINITY, 0, &gap, &h));
    CHECK_POINTS(h, VALUES(0, 2, 3, 2));
    nurbs_destroy(h);
    nurbs_destroy(a);
    nurbs_destroy(b);
}

/* One factor carries the weights on; polynomial parts have weight 1. */
static void weights(void) {
    nurbs *a = line(0, 1, 0, 2, 1, 3), *b = line(1, 2, 2, 5, 0.5, 2), *c = line(2, 3, 5, 6, 0, 0), *h = NULL;
    const nurbs *parts[] = {a, b, c};
    CHECK_OK(nurbs_join(3, parts, 0, 0, 0, NULL, &h));
    CHECK_KNOTS(h, 0, VALUES(0, 0, 1, 2, 3, 3));
    CHECK_POINTS(h, VALUES(0, 2, 5, 6));
    CHECK_WEIGHTS(h, VALUES(1, 3, 12, 12));
    nurbs_destroy(h);
    nurbs_destroy(a);
    nurbs_destroy(b);
    nurbs_destroy(c);
}

static void other_forms(void) {
    nurbs *g = make(stairs()), *h = NULL;
    const nurbs *twice[] = {g, g};
    CHECK_OK(nurbs_join(2, twice, 0, 0, 0, NULL, &h)); /* degree 0 meets nowhere */
    CHECK_KNOTS(h, 0, VALUES(0, 1, 2, 3, 4, 5, 6));
    CHECK_POINTS(h, VALUES(10, 20, 30, 10, 20, 30));
    nurbs_destroy(h);
    nurbs_destroy(g);
    g = make(hill()); /* unclamped: inner ends are clamped, outer ones stay */
    twice[0] = twice[1] = g;
    CHECK_OK(nurbs_join(2, twice, 0, 0, 0, NULL, &h));
    CHECK_KNOTS(h, 0, VALUES(0, 1, 2, 3, 4, 5, 5, 6, 7, 8, 9, 10));
    CHECK_POINTS(h, VALUES(0, 2, 4, 2, 1, 2, 4, 2, 0));
    nurbs_destroy(h);
    nurbs_destroy(g);
}

/* A line, a parabola, a jump of degree 0: all become parabolas. */
static void other_degrees(void) {
    static const int32_t two = 2, degrees[] = {1, 2};
    nurbs *a = line(0, 1, 0, 2, 0, 0), *b = NULL, *s = make(stairs()), *h = NULL;
    CHECK_OK(nurbs_create_bezier(1, &two, 1, VALUES(2, 3, 5), 0, 0, NULL, 0, &b));
    const nurbs *parts[] = {a, b, s};
    CHECK_OK(nurbs_join(2, parts, 0, 0, 0, NULL, &h));
    CHECK_KNOTS(h, 0, VALUES(0, 0, 0, 1, 1, 2, 2, 2));
    CHECK_POINTS(h, VALUES(0, 1, 2, 3, 5));
    nurbs_destroy(h);
    CHECK_OK(nurbs_join(3, parts, 0, 0, NURBS_KEEP_GAPS, NULL, &h));
    CHECK_POINTS(h, VALUES(0, 1, 2, 3, 5, 10, 10, 10, 20, 20, 20, 30, 30, 30));
    nurbs_destroy(h);
    nurbs_destroy(a);
    nurbs_destroy(b);
    nurbs_destroy(s);
    /* across the axis, too: the patches (u, v) and (u, v^2 ...) meet in the edge u = 1, a line */
    a = make(patch());
    CHECK_OK(nurbs_create_bezier(2, degrees, 3,
                                 VALUES(1, 0, 0, 1, 0.5, 0.5, 1, 1, 1, 2, 0, 0, 2, 0.5, 1, 2, 1, 2), 0, 0,
                                 NULL, 0, &b));
    parts[0] = a;
    parts[1] = b;
    CHECK_OK(nurbs_join(2, parts, 0, 0, 0, NULL, &h));
    CHECK_KNOTS(h, 0, VALUES(0, 0, 1, 2, 2));
    CHECK_KNOTS(h, 1, VALUES(0, 0, 0, 1, 1, 1));
    CHECK_POINTS(
        h, VALUES(0, 0, 0, 0, 0.5, 0, 0, 1, 0, 1, 0, 0, 1, 0.5, 0.5, 1, 1, 1, 2, 0, 0, 2, 0.5, 1, 2, 1, 2));
    nurbs_destroy(h);
    nurbs_destroy(a);
    nurbs_destroy(b);
}

static void incompatible(void) {
    nurbs *a = make(arch()), *b = make(twist()), *p = make(patch()), *t = make(trough());
    nurbs *h = NULL;
    const nurbs *parts[] = {a, b};
    CHECK_NO_HANDLE(h, nurbs_join(2, parts, 0, 0, 0, NULL, &h), NURBS_ERROR_INCOMPATIBLE,
                    "parts[1]|dimension 3|2");
    parts[1] = p;
    CHECK_NO_HANDLE(h, nurbs_join(2, parts, 0, 0, 0, NULL, &h), NURBS_ERROR_INCOMPATIBLE, "parts[1]|2 axes");
    parts[0] = t;
    CHECK_NO_HANDLE(h, nurbs_join(2, parts, 0, 0, 0, NULL, &h), NURBS_ERROR_INCOMPATIBLE,
                    "parts[1]: count 2 on axis 1, expected 4");
    nurbs_destroy(b);
    CHECK_OK(nurbs_refine(p, 1, 1, VALUES(0.5), &b));
    parts[0] = p;
    parts[1] = b;
    CHECK_NO_HANDLE(h, nurbs_join(2, parts, 0, 9, 0, NULL, &h), NURBS_ERROR_INCOMPATIBLE,
                    "parts[1]|count 3|axis 1|2");
    nurbs_destroy(a);
    CHECK_OK(nurbs_refine(p, 1, 1, VALUES(0.25), &a));
    parts[0] = a;
    CHECK_NO_HANDLE(h, nurbs_join(2, parts, 0, 9, 0, NULL, &h), NURBS_ERROR_INCOMPATIBLE,
                    "parts[1]: knots[2] = 0.5 on axis 1, expected 0.25");
    nurbs_destroy(a);
    nurbs_destroy(b);
    nurbs_destroy(p);
    nurbs_destroy(t);
}

/* Weights 1, 2 at the end of the first patch, 1, 1 at the start of the second one, at the same points. */
static void weights_that_do_not_match(void) {
    static const int32_t degrees[] = {1, 1};
    nurbs *parts[2] = {NULL, NULL}, *h = NULL;
    CHECK_OK(nurbs_create_bezier(2, degrees, 2, VALUES(0, 0, 0, 1, 1, 0, 1, 1), 0, 0, VALUES(1, 1, 1, 2), 0,
                                 &parts[0]));
    CHECK_OK(nurbs_create_bezier(2, degrees, 2, VALUES(1, 0, 1, 1, 2, 0, 2, 1), 0, 0, VALUES(1, 1, 1, 1), 0,
                                 &parts[1]));
    CHECK_NO_HANDLE(h, nurbs_join(2, (const nurbs *const *)parts, 0, 0, 0, NULL, &h),
                    NURBS_ERROR_INCOMPATIBLE, "parts[1]: its first weights|not a multiple|parts[0]|0.5");
    nurbs_destroy(parts[0]);
    nurbs_destroy(parts[1]);
}

/* A part of 1e-9 moved to 1e9 has no room there. */
static void no_room(void) {
    nurbs *a = line(0, 1e9, 0, 2, 0, 0), *b = line(0, 1e-9, 2, 3, 0, 0), *h = NULL;
    const nurbs *parts[] = {a, b};
    CHECK_NO_HANDLE(h, nurbs_join(2, parts, 0, 0, 0, NULL, &h), NURBS_ERROR_KNOTS_MERGE,
                    "parts[1]|knots[1] = 0|knots[2] = 1e-09");
    nurbs_destroy(a);
    nurbs_destroy(b);
}

static void overflowing_knots(void) {
    nurbs *a = line(0, 1e308, 0, 2, 0, 0), *b = line(-1e308, 0, 2, 3, 0, 0), *c = line(0, 1, 2, 3, 0, 0),
          *h = NULL;
    const nurbs *same[] = {a, a}, *wide[] = {b, a, c};
    CHECK_NO_HANDLE(h, nurbs_join(2, same, 0, 2, 0, NULL, &h), NURBS_ERROR_NOT_REPRESENTABLE, "parts[1]");
    CHECK_NO_HANDLE(h, nurbs_join(2, wide, 0, 3, 0, NULL, &h), NURBS_ERROR_NOT_REPRESENTABLE, "parts[1]");
    nurbs_destroy(a);
    nurbs_destroy(b);
    nurbs_destroy(c);
}

/* Where the weight is 0 the control points may differ. */
static void points_without_weight(void) {
    static const int32_t degrees[] = {1, 2};
    nurbs *parts[2] = {NULL, NULL}, *h = NULL;
    double gap = -1;
    CHECK_OK(nurbs_create_bezier(2, degrees, 2, VALUES(0, 0, 0, 1, 0, 2, 1, 0, 9, 9, 1, 2), 0, 0,
                                 VALUES(1, 1, 1, 1, 0, 1), 0, &parts[0]));
    CHECK_OK(nurbs_create_bezier(2, degrees, 2, VALUES(1, 0, 5, 5, 1, 2, 2, 0, 2, 1, 2, 2), 0, 0,
                                 VALUES(1, 0, 1, 1, 1, 1), 0, &parts[1]));
    CHECK_OK(nurbs_join(2, (const nurbs *const *)parts, 0, 0, 0, &gap, &h));
    CHECK_DOUBLE(gap, 0);
    CHECK_POINTS(h, VALUES(0, 0, 0, 1, 0, 2, 1, 0, 9, 9, 1, 2, 2, 0, 2, 1, 2, 2));
    CHECK_WEIGHTS(h, VALUES(1, 1, 1, 1, 0, 1, 1, 1, 1));
    nurbs_destroy(h);
    nurbs_destroy(parts[0]);
    nurbs_destroy(parts[1]);
}

static void bad_arguments(void) {
    nurbs *a = make(arch()), *h = NULL;
    const nurbs *parts[] = {a, NULL};
    CHECK_NO_HANDLE(h, nurbs_join(2, parts, 0, 0, 0, NULL, &h), NURBS_ERROR_NULL, "parts[1]");
    CHECK_NO_HANDLE(h, nurbs_join(1, NULL, 0, 0, 0, NULL, &h), NURBS_ERROR_NULL, "parts");
    CHECK_NO_HANDLE(h, nurbs_join(0, parts, 0, 0, 0, NULL, &h), NURBS_ERROR_COUNT, "count = 0");
    CHECK_NO_HANDLE(h, nurbs_join(1, parts, 1, 0, 0, NULL, &h), NURBS_ERROR_AXIS, "axis = 1");
    CHECK_NO_HANDLE(h, nurbs_join(1, parts, 0, -1, 0, NULL, &h), NURBS_ERROR_TOLERANCE, "tolerance = -1");
    CHECK_NO_HANDLE(h, nurbs_join(1, parts, 0, NAN, 0, NULL, &h), NURBS_ERROR_TOLERANCE, "tolerance = nan");
    CHECK_NO_HANDLE(h, nurbs_join(1, parts, 0, 0, 1, NULL, &h), NURBS_ERROR_FLAGS, "flags = 0x1");
    CHECK_FAILS(nurbs_join(1, parts, 0, 0, 0, NULL, NULL), NURBS_ERROR_NULL, "out");
    nurbs_destroy(a);
}

int main(void) {
    meeting_ends();
    weights();
    other_forms();
    other_degrees();
    incompatible();
    weights_that_do_not_match();
    no_room();
    overflowing_knots();
    points_without_weight();
    bad_arguments();
    return check_summary("join");
}
