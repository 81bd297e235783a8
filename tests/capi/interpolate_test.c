/* SPDX-License-Identifier: MIT */
/* nurbs_parametrize(), nurbs_interpolate(), nurbs_interpolate_over_knots() and nurbs_curve_interpolate(). */
#include "check.h"
#include "shapes.h"

#include <math.h>
#include <string.h>

#define VALUES(...) ((const double[]){__VA_ARGS__})

static const int64_t four = 4, five = 5;
static const int32_t cubic = 3, quadratic = 2;

/* Chords 3, 4, 5 of 12; a point twice. */
static void parameters(void) {
    static const double points[4][2] = {{0, 0}, {3, 0}, {3, 4}, {8, 4}},
                        twice[4][2] = {{0, 0}, {1, 0}, {1, 0}, {3, 0}};
    double params[4] = {-1, -1, -1, -1};
    CHECK_OK(nurbs_parametrize(1, &four, 2, points[0], 0, 0, NURBS_PARAMS_CHORD, 0, 0, params));
    CHECK_DOUBLES(params, VALUES(0, 0.25, 7 / 12.0, 1), 4);
    CHECK_OK(nurbs_parametrize(1, &four, 2, twice[0], 0, 0, NURBS_PARAMS_POWER, 1, 0, params));
    CHECK_DOUBLES(params, VALUES(0, 1 / 3.0, 1 / 3.0, 1), 4);
    CHECK_OK(nurbs_parametrize(1, &four, 2, twice[0], 0, 0, NURBS_PARAMS_POWER, 2, 0, params));
    CHECK_DOUBLES(params, VALUES(0, 0.2, 0.2, 1), 4);
    CHECK_OK(nurbs_parametrize(1, &four, 2, twice[0], 0, 0, NURBS_PARAMS_UNIFORM, NAN, 0, params));
    CHECK_DOUBLES(params, VALUES(0, 1 / 3.0, 2 / 3.0, 1), 4);
    CHECK_OK(
        nurbs_parametrize(1, &four, 1, VALUES(0, 4, 5, 9), 0, 0, NURBS_PARAMS_CENTRIPETAL, 0, 0, params));
    CHECK_DOUBLES(params, VALUES(0, 0.4, 0.6, 1), 4);
}

/* Right angles in a square: each step counts 1 + 3/2 (pi/2 / 2) times for every angle at its ends. */
static void angles(void) {
    static const double square[5][2] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}, {0, 0}};
    const double turn = 1.5 * 0.5 * 1.5707963267948966, whole = 4 + 6 * turn;
    double params[5];
    CHECK_OK(nurbs_parametrize(1, &five, 2, square[0], 0, 0, NURBS_PARAMS_FOLEY_NIELSON, 0, 0, params));
    for (int i = 0; i < 5; ++i) {
        const double wanted = i == 0 ? 0 : (i + (2 * i - 1 - (i == 4)) * turn) / whole;
        CHECK_NEAR(params + i, &wanted, 1, 1e-15);
    }
    CHECK_OK(nurbs_parametrize(1, &five, 2, square[0], 0, 0, NURBS_PARAMS_FOLEY_NIELSON, 0, NURBS_PERIODIC,
                               params));
    CHECK_NEAR(params, VALUES(0, 0.25, 0.5, 0.75, 1), 5, 2e-16);
}

/* Of quadratics: the maxima of 2 t (1 - t) + t (1 - t / 2), that is 2 / 3 of the first span, and of symmetric functions. */
static void universal_parameters(void) {
    double params[7] = {-7, -7, -7, -7, -7, -7, -7}, mirrored;
    CHECK_OK(nurbs_params_universal(2, 5, params));
    CHECK_NEAR(params, VALUES(0, 2 / 9.0, 0.5, 7 / 9.0, 1), 5, 1e-15);
    CHECK_OK(nurbs_params_universal(1, 5, params));
    CHECK_DOUBLES(params, VALUES(0, 0.25, 0.5, 0.75, 1), 5);
    CHECK_OK(nurbs_params_universal(0, 2, params));
    CHECK_DOUBLES(params, VALUES(0.25, 0.75), 2);
    CHECK_OK(nurbs_params_universal(3, 7, params));
    for (int i = 0; i < 3; ++i) {
        mirrored = 1 - params[i];
        CHECK_DOUBLES(params + 6 - i, &mirrored, 1);
    }
    CHECK(params[1] > 0 && params[1] < params[2] && params[2] < params[3]);
    CHECK_DOUBLES(params + 3, VALUES(0.5), 1);
    params[0] = -7;
    CHECK_FAILS(nurbs_params_universal(32, 40, params), NURBS_ERROR_DEGREE, "32");
    CHECK_FAILS(nurbs_params_universal(0, 1, params), NURBS_ERROR_COUNT, "count = 1|2");
    CHECK_FAILS(nurbs_params_universal(3, 3, params), NURBS_ERROR_TOO_FEW_POINTS, "3");
    CHECK_FAILS(nurbs_params_universal(3, 7, NULL), NURBS_ERROR_NULL, "params");
    CHECK_DOUBLES(params, VALUES(-7), 1);
}

/* Lines along axis 0 have chords 1 : 3 and no length; along axis 1 only the last one has a length. */
static void parameters_of_grids(void) {
    static const double points[3][2] = {{0, 7}, {1, 7}, {4, 7}};
    const int64_t counts[] = {3, 2};
    double params[5];
    CHECK_OK(nurbs_parametrize(2, counts, 1, points[0], 0, 0, NURBS_PARAMS_CHORD, 0, 0, params));
    CHECK_DOUBLES(params, VALUES(0, 0.25, 1, 0, 1), 5);
    CHECK_FAILS(
        nurbs_parametrize(2, counts, 1, VALUES(1, 2, 1, 2, 1, 2), 0, 0, NURBS_PARAMS_CHORD, 0, 0, params),
        NURBS_ERROR_LENGTH, "axis 0");
}

static void refused_parameters(void) {
    double params[4] = {5, 6, 7, 8};
    const int64_t none = 0;
    const double *points = VALUES(0, 1, 2, 3);
    CHECK_FAILS(nurbs_parametrize(1, &four, 1, points, 0, 0, 5, 0, 0, params), NURBS_ERROR_RULE, "rule = 5");
    CHECK_FAILS(nurbs_parametrize(1, &four, 1, points, 0, 0, NURBS_PARAMS_POWER, NAN, 0, params),
                NURBS_ERROR_FACTOR, "exponent|0 to 8");
    CHECK_FAILS(nurbs_parametrize(1, &four, 1, points, 0, 0, 1, 0, 2, params), NURBS_ERROR_FLAGS, "0x2");
    CHECK_FAILS(nurbs_parametrize(1, &none, 1, points, 0, 0, 1, 0, 0, params), NURBS_ERROR_COUNT,
                "counts[0] = 0");
    CHECK_FAILS(nurbs_parametrize(4, &four, 1, points, 0, 0, 1, 0, 0, params), NURBS_ERROR_AXES, "axes = 4");
    CHECK_FAILS(nurbs_parametrize(1, &four, 0, points, 0, 0, 1, 0, 0, params), NURBS_ERROR_DIMENSION,
                "dim = 0");
    CHECK_FAILS(nurbs_parametrize(1, NULL, 1, points, 0, 0, 1, 0, 0, params), NURBS_ERROR_NULL, "counts");
    CHECK_FAILS(nurbs_parametrize(1, &four, 1, NULL, 0, 0, 1, 0, 0, params), NURBS_ERROR_NULL, "points");
    CHECK_FAILS(nurbs_parametrize(1, &four, 1, points, 0, 0, 1, 0, 0, NULL), NURBS_ERROR_NULL, "params");
    CHECK_FAILS(nurbs_parametrize(1, &four, 1, points, -1, 0, 1, 0, 0, params), NURBS_ERROR_STRIDE, "point");
    union {
        int64_t counts[1];
        double params[4];
    } shared = {{4}};
    CHECK_FAILS(nurbs_parametrize(1, shared.counts, 1, points, 0, 0, 1, 0, 0, shared.params),
                NURBS_ERROR_OVERLAP, "params|counts");
    CHECK_FAILS(nurbs_parametrize(1, &four, 1, VALUES(0, NAN, 1, 2), 0, 0, 1, 0, 0, params),
                NURBS_ERROR_POINT_NOT_FINITE, "points[1][0]");
    CHECK_FAILS(nurbs_parametrize(1, &four, 1, params, 0, 0, 1, 0, 0, params), NURBS_ERROR_OVERLAP,
                "params|points");
    CHECK_DOUBLES(params, VALUES(5, 6, 7, 8), 4);
}

/* The parabola t^2, and its control points. */
static void a_parabola(void) {
    nurbs *g = NULL;
    double residual = -1;
    CHECK_OK(nurbs_interpolate(1, &quadratic, &five, VALUES(0, 1, 2, 3, 4), 1, VALUES(0, 1, 4, 9, 16), 0, 0,
                               NULL, 0, &residual, &g));
    CHECK_KNOTS(g, 0, VALUES(0, 0, 0, 1.5, 2.5, 4, 4, 4));
    CHECK(residual >= 0 && residual <= 1e-14);
    nurbs_destroy(g);
    CHECK_OK(nurbs_interpolate_over_knots(1, &quadratic, &four, VALUES(0, 1, 3, 4),
                                          VALUES(0, 0, 0, 2, 4, 4, 4), 7, 1, VALUES(0, 1, 9, 16), 0, 0, 0,
                                          &g));
    double made[4];
    CHECK_OK(nurbs_points(g, 4, made, 0, 0));
    CHECK_NEAR(made, VALUES(0, 0, 8, 16), 4, 1e-14);
    nurbs_destroy(g);
}

/* The natural cubic through 0, 1, 0: second derivatives vanish at its ends. */
static void a_natural_cubic(void) {
    nurbs *g = NULL;
    const int64_t three = 3;
    const int32_t ends[] = {NURBS_ENDS_NATURAL, NURBS_ENDS_NATURAL};
    double values[6];
    CHECK_OK(
        nurbs_interpolate(1, &cubic, &three, VALUES(0, 1, 2), 1, VALUES(0, 1, 0), 0, 0, ends, 0, NULL, &g));
    CHECK_KNOTS(g, 0, VALUES(0, 0, 0, 0, 1, 2, 2, 2, 2));
    CHECK_OK(nurbs_eval_derivs(g, 2, 2, VALUES(0, 2), 0, 0, values, 0, 0, 0));
    CHECK_NEAR(values, VALUES(0, 1.5, 0, 0, -1.5, 0), 6, 1e-14);
    nurbs_destroy(g);
}

/* Hermite's cubic of one piece, and a circle's worth of conditions in any order of the orders. */
static void conditions(void) {
    nurbs *g = NULL;
    const int32_t orders[] = {0, 1, 0, 1}, gaps[] = {0, 2, 0, 2}, wrong[] = {0, 0, 0, 1};
    CHECK_OK(nurbs_curve_interpolate(3, 4, VALUES(0, 0, 1, 1), orders, 1, VALUES(1, 3, 2, 6), 0, 0, NULL, 0,
                                     0, &g));
    CHECK_POINTS(g, VALUES(1, 2, 0, 2));
    nurbs_destroy(g);
    CHECK_OK(
        nurbs_curve_interpolate(3, 4, VALUES(0, 0, 1, 1), gaps, 1, VALUES(0, 0, 3, 0), 0, 0, NULL, 0, 0, &g));
    double line[4] = {0};
    CHECK_OK(nurbs_eval(g, 4, VALUES(0, 0.25, 0.5, 1), 0, 0, line, 0, 0, 0));
    CHECK_NEAR(line, VALUES(0, 0.75, 1.5, 3), 4, 1e-15);
    nurbs_destroy(g);
    CHECK_NO_HANDLE(g,
                    nurbs_curve_interpolate(3, 4, VALUES(0, 0, 1, 1), wrong, 1, line, 0, 0, NULL, 0, 0, &g),
                    NURBS_ERROR_ORDER, "orders[1] = 0|orders[0]");
    /* Four second derivatives say nothing about the place. */
    const int32_t seconds[] = {2, 2, 2, 2};
    CHECK_NO_HANDLE(
        g, nurbs_curve_interpolate(3, 4, VALUES(0, 0.25, 0.5, 1), seconds, 1, line, 0, 0, NULL, 0, 0, &g),
        NURBS_ERROR_RANK, "axis 0");
}

/* One cubic from (0, 0) to (1, 0) that starts along (1, 1) and ends along (1, -1), which are perpendicular: of the energy
   8 a^2 + 8 b^2 - 12 a - 12 b + 12 of tangents a (1, 1) and b (1, -1) the least one is at a = b = 3/4. In one dimension a
   direction is a sign, and the energy of slopes a and b is that of a line. */
static void directions(void) {
    nurbs *g = NULL;
    const int32_t orders[] = {0, NURBS_ORDER_DIRECTION, 0, NURBS_ORDER_DIRECTION};
    const double *at = VALUES(0, 0, 1, 1), *targets = VALUES(0, 0, 1, 1, 1, 0, 4, -4);
    double lengths[4] = {-7, -7, -7, -7};
    CHECK_OK(nurbs_tangent_lengths(3, 4, at, orders, 2, targets, 0, 0, NULL, 0, 0, lengths));
    CHECK_NEAR(lengths, VALUES(1, 0.75, 1, 0.1875), 4, 1e-15);
    CHECK_OK(nurbs_curve_interpolate(3, 4, at, orders, 2, targets, 0, 0, NULL, 0, 0, &g));
    CHECK_POINTS(g, VALUES(0, 0, 0.25, 0.25, 0.75, 0.25, 1, 0));
    nurbs_destroy(g);
    CHECK_OK(nurbs_tangent_lengths(3, 4, at, orders, 1, VALUES(5, -1, 7, 3), 0, 0, NULL, 0, 0, lengths));
    CHECK_NEAR(lengths, VALUES(1, -2, 1, 2 / 3.0), 4, 1e-14);
    CHECK_NO_HANDLE(g,
                    nurbs_curve_interpolate(3, 4, at, orders, 1, VALUES(5, -1, 7, 3), 0, 0, NULL, 0, 0, &g),
                    NURBS_ERROR_TANGENT, "targets[1]|-2");
}

static void refused_directions(void) {
    nurbs *g = NULL;
    const int32_t orders[] = {0, -1, 0, -1}, twice[] = {0, 1, -1, 0}, other[] = {0, -2, 0, 0};
    const double *at = VALUES(0, 0, 1, 1), *targets = VALUES(0, 1, 1, 1);
    const double many[17] = {0, 0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15};
    const int32_t one[17] = {0, -1};
    double lengths[4] = {-7, -7, -7, -7};
    CHECK_FAILS(nurbs_tangent_lengths(3, 4, at, orders, 1, targets, 0, 0, NULL, 0, 0, NULL), NURBS_ERROR_NULL,
                "lengths");
    CHECK_FAILS(nurbs_tangent_lengths(3, 4, NULL, orders, 1, targets, 0, 0, NULL, 0, 0, lengths),
                NURBS_ERROR_NULL, "params");
    CHECK_FAILS(nurbs_tangent_lengths(-3, 4, at, orders, 1, NULL, 0, 0, NULL, 0, 0, lengths),
                NURBS_ERROR_NULL, "targets");
    CHECK_FAILS(nurbs_tangent_lengths(3, 4, at, orders, 1, VALUES(0, 0, 1, 1), 0, 0, NULL, 0, 0, lengths),
                NURBS_ERROR_DIRECTION, "targets[1]");
    CHECK_FAILS(nurbs_tangent_lengths(3, 4, VALUES(0, 0, 0, 1), twice, 1, targets, 0, 0, NULL, 0, 0, lengths),
                NURBS_ERROR_ORDER, "orders[2]|orders[1]");
    CHECK_FAILS(nurbs_tangent_lengths(3, 4, at, other, 1, targets, 0, 0, NULL, 0, 0, lengths),
                NURBS_ERROR_ORDER, "orders[1] = -2");
    CHECK_FAILS(nurbs_tangent_lengths(1, 4, at, orders, 1, targets, 0, 0, NULL, 0, 0, lengths),
                NURBS_ERROR_ORDER, "orders[1] = -1|a degree from 2 to 15");
    CHECK_FAILS(nurbs_tangent_lengths(16, 17, many, one, 1, many, 0, 0, NULL, 0, 0, lengths),
                NURBS_ERROR_ORDER, "orders[1] = -1|a degree from 2 to 15, not 16");
    CHECK_FAILS(nurbs_tangent_lengths(3, 4, at, orders, 1, targets, 0, 0, NULL, 3, 0, lengths),
                NURBS_ERROR_SIZE, "knot_count = 3");
    CHECK_FAILS(
        nurbs_tangent_lengths(3, INT64_MAX / 8 + 1, at, orders, 1, targets, 0, 0, NULL, 0, 0, lengths),
        NURBS_ERROR_OVERFLOW, "targets");
    CHECK_FAILS(nurbs_tangent_lengths(3, 4, at, orders, 1, lengths, 0, 0, NULL, 0, 0, lengths),
                NURBS_ERROR_OVERLAP, "lengths|targets");
    CHECK_DOUBLES(lengths, VALUES(-7, -7, -7, -7), 4);
    CHECK_NO_HANDLE(g, nurbs_curve_interpolate(3, 4, at, orders, 1, VALUES(0, 0, 1, 1), 0, 0, NULL, 0, 0, &g),
                    NURBS_ERROR_DIRECTION, "targets[1]");
}

/* A line with a corner where the curve may have one bends nowhere, whatever its slopes. */
static void directions_beside_a_corner(void) {
    const int32_t orders[] = {0, -1, -1, -1, 0};
    double lengths[5] = {-7, -7, -7, -7, -7};
    CHECK_FAILS(nurbs_tangent_lengths(2, 5, VALUES(0, 0.25, 0.75, 1.25, 2), orders, 1, VALUES(0, 1, 1, 1, 6),
                                      0, 0, VALUES(0, 0, 0, 1, 1, 2, 2, 2), 8, 0, lengths),
                NURBS_ERROR_RANK, "lengths of the tangents");
    CHECK_DOUBLES(lengths, VALUES(-7, -7, -7, -7, -7), 5);
}

/* x^3 y^2 over [0, 1]^2 from its corners: values, slopes at all borders, mixed derivatives in the corners. Heights at 2 x 2
   places whose mixed derivatives are not known are those of planes over the borders, here of x + 2 y. */
static void heights_with_slopes(void) {
    nurbs *g = NULL;
    const int32_t degrees[] = {3, 2}, orders[] = {0, 1, 0, 1, 0, 0, 1}, cubics[] = {3, 3},
                  all[] = {0, 1, 0, 1, 0, 1, 0, 1};
    const int64_t counts[] = {4, 3}, square[] = {4, 4};
    const double values[4][3] = {{0, 0, 0}, {0, 0, 0}, {0, 1, 2}, {0, 3, 6}};
    CHECK_OK(nurbs_interpolate_derivatives(2, degrees, counts, VALUES(0, 0, 1, 1, 0, 1, 1), orders, 1,
                                           values[0], 0, 0, NULL, 0, &g));
    CHECK_KNOTS(g, 0, VALUES(0, 0, 0, 0, 1, 1, 1, 1));
    double made[16], wanted[16];
    CHECK_OK(nurbs_points(g, 12, made, 0, 0));
    CHECK_NEAR(made, VALUES(0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1), 12, 1e-15);
    nurbs_destroy(g);
    const double plane[4][4] = {{0, 2, 2, 2}, {1, NAN, 1, NAN}, {1, 2, 3, 2}, {1, NAN, 1, NAN}};
    CHECK_OK(nurbs_interpolate_derivatives(2, cubics, square, VALUES(0, 0, 1, 1, 0, 0, 1, 1), all, 1,
                                           plane[0], 0, 0, NULL, 0, &g));
    CHECK_OK(nurbs_points(g, 16, made, 0, 0));
    for (int i = 0; i < 16; ++i) {
        wanted[i] = (i / 4 + 2 * (i % 4)) / 3.0;
    }
    CHECK_NEAR(made, wanted, 16, 1e-15);
    nurbs_destroy(g);
}

static void refused_grids(void) {
    nurbs *g = NULL;
    const int32_t degrees[] = {3, 3}, orders[] = {0, 1, 0, 0, 0}, inside[] = {0, 0, 1, 0, 0},
                  first[] = {1, 0, 0, 0, 0}, many[] = {0, 1, 2, 0, 0}, high[] = {0, 4, 0, 0, 0},
                  natural[] = {1, 0}, falling[] = {0, 2, 1, 0, 0};
    const int64_t counts[] = {5, 5};
    const double *at = VALUES(0, 0, 1, 2, 3), *y = VALUES(1, 2, 3, 4, 1), *three = VALUES(0, 0, 0, 2, 3);
    CHECK_NO_HANDLE(g, nurbs_interpolate_derivatives(1, NULL, counts, at, orders, 1, y, 0, 0, NULL, 0, &g),
                    NURBS_ERROR_NULL, "degrees");
    CHECK_NO_HANDLE(g, nurbs_interpolate_derivatives(1, degrees, NULL, at, orders, 1, y, 0, 0, NULL, 0, &g),
                    NURBS_ERROR_NULL, "counts");
    CHECK_NO_HANDLE(g,
                    nurbs_interpolate_derivatives(1, degrees, counts, NULL, orders, 1, y, 0, 0, NULL, 0, &g),
                    NURBS_ERROR_NULL, "params");
    CHECK_NO_HANDLE(g,
                    nurbs_interpolate_derivatives(1, degrees, counts, at, orders, 1, NULL, 0, 0, NULL, 0, &g),
                    NURBS_ERROR_NULL, "values");
    CHECK_NO_HANDLE(g, nurbs_interpolate_derivatives(1, degrees, counts, at, NULL, 1, y, 0, 0, NULL, 0, &g),
                    NURBS_ERROR_KNOTS_DECREASING, "params[1] = 0|params[0] = 0");
    CHECK_NO_HANDLE(g, nurbs_interpolate_derivatives(1, degrees, counts, at, first, 1, y, 0, 0, NULL, 0, &g),
                    NURBS_ERROR_ORDER, "orders[0] = 1|first");
    CHECK_NO_HANDLE(g,
                    nurbs_interpolate_derivatives(1, degrees, counts, VALUES(0, 1, 1, 2, 3), inside, 1, y, 0,
                                                  0, NULL, 0, &g),
                    NURBS_ERROR_ORDER, "orders[2] = 1|end of axis 0");
    CHECK_NO_HANDLE(g, nurbs_interpolate_derivatives(1, degrees, counts, at, high, 1, y, 0, 0, NULL, 0, &g),
                    NURBS_ERROR_ORDER, "orders[1] = 4|3, the degree");
    CHECK_NO_HANDLE(
        g, nurbs_interpolate_derivatives(1, degrees, counts, three, falling, 1, y, 0, 0, NULL, 0, &g),
        NURBS_ERROR_ORDER, "orders[2] = 1|orders[1] = 2");
    CHECK_NO_HANDLE(g,
                    nurbs_interpolate_derivatives(1, degrees, counts, three, many, 1, y, 0, 0, NULL, 0, &g),
                    NURBS_ERROR_ORDER, "2 derivatives at the start of axis 0|at most 1");
    CHECK_NO_HANDLE(g,
                    nurbs_interpolate_derivatives(1, degrees, counts, at, orders, 1, y, 0, 0, natural, 0, &g),
                    NURBS_ERROR_RULE, "ends[0][0] = 1");
    CHECK_NO_HANDLE(
        g,
        nurbs_interpolate_derivatives(1, degrees, counts, at, orders, 1, y, 0, 0, NULL, NURBS_PERIODIC, &g),
        NURBS_ERROR_ORDER, "orders[1] = 1|axis 0 is periodic");
    CHECK_NO_HANDLE(g,
                    nurbs_interpolate_derivatives(1, degrees, counts, at, orders, 1, VALUES(1, NAN, 3, 4, 5),
                                                  0, 0, NULL, 0, &g),
                    NURBS_ERROR_POINT_NOT_FINITE, "values[1][0]");
    const int64_t two = 3;
    CHECK_NO_HANDLE(g, nurbs_interpolate_derivatives(1, degrees, &two, at, orders, 1, y, 0, 0, NULL, 0, &g),
                    NURBS_ERROR_TOO_FEW_POINTS, "at least 3");
}

/* Even degrees at as many knots: 1, -1, 1, -1, ... as control points vanish at all of them. */
static void a_loop_that_is_not_determined(void) {
    nurbs *g = NULL;
    double knots[17], params[12], values[12];
    for (int i = 0; i < 17; ++i) {
        knots[i] = i - 2;
    }
    for (int i = 0; i < 12; ++i) {
        params[i] = i;
        values[i] = i * 7 % 5;
    }
    CHECK_FAILS(nurbs_curve_interpolate(2, 12, params, NULL, 1, values, 0, 0, knots, 17, NURBS_PERIODIC, &g),
                NURBS_ERROR_RANK, "axis 0");
    CHECK(g == NULL);
    for (int i = 0; i < 12; ++i) {
        params[i] = i + 0.5;
    }
    CHECK_OK(nurbs_curve_interpolate(2, 12, params, NULL, 1, values, 0, 0, knots, 17, NURBS_PERIODIC, &g));
    nurbs_destroy(g);
}

static void refused_curves(void) {
    nurbs *g = NULL;
    const double *line = VALUES(0, 1, 2, 3), *at = VALUES(0, 1, 2, 3);
    const int32_t high[] = {0, 4, 0, 0};
    CHECK_NO_HANDLE(g, nurbs_curve_interpolate(3, 4, at, high, 1, line, 0, 0, NULL, 0, 0, &g),
                    NURBS_ERROR_ORDER, "orders[1] = 4|3");
    CHECK_NO_HANDLE(g, nurbs_curve_interpolate(3, 3, at, NULL, 1, line, 0, 0, NULL, 0, 0, &g),
                    NURBS_ERROR_TOO_FEW_POINTS, "3");
    CHECK_NO_HANDLE(g, nurbs_curve_interpolate(3, 0, at, NULL, 1, line, 0, 0, NULL, 0, 0, &g),
                    NURBS_ERROR_COUNT, "n = 0");
    CHECK_NO_HANDLE(g, nurbs_curve_interpolate(3, 4, at, NULL, 1, line, 0, 0, NULL, 0, NURBS_PERIODIC, &g),
                    NURBS_ERROR_FLAGS, "needs knots");
    CHECK_NO_HANDLE(g, nurbs_curve_interpolate(3, 4, at, NULL, 1, line, 0, 0, NULL, 8, 0, &g),
                    NURBS_ERROR_SIZE, "8|0");
    CHECK_NO_HANDLE(g, nurbs_curve_interpolate(3, 4, VALUES(0, 2, 1, 3), NULL, 1, line, 0, 0, NULL, 0, 0, &g),
                    NURBS_ERROR_KNOTS_DECREASING, "params[2] = 1|params[1] = 2");
    CHECK_NO_HANDLE(g, nurbs_curve_interpolate(3, 4, NULL, NULL, 1, line, 0, 0, NULL, 0, 0, &g),
                    NURBS_ERROR_NULL, "params");
    CHECK_NO_HANDLE(
        g, nurbs_curve_interpolate(3, 4, at, NULL, 1, line, 0, 0, VALUES(0, 0, 0, 0, 2, 2, 2, 2), 8, 0, &g),
        NURBS_ERROR_OUTSIDE_DOMAIN, "params[3] = 3");
}

static void refused_interpolations(void) {
    nurbs *g = NULL;
    double residual = -7;
    const double *at = VALUES(0, 1, 2, 3), *y = VALUES(4, 5, 6, 7);
    const int32_t natural[] = {1, 1}, other[] = {0, 3}, half[] = {2, 0};
    CHECK_NO_HANDLE(
        g, nurbs_interpolate(1, &cubic, &four, VALUES(0, 1, 1, 2), 1, y, 0, 0, NULL, 0, &residual, &g),
        NURBS_ERROR_KNOTS_DECREASING, "params[2] = 1|params[1] = 1");
    CHECK_NO_HANDLE(
        g, nurbs_interpolate(1, &cubic, &four, VALUES(0, 1, NAN, 2), 1, y, 0, 0, NULL, 0, &residual, &g),
        NURBS_ERROR_PARAMETER_NOT_FINITE, "params[2]");
    CHECK_NO_HANDLE(g, nurbs_interpolate(1, &quadratic, &four, at, 1, y, 0, 0, natural, 0, &residual, &g),
                    NURBS_ERROR_DEGREE, "degrees[0] = 2|odd");
    CHECK_NO_HANDLE(g, nurbs_interpolate(1, &cubic, &four, at, 1, y, 0, 0, other, 0, &residual, &g),
                    NURBS_ERROR_RULE, "ends[0][1] = 3");
    CHECK_NO_HANDLE(g, nurbs_interpolate(1, &cubic, &four, at, 1, y, 0, 0, half, 0, &residual, &g),
                    NURBS_ERROR_RULE, "ends[0]");
    CHECK_NO_HANDLE(
        g, nurbs_interpolate(1, &cubic, &four, at, 1, y, 0, 0, natural, NURBS_PERIODIC, &residual, &g),
        NURBS_ERROR_RULE, "periodic");
    CHECK_NO_HANDLE(g,
                    nurbs_interpolate(1, &cubic, &four, at, 1, y, 0, 0, NULL, NURBS_PERIODIC, &residual, &g),
                    NURBS_ERROR_PERIODIC_POINTS, "axis 0|4|7");
    const int32_t sextic = 6, many = 32;
    CHECK_NO_HANDLE(g, nurbs_interpolate(1, &sextic, &four, at, 1, y, 0, 0, NULL, 0, &residual, &g),
                    NURBS_ERROR_TOO_FEW_POINTS, "counts[0] = 4|at least 7");
    CHECK_NO_HANDLE(g, nurbs_interpolate(1, &many, &four, at, 1, y, 0, 0, NULL, 0, &residual, &g),
                    NURBS_ERROR_DEGREE, "degrees[0] = 32");
    CHECK_NO_HANDLE(g, nurbs_interpolate(1, NULL, &four, at, 1, y, 0, 0, NULL, 0, &residual, &g),
                    NURBS_ERROR_NULL, "degrees");
    CHECK_NO_HANDLE(g, nurbs_interpolate(1, &cubic, &four, NULL, 1, y, 0, 0, NULL, 0, &residual, &g),
                    NURBS_ERROR_NULL, "params");
    CHECK_NO_HANDLE(g,
                    nurbs_interpolate_over_knots(1, &cubic, &four, at, VALUES(0, 0, 0, 0, 3, 3, 3, 3), 9, 1,
                                                 y, 0, 0, 0, &g),
                    NURBS_ERROR_SIZE, "knot_count = 9|8");
    CHECK_DOUBLES(&residual, VALUES(-7), 1);
}

/* All data lie in the last span: nothing determines the first control point. */
static void the_condition_of_schoenberg_and_whitney(void) {
    nurbs *g = NULL;
    CHECK_NO_HANDLE(g,
                    nurbs_interpolate_over_knots(1, &quadratic, &five, VALUES(3, 3.2, 3.4, 3.6, 4),
                                                 VALUES(0, 0, 0, 1, 3, 4, 4, 4), 8, 1, VALUES(1, 2, 3, 4, 5),
                                                 0, 0, 0, &g),
                    NURBS_ERROR_SCHOENBERG_WHITNEY, "params[0] = 3|control point 0");
}

/* A closed curve through four points, and where it begins. */
static void loops(void) {
    nurbs *g = NULL;
    double residual = -1, value[1];
    for (int32_t degree = 0; degree <= 9; ++degree) {
        CHECK_OK(nurbs_interpolate(1, &degree, &five, VALUES(0, 1, 2, 3, 4), 1, VALUES(0, 1, 0, -1, 0), 0, 0,
                                   NULL, NURBS_PERIODIC, &residual, &g));
        CHECK_OK(nurbs_eval(g, 1, VALUES(5), 0, 0, value, 0, 0, NURBS_WRAP));
        if (!(residual <= 1e-14) || !(fabs(value[0] - 1) <= 1e-14)) {
            check_report(__FILE__, __LINE__, "");
            fprintf(stderr, "degree %d: residual %g, value %g\n", degree, residual, value[0]);
        }
        nurbs_destroy(g);
    }
}

/* Slopes 1, 3, 0 over steps 1, 2, 1. */
static void tangents_at_points(void) {
    const double *t = VALUES(0, 1, 3, 4), *y = VALUES(0, 1, 7, 7);
    double made[4];
    CHECK_OK(nurbs_tangents(NURBS_TANGENTS_CATMULL_ROM, 4, t, 1, y, 0, 0, 0, made, 0, 0));
    CHECK_NEAR(made, VALUES(1, 7 / 3.0, 2, 0), 4, 1e-15);
    CHECK_OK(nurbs_tangents(NURBS_TANGENTS_BESSEL, 4, t, 1, y, 0, 0, 0, made, 0, 0));
    CHECK_NEAR(made, VALUES(1 / 3.0, 5 / 3.0, 1, -1), 4, 1e-15);
    /* Slopes beyond the ends: -3, -1 and -3, -6. */
    CHECK_OK(nurbs_tangents(NURBS_TANGENTS_AKIMA, 4, t, 1, y, 0, 0, 0, made, 0, 0));
    CHECK_NEAR(made, VALUES(0, (3 * 1 + 2 * 3) / 5.0, (3 * 3 + 2 * 0) / 5.0, -1.5), 4, 1e-15);
    CHECK_OK(nurbs_tangents(NURBS_TANGENTS_MONOTONE, 4, t, 1, y, 0, 0, 0, made, 0, 0));
    CHECK_NEAR(made, VALUES(1 / 3.0, 9 / (5 + 4 / 3.0), 0, 0), 4, 1e-11);
    CHECK_OK(nurbs_tangents(NURBS_TANGENTS_BESSEL, 2, t, 1, y, 0, 0, 0, made, 0, 0));
    CHECK_DOUBLES(made, VALUES(1, 1), 2);
}

/* Slopes 1, -1 over steps 1, 1, round and round; columns of a table. */
static void tangents_of_loops(void) {
    static const double rows[3][2] = {{0, 5}, {1, 5}, {0, 5}};
    double made[3][2] = {{9, 9}, {9, 9}, {9, 9}};
    for (int32_t rule = NURBS_TANGENTS_CATMULL_ROM; rule <= NURBS_TANGENTS_MONOTONE; ++rule) {
        CHECK_OK(nurbs_tangents(rule, 3, VALUES(0, 1, 2), 1, rows[0], 2, 0, NURBS_PERIODIC, made[0], 2, 0));
        CHECK_DOUBLES(made[0], VALUES(0, 9, 0, 9, 0, 9), 6);
    }
}

static void refused_tangents(void) {
    const double *t = VALUES(0, 1, 2), *y = VALUES(0, 1, 3);
    double made[3] = {-7, -7, -7};
    CHECK_FAILS(nurbs_tangents(4, 3, t, 1, y, 0, 0, 0, made, 0, 0), NURBS_ERROR_RULE, "rule = 4");
    CHECK_FAILS(nurbs_tangents(0, 1, t, 1, y, 0, 0, 0, made, 0, 0), NURBS_ERROR_COUNT, "n = 1|2");
    CHECK_FAILS(nurbs_tangents(0, 3, NULL, 1, y, 0, 0, 0, made, 0, 0), NURBS_ERROR_NULL, "params");
    CHECK_FAILS(nurbs_tangents(0, 3, t, 1, NULL, 0, 0, 0, made, 0, 0), NURBS_ERROR_NULL, "points");
    CHECK_FAILS(nurbs_tangents(0, 3, t, 1, y, 0, 0, 0, NULL, 0, 0), NURBS_ERROR_NULL, "tangents");
    CHECK_FAILS(nurbs_tangents(0, 3, VALUES(0, 0, 1), 1, y, 0, 0, 0, made, 0, 0),
                NURBS_ERROR_KNOTS_DECREASING, "params[1] = 0|params[0] = 0");
    CHECK_FAILS(nurbs_tangents(0, 3, t, 1, y, 0, 0, NURBS_PERIODIC, made, 0, 0), NURBS_ERROR_PERIODIC_POINTS,
                "3|0");
    CHECK_FAILS(nurbs_tangents(0, 3, t, 1, y, 0, 0, 2, made, 0, 0), NURBS_ERROR_FLAGS, "0x2");
    CHECK_FAILS(nurbs_tangents(0, 3, t, 1, VALUES(0, INFINITY, 1), 0, 0, 0, made, 0, 0),
                NURBS_ERROR_POINT_NOT_FINITE, "points[1][0]");
    CHECK_FAILS(nurbs_tangents(0, 3, VALUES(0, 1e-300, 1), 1, VALUES(0, 1e200, 1), 0, 0, 0, made, 0, 0),
                NURBS_ERROR_NOT_REPRESENTABLE, "tangents");
    CHECK_FAILS(nurbs_tangents(0, 3, made, 1, y, 0, 0, 0, made, 0, 0), NURBS_ERROR_KNOTS_DECREASING, "");
    CHECK_DOUBLES(made, VALUES(-7, -7, -7), 3);
}

int main(void) {
    parameters();
    angles();
    parameters_of_grids();
    universal_parameters();
    refused_parameters();
    a_parabola();
    a_natural_cubic();
    conditions();
    directions();
    refused_directions();
    directions_beside_a_corner();
    heights_with_slopes();
    refused_grids();
    a_loop_that_is_not_determined();
    refused_curves();
    refused_interpolations();
    the_condition_of_schoenberg_and_whitney();
    loops();
    tangents_at_points();
    tangents_of_loops();
    refused_tangents();
    return check_summary("interpolate");
}
