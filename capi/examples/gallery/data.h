/* SPDX-License-Identifier: MIT */
/* Splines closest to data. */
#ifndef GALLERY_DATA_H
#define GALLERY_DATA_H

#include "curves.h"

enum { MEASURED = 60, SCATTERED = 220 };

/* Numbers from -1 to 1 that look like noise, the same everywhere. */
static double noise(void) {
    static uint32_t state = 1;
    state = state * 1664525u + 1013904223u;
    return (state >> 8) / 8388608.0 - 1;
}

typedef struct measured {
    nurbs_data data;
    double params[2 * SCATTERED], values[3 * SCATTERED];
} measured;

static void begin_data(measured *m, int n, int32_t axes, int32_t dim) {
    check(nurbs_data_init(&m->data, sizeof m->data));
    m->data.n = n;
    m->data.axes = axes;
    m->data.dim = dim;
    m->data.params = m->params;
    m->data.values = m->values;
}

/* A wave, or a roof. */
static void measure_graph(measured *m, double wrong, int roof) {
    int i;
    begin_data(m, MEASURED, 1, 2);
    for (i = 0; i < MEASURED; ++i) {
        const double t = i / (MEASURED - 1.0);
        m->params[i] = t;
        m->values[2 * i] = 3 * t;
        m->values[2 * i + 1] = (roof ? 0.1 * sin(20 * t) - 4 * fabs(t - 0.5) : sin(8 * t)) + wrong * noise();
    }
}

/* A flower, from t = 0 to 1. */
static void measure_flower(measured *m, double wrong) {
    int i;
    begin_data(m, MEASURED, 1, 2);
    for (i = 0; i < MEASURED; ++i) {
        const double t = i / (double)MEASURED, r = 1 + 0.3 * cos(10 * PI * t) + wrong * noise();
        m->params[i] = t;
        m->values[2 * i] = r * cos(2 * PI * t);
        m->values[2 * i + 1] = r * sin(2 * PI * t);
    }
}

/* Heights over a square with a hole. */
static void measure_heights(measured *m, double wrong) {
    int n = 0;
    while (n < SCATTERED) {
        const double u = (noise() + 1) / 2, v = (noise() + 1) / 2;
        if (hypot(u - 0.6, v - 0.4) > 0.2) {
            m->params[2 * n] = u;
            m->params[2 * n + 1] = v;
            m->values[3 * n] = 2.4 * u;
            m->values[3 * n + 1] = 2.4 * v;
            m->values[3 * n + 2] = 0.4 * sin(6 * u) * cos(5 * v) + wrong * noise();
            ++n;
        }
    }
    begin_data(m, SCATTERED, 2, 3);
}

static void show_among(gallery *p, const char *label, const measured *m, nurbs *g) {
    add_dots(p, "data", m->values, (int)m->data.n, m->data.dim);
    show_curve(p, label, g);
}

/* Few knots; many knots, and as smooth as cross validation finds right; ends that are met. */
static void among_points(gallery *p) {
    static measured m;
    const int32_t cubic_degree = 3;
    const int64_t few = 9, many = 24;
    const double ends[2] = {0, 1}, points[4] = {0, 0, 3, 1};
    double knots[28];
    nurbs_fit_options options;
    nurbs *g;
    measure_graph(&m, 0.25, 0);
    check(nurbs_knots_open_uniform(3, few, 0, 1, few + 4, knots));
    check(nurbs_fit_points(&m.data, &cubic_degree, &few, knots, few + 4, 0, NULL, NULL, &g));
    show_among(p, "fit_points", &m, g);
    check(nurbs_fit_options_init(&options, sizeof options));
    options.conditions = 2;
    options.condition_params = ends;
    options.condition_targets = points;
    check(nurbs_fit_points(&m.data, &cubic_degree, &few, knots, few + 4, 0, &options, NULL, &g));
    add_dots(p, "given", points, 2, 2);
    show_among(p, "fit_points, conditions", &m, g);
    check(nurbs_fit_options_init(&options, sizeof options));
    options.smoothing = NURBS_SMOOTHING_GCV;
    check(nurbs_knots_open_uniform(3, many, 0, 1, many + 4, knots));
    check(nurbs_fit_points(&m.data, &cubic_degree, &many, knots, many + 4, 0, &options, NULL, &g));
    show_among(p, "fit_points, GCV", &m, g);
}

static void around_points(gallery *p) {
    static measured m;
    const int32_t cubic_degree = 3;
    const int64_t count = 18;
    double breaks[16], knots[22];
    nurbs *g, *open;
    int i;
    for (i = 0; i < 16; ++i) {
        breaks[i] = i / 15.0;
    }
    measure_flower(&m, 0.1);
    check(nurbs_knots_periodic(3, 16, breaks, NULL, 22, knots));
    check(nurbs_fit_points(&m.data, &cubic_degree, &count, knots, 22, NURBS_PERIODIC, NULL, NULL, &g));
    check(
        nurbs_clamp_ends(g, 0, NURBS_FORM_CLAMPED_START | NURBS_FORM_CLAMPED_END, &open)); /* to be sampled */
    nurbs_destroy(g);
    show_among(p, "fit_points, PERIODIC", &m, open);
}

/* Knots where they are needed; and a rational curve by a polynomial one. */
static void to_tolerances(gallery *p) {
    static measured m;
    const int32_t cubic_degree = 3;
    double bound;
    nurbs_fit_report report;
    nurbs *g, *circle;
    int64_t count;
    report.struct_size = sizeof report;
    measure_graph(&m, 0.01, 1);
    check(nurbs_fit_tolerance(&m.data, &cubic_degree, NULL, 0.03, 0, 0, NULL, &report, &g));
    check(nurbs_point_count(g, &count));
    printf("%d points are within %.2g of a curve with %d control points\n", MEASURED, report.largest,
           (int)count);
    show_among(p, "fit_tolerance", &m, g);
    check(nurbs_curve_circle(2, NULL, NULL, NULL, 1, NURBS_ARC_QUARTERS, &circle));
    check(nurbs_approximate(circle, &cubic_degree, 0.01, 0, &bound, &g));
    printf("a polynomial curve is proven to be within %.2g of a circle\n", bound);
    nurbs_destroy(circle);
    show_curve(p, "approximate", g);
}

static void among_heights(gallery *p) {
    static measured m;
    const int32_t degrees[2] = {3, 3};
    const int64_t counts[2] = {9, 9};
    double knots[26];
    nurbs_fit_options options;
    nurbs *g;
    check(nurbs_fit_options_init(&options, sizeof options));
    options.smoothing = NURBS_SMOOTHING_GCV;
    measure_heights(&m, 0.05);
    check(nurbs_knots_open_uniform(3, 9, 0, 1, 13, knots));
    check(nurbs_knots_open_uniform(3, 9, 0, 1, 13, knots + 13));
    check(nurbs_fit_points(&m.data, degrees, counts, knots, 26, 0, &options, NULL, &g));
    add_dots(p, "data", m.values, SCATTERED, 3);
    show_surface(p, "fit_points, a surface", g, 24, 24, OPEN);
}

static void show_data(gallery *p) {
    among_points(p);
    around_points(p);
    to_tolerances(p);
    among_heights(p);
}

#endif
