/* SPDX-License-Identifier: MIT */
/* The C interface from C99: create, evaluate a batch, insert a knot, and be told what is wrong. */
#include <nurbs/nurbs.h>

#include <float.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

static int failures = 0;

#define EXPECT(condition)                                                                                    \
    do {                                                                                                     \
        if (!(condition)) {                                                                                  \
            printf("%s:%d: %s\n", __FILE__, __LINE__, #condition);                                           \
            ++failures;                                                                                      \
        }                                                                                                    \
    } while (0)

enum { SAMPLES = 1001 };

/* The unit circle as four rational quadratic quarters. */
static nurbs *circle(void) {
    static const double points[9][2] = {{1, 0},   {1, 1},  {0, 1},  {-1, 1}, {-1, 0},
                                        {-1, -1}, {0, -1}, {1, -1}, {1, 0}};
    const double s = sqrt(0.5);
    const double weights[9] = {1, s, 1, s, 1, s, 1, s, 1};
    const int32_t degree = 2;
    const int64_t count = 9;
    double knots[12];
    nurbs *g = NULL;
    EXPECT(nurbs_knots_bezier(2, 4, NULL, 12, knots) == NURBS_OK);
    EXPECT(nurbs_create(1, &degree, &count, knots, 12, 2, points[0], 0, 0, weights, 0, 0, &g) == NURBS_OK);
    return g;
}

static void fill_params(double *params) {
    int i;
    for (i = 0; i < SAMPLES; ++i) {
        params[i] = i / (SAMPLES - 1.0);
    }
}

static void known_points(const nurbs *g) {
    const double params[4] = {0.0, 0.25, 0.5, 0.75};
    const double expected[8] = {1, 0, 0, 1, -1, 0, 0, -1};
    double points[8] = {0}, columns[8] = {0};
    int i;
    EXPECT(nurbs_eval(g, 4, params, 0, 0, points, 0, 0, 0) == NURBS_OK);
    EXPECT(nurbs_eval(g, 4, params, 0, 0, columns, 1, 4, 0) == NURBS_OK);
    for (i = 0; i < 4; ++i) {
        EXPECT(points[2 * i] == expected[2 * i] && points[2 * i + 1] == expected[2 * i + 1]);
        EXPECT(columns[i] == expected[2 * i] && columns[4 + i] == expected[2 * i + 1]);
    }
}

static void insertion_keeps_the_circle(const nurbs *g) {
    static double params[SAMPLES], before[2 * SAMPLES], after[2 * SAMPLES];
    nurbs *finer = NULL;
    int64_t count = 0;
    int i;
    fill_params(params);
    EXPECT(nurbs_insert_knot(g, 0, 0.3, 2, &finer) == NURBS_OK);
    EXPECT(nurbs_count(finer, 0, &count) == NURBS_OK && count == 11);
    EXPECT(nurbs_eval(g, SAMPLES, params, 0, 0, before, 0, 0, 0) == NURBS_OK);
    EXPECT(nurbs_eval(finer, SAMPLES, params, 0, 0, after, 0, 0, 0) == NURBS_OK);
    for (i = 0; i < SAMPLES; ++i) {
        EXPECT(fabs(after[2 * i] - before[2 * i]) <= 8 * DBL_EPSILON);
        EXPECT(fabs(hypot(after[2 * i], after[2 * i + 1]) - 1) <= 8 * DBL_EPSILON);
    }
    nurbs_destroy(finer);
}

/* The same circle in one call, and what it is. */
static void shapes_are_one_call(const nurbs *g) {
    const double eighth = 0.125;
    double points[2][2], sizes[3];
    int32_t shape = NURBS_SHAPE_NONE;
    nurbs *made = NULL;
    EXPECT(nurbs_curve_circle(2, NULL, NULL, NULL, 1, NURBS_ARC_QUARTERS, &made) == NURBS_OK);
    EXPECT(nurbs_eval(g, 1, &eighth, 0, 0, points[0], 0, 0, 0) == NURBS_OK);
    EXPECT(nurbs_eval(made, 1, &eighth, 0, 0, points[1], 0, 0, 0) == NURBS_OK);
    EXPECT(hypot(points[0][0] - points[1][0], points[0][1] - points[1][1]) <= 8 * DBL_EPSILON);
    EXPECT(nurbs_recognize(g, 1e-12, &shape, NULL, sizes, NULL) == NURBS_OK);
    EXPECT(shape == NURBS_SHAPE_CIRCLE && fabs(sizes[0] - 1) <= 1e-12);
    nurbs_destroy(made);
}

static void errors_name_what_is_wrong(const nurbs *g) {
    double params[20] = {0}, points[40];
    char message[256];
    int64_t length;
    points[39] = 7;
    params[17] = 1.25;
    EXPECT(nurbs_eval(g, 20, params, 0, 0, points, 0, 0, 0) == NURBS_ERROR_OUTSIDE_DOMAIN);
    length = nurbs_last_error(message, (int64_t)sizeof message);
    printf("%s: %s\n", nurbs_status_name(NURBS_ERROR_OUTSIDE_DOMAIN), message);
    EXPECT(length == (int64_t)strlen(message));
    EXPECT(strstr(message, "params[17]") != NULL && strstr(message, "1.25") != NULL);
    EXPECT(strcmp(nurbs_status_name(NURBS_ERROR_OUTSIDE_DOMAIN), "NURBS_ERROR_OUTSIDE_DOMAIN") == 0);
    EXPECT(points[39] == 7);
}

static void flags_are_shifted_by_axis(void) {
    EXPECT(NURBS_ON_AXIS(2, NURBS_CLAMP) == 0x020000u);
    EXPECT(NURBS_ON_ALL_AXES(2, NURBS_LEFT) == 0x0101u);
}

int main(void) {
    nurbs *g = circle();
    EXPECT(g != NULL);
    known_points(g);
    insertion_keeps_the_circle(g);
    shapes_are_one_call(g);
    errors_name_what_is_wrong(g);
    flags_are_shifted_by_axis();
    nurbs_destroy(g);
    return failures == 0 ? 0 : 1;
}
