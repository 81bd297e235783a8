/* SPDX-License-Identifier: MIT */
/* nurbs_refine(), nurbs_refine_uniform() and nurbs_refinement_matrix(). */
#include "check.h"
#include "shapes.h"

#include <stdint.h>

#define VALUES(...) ((const double[]){__VA_ARGS__})

/* A list gives what its knots one after the other give. */
static void lists(void) {
    nurbs *g = make(arch()), *h = NULL;
    CHECK_OK(nurbs_refine(g, 0, 4, VALUES(0.75, 0.5, 0.5, 0.5), &h));
    CHECK_KNOTS(h, 0, VALUES(0, 0, 0, 0, 0.5, 0.5, 0.5, 0.75, 1, 1, 1, 1));
    CHECK_POINTS(h, VALUES(0, 0, 0.5, 1, 1.25, 1.5, 2, 1.5, 2.375, 1.5, 3.125, 1.25, 3.75, 0.5, 4, 0));
    nurbs_destroy(h);
    CHECK_OK(nurbs_refine(g, 0, 0, NULL, &h));
    CHECK_POINTS(h, arch().points);
    nurbs_destroy(h);
    nurbs_destroy(g);
    g = make(stairs());
    CHECK_OK(nurbs_refine(g, 0, 2, VALUES(2.5, 0.5), &h));
    CHECK_KNOTS(h, 0, VALUES(0, 0.5, 1, 2, 2.5, 3));
    CHECK_POINTS(h, VALUES(10, 10, 20, 30, 30));
    nurbs_destroy(h);
    nurbs_destroy(g);
    g = make(loop());
    CHECK_OK(nurbs_refine(g, 0, 2, VALUES(6, 2.5), &h)); /* the end is the start */
    CHECK_KNOTS(h, 0, VALUES(0, 1, 2, 2, 2.5, 3, 4, 5, 6, 6, 6.5));
    nurbs_destroy(h);
    nurbs_destroy(g);
}

static void uniform(void) {
    nurbs *g = make(trough()), *h = NULL;
    CHECK_OK(nurbs_refine_uniform(g, 1, 2, &h));
    CHECK_KNOTS(h, 1, VALUES(0, 0, 0.5, 1, 1.5, 2, 2.5, 3, 3));
    nurbs_destroy(h);
    CHECK_OK(nurbs_refine_uniform(g, 0, 1, &h));
    CHECK_POINTS(h, trough().points);
    nurbs_destroy(h);
    CHECK_NO_HANDLE(h, nurbs_refine_uniform(g, 0, 0, &h), NURBS_ERROR_COUNT, "parts = 0|1");
    CHECK_NO_HANDLE(h, nurbs_refine_uniform(g, 0, INT64_MIN, &h), NURBS_ERROR_COUNT, "parts");
    CHECK_NO_HANDLE(h, nurbs_refine_uniform(g, 1, INT64_MAX, &h), NURBS_ERROR_OVERFLOW, "knots");
    CHECK_NO_HANDLE(h, nurbs_refine_uniform(g, 2, 2, &h), NURBS_ERROR_AXIS, "axis = 2");
    CHECK_NO_HANDLE(h, nurbs_refine_uniform(NULL, 0, 2, &h), NURBS_ERROR_NULL, "g");
    CHECK_FAILS(nurbs_refine_uniform(g, 0, 2, NULL), NURBS_ERROR_NULL, "out");
    nurbs_destroy(g);
    /* A span of two units of rounding has room for one knot. */
    SplineArgs a = jump();
    static const double knots[] = {0, 0, 1, 1, 1 + 0x1p-51, 1 + 0x1p-51};
    a.knots = knots;
    g = make(a);
    CHECK_OK(nurbs_refine_uniform(g, 0, 2, &h));
    nurbs_destroy(h);
    CHECK_NO_HANDLE(h, nurbs_refine_uniform(g, 0, 3, &h), NURBS_ERROR_NOT_REPRESENTABLE, "parts = 3|[1, ");
    nurbs_destroy(g);
}

static void matrices(void) {
    static const double knots[] = {0.5, 0.25};
    nurbs *g = make(patch());
    int64_t entries = -1, columns[8], rows[5];
    double values[8];
    CHECK_OK(nurbs_refinement_matrix(g, 1, 2, knots, 0, NULL, NULL, NULL, &entries));
    CHECK_INT(entries, 6);
    CHECK_OK(nurbs_refinement_matrix(g, 1, 2, knots, 6, values, columns, rows, &entries));
    CHECK_DOUBLES(values, VALUES(1, 0.75, 0.25, 0.5, 0.5, 1), 6);
    static const int64_t want_columns[] = {0, 0, 1, 0, 1, 1}, want_rows[] = {0, 1, 3, 5, 6};
    CHECK_BITS(columns, want_columns, sizeof want_columns);
    CHECK_BITS(rows, want_rows, sizeof want_rows);
    FILL(values);
    FILL(columns);
    FILL(rows);
    CHECK_FAILS(nurbs_refinement_matrix(g, 1, 2, knots, 5, values, columns, rows, NULL), NURBS_ERROR_SIZE,
                "cap = 5|6");
    CHECK_FAILS(nurbs_refinement_matrix(g, 1, 2, knots, -1, values, columns, rows, NULL), NURBS_ERROR_COUNT,
                "cap");
    CHECK_FAILS(nurbs_refinement_matrix(g, 1, 2, knots, 8, values, (int64_t *)(void *)values, rows, NULL),
                NURBS_ERROR_OVERLAP, "values|columns");
    CHECK_FAILS(nurbs_refinement_matrix(g, 1, 2, NULL, 8, values, columns, rows, NULL), NURBS_ERROR_NULL,
                "knots");
    CHECK_FAILS(nurbs_refinement_matrix(NULL, 1, 2, knots, 8, values, columns, rows, NULL), NURBS_ERROR_NULL,
                "g");
    CHECK_FAILS(nurbs_refinement_matrix(g, -1, 2, knots, 8, values, columns, rows, NULL), NURBS_ERROR_AXIS,
                "axis = -1");
    CHECK_UNTOUCHED(values);
    CHECK_UNTOUCHED(columns);
    CHECK_UNTOUCHED(rows);
    nurbs_destroy(g);
}

static void bad_lists(void) {
    static const double good[] = {2.5, 4, 3.5, 2.25};
    nurbs *g = make(hill()), *h = NULL;
    CHECK_NO_HANDLE(h, nurbs_refine(g, 0, 4, edited(good, 4, 2, NAN), &h), NURBS_ERROR_PARAMETER_NOT_FINITE,
                    "knots[2]|nan");
    CHECK_NO_HANDLE(h, nurbs_refine(g, 0, 4, edited(good, 4, 3, INFINITY), &h),
                    NURBS_ERROR_PARAMETER_NOT_FINITE, "knots[3]|inf");
    CHECK_NO_HANDLE(h, nurbs_refine(g, 0, 4, edited(good, 4, 0, 1.5), &h), NURBS_ERROR_OUTSIDE_DOMAIN,
                    "knots[0] = 1.5|[2, 5]|axis 0");
    CHECK_NO_HANDLE(h, nurbs_refine(g, 0, 4, VALUES(4, 3, 4, 4), &h), NURBS_ERROR_MULTIPLICITY,
                    "knots[3] = 4|1 on axis 0|occur 4 times|allows 3");
    CHECK_NO_HANDLE(h, nurbs_refine(g, 0, -1, good, &h), NURBS_ERROR_COUNT, "count = -1");
    CHECK_NO_HANDLE(h, nurbs_refine(g, 0, INT64_MAX, good, &h), NURBS_ERROR_OVERFLOW, "knots");
    CHECK_NO_HANDLE(h, nurbs_refine(g, 0, 1, NULL, &h), NURBS_ERROR_NULL, "knots");
    CHECK_NO_HANDLE(h, nurbs_refine(g, 1, 4, good, &h), NURBS_ERROR_AXIS, "axis = 1");
    CHECK_NO_HANDLE(h, nurbs_refine(NULL, 0, 4, good, &h), NURBS_ERROR_NULL, "g");
    CHECK_FAILS(nurbs_refine(g, 0, 4, good, NULL), NURBS_ERROR_NULL, "out");
    CHECK_POINTS(g, hill().points);
    nurbs_destroy(g);
}

int main(void) {
    lists();
    uniform();
    matrices();
    bad_lists();
    return check_summary("refine");
}
