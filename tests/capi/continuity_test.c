/* SPDX-License-Identifier: MIT */
/* nurbs_continuity() and nurbs_continuity_between(). */
#include "check.h"
#include "shapes.h"

#include <stdint.h>

#define VALUES(...) ((const double[]){__VA_ARGS__})

typedef struct Rows {
    double knots[8], gaps[8], angles[8], curvatures[8];
    int32_t knot_orders[8], orders[8], geometric[8];
    int64_t count;
} Rows;

static Rows rows_of(const nurbs *g, int32_t axis) {
    Rows r;
    FILL(r.orders);
    CHECK_OK(nurbs_continuity(g, axis, 0, 0, 0, 8, r.knots, r.knot_orders, r.orders, r.geometric, r.gaps,
                              r.angles, r.curvatures, &r.count));
    return r;
}

static void check_row(Rows r, int i, int32_t knot_order, int32_t order, int32_t geometric) {
    CHECK_INT(r.knot_orders[i], knot_order);
    CHECK_INT(r.orders[i], order);
    CHECK_INT(r.geometric[i], geometric);
}

static void curves(void) {
    nurbs *g = make(circle());
    Rows r = rows_of(g, 0);
    CHECK_INT(r.count, 4);
    CHECK_DOUBLES(r.knots, VALUES(0.25, 0.5, 0.75, 1), 4);
    for (int i = 0; i < 3; ++i) { /* quarters of one speed: C^1, as is well known, and round */
        check_row(r, i, 0, 1, 2);
        CHECK(r.angles[i] <= 1e-15 && r.curvatures[i] <= 1e-14);
    }
    check_row(r, 3, -1, 1, 2); /* the seam */
    nurbs_destroy(g);
    g = make(jump());
    r = rows_of(g, 0);
    CHECK_INT(r.count, 1);
    check_row(r, 0, -1, -1, -1);
    CHECK_DOUBLE(r.gaps[0], 4);
    nurbs_destroy(g);
    g = make(loop());
    r = rows_of(g, 0);
    CHECK_INT(r.count, 4);
    check_row(r, 3, 1, 1, 2); /* by symmetry */
    CHECK_DOUBLE(r.knots[3], 6);
    nurbs_destroy(g);
    g = make(stairs());
    r = rows_of(g, 0);
    CHECK_INT(r.count, 2);
    check_row(r, 1, -1, -1, -1);
    nurbs_destroy(g);
}

/* A straight line with a control point 1e-13 beside it, at any scale of points and knots: no break of
 * curvature. */
static void nearly_straight(void) {
    static const int32_t degree = 3;
    static const int64_t count = 7;
    static const double line[] = {0, 0, 1, 0, 2, 0, 3, 0, 4, 1e-13, 5, 0, 6, 0};
    static const double params[] = {0, 0, 0, 0, 0.5, 0.5, 0.5, 1, 1, 1, 1};
    for (int i = 0; i < 9; ++i) {
        const double size = i % 3 == 0 ? 1e-6 : i % 3 == 1 ? 1 : 1e6, speed = i < 3 ? 1e-9 : i < 6 ? 1 : 1e3;
        double points[14], knots[11];
        nurbs *g = NULL;
        int32_t geometric = -1;
        for (int k = 0; k < 14; ++k) {
            points[k] = size * line[k];
        }
        for (int k = 0; k < 11; ++k) {
            knots[k] = speed * params[k];
        }
        for (int bent = 0; bent < 2; ++bent) { /* by 1e-3 of its length it is one */
            points[11] = bent * 1e-3 * size;
            CHECK_OK(nurbs_create(1, &degree, &count, knots, 11, 2, points, 0, 0, NULL, 0, 0, &g));
            CHECK_OK(nurbs_continuity(g, 0, 1e-9 * size, 1e-9, 1e-9, 1, NULL, NULL, NULL, &geometric, NULL,
                                      NULL, NULL, NULL));
            CHECK_INT(geometric, bent == 0 ? 2 : 1);
            nurbs_destroy(g);
        }
    }
}

/* A corner of 90 degrees, and a curve that stops and goes on. */
static void degenerate(void) {
    static const int32_t degree = 2;
    static const int64_t count = 5;
    static const double knots[] = {0, 0, 0, 1, 1, 2, 2, 2};
    static const double corner[] = {0, 0, 1, 0, 2, 0, 2, 1, 2, 2}, stop[] = {0, 0, 1, 0, 1, 0, 1, 0, 2, 1};
    nurbs *g = NULL;
    CHECK_OK(nurbs_create(1, &degree, &count, knots, 8, 2, corner, 0, 0, NULL, 0, 0, &g));
    Rows r = rows_of(g, 0);
    CHECK_INT(r.count, 1);
    check_row(r, 0, 0, 0, 0);
    CHECK_NEAR(r.angles, VALUES(1.5707963267948966), 1, 1e-15);
    nurbs_destroy(g);
    CHECK_OK(nurbs_create(1, &degree, &count, knots, 8, 2, stop, 0, 0, NULL, 0, 0, &g));
    r = rows_of(g, 0);
    check_row(r, 0, 0, 1, 0); /* both derivatives are 0: C^1, but a corner */
    CHECK_NEAR(r.angles, VALUES(0.78539816339744828), 1, 1e-15);
    CHECK(isnan(r.curvatures[0]));
    nurbs_destroy(g);
}

static void surfaces(void) {
    nurbs *g = make(trough());
    Rows r = rows_of(g, 1); /* linear across, so smooth in spite of its knots */
    CHECK_INT(r.count, 2);
    check_row(r, 0, 0, 1, 1);
    r = rows_of(g, 0);
    CHECK_INT(r.count, 0);
    nurbs_destroy(g);
    static const int32_t degrees[] = {1, 1};
    static const int64_t counts[] = {3, 2};
    static const double knots[] = {0, 0, 1, 2, 2, 0, 0, 1, 1};
    static const double roof[] = {0, 0, 0, 0, 1, 0, 1, 0, 1, 1, 1, 1, 2, 0, 0, 2, 1, 0};
    CHECK_OK(nurbs_create(2, degrees, counts, knots, 9, 3, roof, 0, 0, NULL, 0, 0, &g));
    r = rows_of(g, 0);
    CHECK_INT(r.count, 1);
    check_row(r, 0, 0, 0, 0);
    CHECK_NEAR(r.angles, VALUES(1.5707963267948966), 1, 1e-15);
    CHECK(isnan(r.curvatures[0]));
    nurbs_destroy(g);
    g = make(cube());
    r = rows_of(g, 2);
    CHECK_INT(r.count, 0);
    nurbs_destroy(g);
}

/* A line into the circle: G1, and the curvature jumps from 0 to 1. */
static void between(void) {
    static const double points[] = {1, -2, 1, 0};
    static const int32_t degree = 1;
    nurbs *c = make(circle()), *l = NULL, *t = make(twist());
    int32_t order = -7, geometric = -7;
    double gap = -7, angle = -7, curvature = -7;
    CHECK_OK(nurbs_create_bezier(1, &degree, 2, points, 0, 0, NULL, 0, &l));
    CHECK_OK(nurbs_continuity_between(l, NURBS_END, c, NURBS_START, 0, 0, 0, &order, &geometric, &gap, &angle,
                                      &curvature));
    CHECK_INT(order, 0);
    CHECK_INT(geometric, 1);
    CHECK_DOUBLE(gap, 0);
    CHECK_NEAR(&angle, VALUES(0), 1, 1e-15);
    CHECK_NEAR(&curvature, VALUES(1), 1, 1e-14);
    CHECK_OK(
        nurbs_continuity_between(l, NURBS_END, c, NURBS_END, 0, 0, 0, NULL, &geometric, NULL, &angle, NULL));
    CHECK_INT(geometric, 0);
    CHECK_NEAR(&angle, VALUES(3.1415926535897931), 1, 1e-15);
    CHECK_OK(nurbs_continuity_between(l, NURBS_START, c, NURBS_START, 2, INFINITY, INFINITY, &order,
                                      &geometric, &gap, NULL, NULL));
    CHECK_DOUBLE(gap, 2);
    CHECK_INT(order, 2);
    CHECK_INT(geometric, 2);
    CHECK_FAILS(nurbs_continuity_between(l, 2, c, 0, 0, 0, 0, &order, NULL, NULL, NULL, NULL),
                NURBS_ERROR_END, "end_a = 2");
    CHECK_FAILS(nurbs_continuity_between(l, 0, c, -1, 0, 0, 0, &order, NULL, NULL, NULL, NULL),
                NURBS_ERROR_END, "end_b = -1");
    CHECK_FAILS(nurbs_continuity_between(l, 0, t, 0, 0, 0, 0, &order, NULL, NULL, NULL, NULL),
                NURBS_ERROR_INCOMPATIBLE, "dimension 3|2");
    CHECK_FAILS(nurbs_continuity_between(l, 0, c, 0, 0, -1, 0, &order, NULL, NULL, NULL, NULL),
                NURBS_ERROR_TOLERANCE, "derivative_tolerance = -1");
    CHECK_FAILS(nurbs_continuity_between(NULL, 0, c, 0, 0, 0, 0, &order, NULL, NULL, NULL, NULL),
                NURBS_ERROR_NULL, "a");
    CHECK_FAILS(nurbs_continuity_between(l, 0, NULL, 0, 0, 0, 0, &order, NULL, NULL, NULL, NULL),
                NURBS_ERROR_NULL, "b");
    nurbs_destroy(t);
    t = make(patch());
    CHECK_FAILS(nurbs_continuity_between(l, 0, t, 0, 0, 0, 0, &order, NULL, NULL, NULL, NULL),
                NURBS_ERROR_AXES, "b has 2 axes");
    nurbs_destroy(c);
    nurbs_destroy(l);
    nurbs_destroy(t);
}

/* One line in two parts: as smooth as its degree says. */
static void as_far_as_the_degree(void) {
    static const double first[] = {0, 0, 1, 2}, second[] = {1, 2, 2, 4};
    static const int32_t degree = 1;
    nurbs *a = NULL, *b = NULL;
    int32_t order = -7, geometric = -7;
    CHECK_OK(nurbs_create_bezier(1, &degree, 2, first, 0, 0, NULL, 0, &a));
    CHECK_OK(nurbs_create_bezier(1, &degree, 2, second, 0, 0, NULL, 0, &b));
    CHECK_OK(nurbs_continuity_between(a, NURBS_END, b, NURBS_START, 0, 0, 0, &order, &geometric, NULL, NULL,
                                      NULL));
    CHECK_INT(order, 1);
    CHECK_INT(geometric, 2);
    nurbs_destroy(b);
    nurbs_destroy(a);
}

static void bad_arguments(void) {
    nurbs *g = make(circle());
    double knots[4];
    int64_t count = -7;
    FILL(knots);
    CHECK_FAILS(nurbs_continuity(g, 0, 0, 0, 0, 3, knots, NULL, NULL, NULL, NULL, NULL, NULL, &count),
                NURBS_ERROR_SIZE, "cap = 3|4");
    CHECK_FAILS(nurbs_continuity(g, 0, 0, 0, 0, -1, knots, NULL, NULL, NULL, NULL, NULL, NULL, &count),
                NURBS_ERROR_COUNT, "cap = -1");
    CHECK_FAILS(nurbs_continuity(g, 0, 0, 0, NAN, 4, knots, NULL, NULL, NULL, NULL, NULL, NULL, &count),
                NURBS_ERROR_TOLERANCE, "angle_tolerance = nan");
    CHECK_FAILS(nurbs_continuity(g, 1, 0, 0, 0, 4, knots, NULL, NULL, NULL, NULL, NULL, NULL, &count),
                NURBS_ERROR_AXIS, "axis = 1");
    CHECK_FAILS(nurbs_continuity(g, 0, 0, 0, 0, 4, knots, NULL, NULL, NULL, knots, NULL, NULL, &count),
                NURBS_ERROR_OVERLAP, "position_gaps|knots");
    CHECK_FAILS(nurbs_continuity(NULL, 0, 0, 0, 0, 4, knots, NULL, NULL, NULL, NULL, NULL, NULL, &count),
                NURBS_ERROR_NULL, "g");
    CHECK_UNTOUCHED(knots);
    CHECK_INT(count, -7);
    nurbs_destroy(g);
}

int main(void) {
    curves();
    nearly_straight();
    degenerate();
    surfaces();
    between();
    as_far_as_the_degree();
    bad_arguments();
    return check_summary("continuity");
}
