/* SPDX-License-Identifier: MIT */
/* Splines through data. */
#ifndef GALLERY_FITS_H
#define GALLERY_FITS_H

#include "curves.h"

enum { GIVEN = 8 };

static const double given_points[GIVEN][2] = {{0, 0},     {0.4, 1.1}, {0.9, 1.2}, {1.1, 0.4},
                                              {1.9, 0.2}, {2.1, 1.3}, {2.9, 1.4}, {3.2, 0.3}};

static void show_through(gallery *p, const char *label, int n, const double *points, nurbs *g) {
    add_dots(p, "given", points, n, 2);
    show_curve(p, label, g);
}

/* The same points with two kinds of ends, and a closed curve: the first point ends it. */
static void through_points(gallery *p) {
    const int32_t cubic_degree = 3, natural[2] = {NURBS_ENDS_NATURAL, NURBS_ENDS_NATURAL};
    const int64_t count = GIVEN, closed_count = 7;
    const double closed[7][2] = {{1, 0},       {0.6, 1},    {-0.4, 0.5}, {-1.1, 0.7},
                                 {-0.8, -0.5}, {0.5, -0.9}, {1, 0}};
    double params[GIVEN], residual;
    nurbs *g, *open;
    check(nurbs_parametrize(1, &count, 2, given_points[0], 0, 0, NURBS_PARAMS_CENTRIPETAL, 0, 0, params));
    check(nurbs_interpolate(1, &cubic_degree, &count, params, 2, given_points[0], 0, 0, NULL, 0, &residual,
                            &g));
    printf("a curve through %d points is within %g of them\n", (int)GIVEN, residual);
    show_through(p, "interpolate", GIVEN, given_points[0], g);
    check(
        nurbs_interpolate(1, &cubic_degree, &count, params, 2, given_points[0], 0, 0, natural, 0, NULL, &g));
    show_through(p, "interpolate, NATURAL", GIVEN, given_points[0], g);
    check(nurbs_parametrize(1, &closed_count, 2, closed[0], 0, 0, NURBS_PARAMS_CHORD, 0, NURBS_PERIODIC,
                            params));
    check(nurbs_interpolate(1, &cubic_degree, &closed_count, params, 2, closed[0], 0, 0, NULL, NURBS_PERIODIC,
                            NULL, &g));
    check(
        nurbs_clamp_ends(g, 0, NURBS_FORM_CLAMPED_START | NURBS_FORM_CLAMPED_END, &open)); /* to be sampled */
    nurbs_destroy(g);
    show_through(p, "interpolate, PERIODIC", 7, closed[0], open);
}

/* Points, and derivatives at the ends and in the middle. */
static void through_conditions(gallery *p) {
    const double params[7] = {0, 0, 1, 1, 2, 3, 3};
    const int32_t orders[7] = {0, 1, 0, 1, 0, 0, 1};
    const double targets[7][2] = {{0, 0}, {0, 2}, {1, 1}, {1, 0}, {2, 0.3}, {3, 1}, {0, 2}};
    nurbs *g;
    int i;
    check(nurbs_curve_interpolate(3, 7, params, orders, 2, targets[0], 0, 0, NULL, 0, 0, &g));
    for (i = 0; i < 7; ++i) {
        if (orders[i] == 1) {
            add_given(p, targets[i - 1], targets[i]);
        } else {
            add_dots(p, "given", targets[i], 1, 2);
        }
    }
    show_curve(p, "curve_interpolate", g);
}

/* Tangents of which only the directions are known: what least energy makes of their lengths. */
static void along_directions(gallery *p) {
    const double params[6] = {0, 0, 1, 1, 2, 2};
    const int32_t orders[6] = {0, NURBS_ORDER_DIRECTION, 0, NURBS_ORDER_DIRECTION, 0, NURBS_ORDER_DIRECTION};
    const double targets[6][2] = {{0, 0}, {0, 0.7}, {1, 1}, {0.7, -0.2}, {2, 0}, {0, -0.7}};
    double lengths[6];
    nurbs *g;
    int i;
    check(nurbs_tangent_lengths(3, 6, params, orders, 2, targets[0], 0, 0, NULL, 0, 0, lengths));
    check(nurbs_curve_interpolate(3, 6, params, orders, 2, targets[0], 0, 0, NULL, 0, 0, &g));
    for (i = 0; i < 6; i += 2) {
        add_given(p, targets[i], targets[i + 1]);
    }
    printf("tangents are %g, %g and %g times as long as given\n", lengths[1], lengths[3], lengths[5]);
    show_curve(p, "curve_interpolate, DIRECTION", g);
}

/* Heights at 3 x 3 places of a hill whose borders are level: slopes of 0 across them, and mixed derivatives in the corners. */
static void with_slopes(gallery *p) {
    const int32_t degrees[2] = {3, 3}, orders[10] = {0, 1, 0, 0, 1, 0, 1, 0, 0, 1};
    const int64_t counts[2] = {5, 5};
    const double params[10] = {0, 0, 1, 2, 2, 0, 0, 1, 2, 2};
    const double at[5] = {0, 1, 1, 2, 1}; /* a place, or how it moves where a layer is of derivatives */
    const double heights[5][5] = {
        {0, 0, 0.3, 0, 0}, {0, 0, 0, 0, 0}, {0.3, 0, 1.4, 0.3, 0}, {0, 0, 0.3, 0, 0}, {0, 0, 0, 0, 0}};
    double values[5][5][3];
    nurbs *g;
    int i, j;
    for (i = 0; i < 5; ++i) {
        for (j = 0; j < 5; ++j) {
            values[i][j][0] = orders[j] == 0 ? at[i] : 0;
            values[i][j][1] = orders[i] == 0 ? at[j] : 0;
            values[i][j][2] = heights[i][j];
            if (orders[i] == 0 && orders[j] == 0) {
                add_dots(p, "given", values[i][j], 1, 3);
            }
        }
    }
    check(nurbs_interpolate_derivatives(2, degrees, counts, params, orders, 3, values[0][0], 0, 0, NULL, 0,
                                        &g));
    show_surface(p, "interpolate_derivatives", g, 24, 24, OPEN);
}

/* A step, once as it is and once with a swing before it. */
static void by_tangents(gallery *p) {
    static const char *const labels[] = {"tangents, AKIMA", "tangents, MONOTONE"};
    const double step[7][2] = {{0, 0}, {0.5, 0}, {1, 0.05}, {1.5, 1.2}, {2, 1.25}, {2.5, 1.25}, {3, 1.25}};
    const double params[7] = {0, 0.5, 1, 1.5, 2, 2.5, 3};
    double tangents[7][2];
    nurbs *g;
    int32_t rule;
    for (rule = NURBS_TANGENTS_AKIMA; rule <= NURBS_TANGENTS_MONOTONE; ++rule) {
        check(nurbs_tangents(rule, 7, params, 2, step[0], 0, 0, 0, tangents[0], 0, 0));
        check(nurbs_create_hermite(7, params, 2, step[0], 0, 0, tangents[0], 0, 0, &g));
        show_through(p, labels[rule - NURBS_TANGENTS_AKIMA], 7, step[0], g);
    }
}

/* Heights on a grid. */
static void through_heights(gallery *p) {
    const int32_t degrees[2] = {3, 3};
    const int64_t counts[2] = {5, 6};
    double points[5][6][3], params[11];
    nurbs *g;
    int i, j;
    for (i = 0; i < 5; ++i) {
        for (j = 0; j < 6; ++j) {
            points[i][j][0] = 0.5 * i;
            points[i][j][1] = 0.5 * j;
            points[i][j][2] = 0.3 * ((3 * i + 5 * j + i * j) % 4);
        }
    }
    check(nurbs_parametrize(2, counts, 3, points[0][0], 0, 0, NURBS_PARAMS_CHORD, 0, 0, params));
    check(nurbs_interpolate(2, degrees, counts, params, 3, points[0][0], 0, 0, NULL, 0, NULL, &g));
    add_dots(p, "given", points[0][0], 30, 3);
    show_surface(p, "interpolate, a surface", g, 24, 24, OPEN);
}

/* A quintic over averaged knots. */
static void over_knots(gallery *p) {
    const int32_t degree = 5;
    const int64_t count = GIVEN;
    double params[GIVEN], knots[GIVEN + 6];
    nurbs *g;
    check(nurbs_parametrize(1, &count, 2, given_points[0], 0, 0, NURBS_PARAMS_FOLEY_NIELSON, 0, 0, params));
    check(nurbs_knots_averaged(degree, count, params, GIVEN + 6, knots));
    check(nurbs_interpolate_over_knots(1, &degree, &count, params, knots, GIVEN + 6, 2, given_points[0], 0, 0,
                                       0, &g));
    show_through(p, "interpolate_over_knots", GIVEN, given_points[0], g);
}

/* The same points over even knots. */
static void over_even_knots(gallery *p) {
    const int32_t degree = 3;
    const int64_t count = GIVEN;
    double params[GIVEN], knots[GIVEN + 4];
    nurbs *g;
    check(nurbs_params_universal(degree, count, params));
    check(nurbs_knots_open_uniform(degree, count, 0, 1, GIVEN + 4, knots));
    check(nurbs_interpolate_over_knots(1, &degree, &count, params, knots, GIVEN + 4, 2, given_points[0], 0, 0,
                                       0, &g));
    show_through(p, "params_universal", GIVEN, given_points[0], g);
}

static void show_fits(gallery *p) {
    through_points(p);
    over_knots(p);
    over_even_knots(p);
    through_conditions(p);
    along_directions(p);
    by_tangents(p);
    through_heights(p);
    with_slopes(p);
}

#endif
