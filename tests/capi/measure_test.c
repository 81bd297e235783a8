/* SPDX-License-Identifier: MIT */
/* Lengths, divisions, areas, moments, and what shapes enclose. */
#include "shapes.h"

#define PI 3.14159265358979323846

static void lengths(void) {
    double length, error, both[2];
    nurbs *g = make(circle());
    CHECK_OK(nurbs_curve_length(g, NULL, 1e-12, &length, &error));
    CHECK_NEAR(&length, &(double){2 * PI}, 1, 1e-14);
    CHECK(error > 0 && error < 1e-13);
    CHECK_OK(nurbs_curve_length(g, (const double[]){0.25, 0.75}, 0, &length, NULL));
    CHECK_NEAR(&length, &(double){PI}, 1, 1e-14);
    CHECK_OK(nurbs_curve_lengths(g, 2, (const double[]){0.5, 1}, 0, 1e-12, both, 0));
    CHECK_NEAR(both, ((const double[]){PI, 2 * PI}), 2, 1e-14);
    CHECK_OK(nurbs_curve_params_at_lengths(g, 2, (const double[]){PI / 2, PI}, 0, 1e-12, both, 0, 0));
    CHECK_NEAR(both, ((const double[]){0.25, 0.5}), 2, 1e-15);
    CHECK_OK(nurbs_curve_params_at_lengths(g, 2, (const double[]){-3, 7}, 0, 1e-12, both, 0, NURBS_CLAMP));
    CHECK_DOUBLES(both, ((const double[]){0, 1}), 2);
    CHECK_OK(nurbs_curve_params_at_lengths(g, 2, (const double[]){-INFINITY, INFINITY}, 0, 0, both, 0,
                                           NURBS_CLAMP));
    CHECK_DOUBLES(both, ((const double[]){0, 1}), 2);
    nurbs_destroy(g);
    g = make(jump());
    CHECK_OK(nurbs_curve_length(g, NULL, 0, &length, &error));
    CHECK_NEAR(&length, &(double){2}, 1, 1e-15);
    nurbs_destroy(g);
    g = make(stairs());
    CHECK_OK(nurbs_curve_length(g, NULL, 0, &length, &error));
    CHECK_DOUBLE(length, 0);
    CHECK_OK(nurbs_curve_params_at_lengths(g, 1, (const double[]){0}, 0, 0, both, 0, 0));
    CHECK_DOUBLE(both[0], 0);
    nurbs_destroy(g);
    g = make(hill()); /* 1 to 3.5 and back to 1 */
    CHECK_OK(nurbs_curve_length(g, (const double[]){2, 5}, 1e-12, &length, &error));
    CHECK_NEAR(&length, &(double){5}, 1, 1e-14);
    nurbs_destroy(g);
}

/* Strides of the caller. */
static void strides(void) {
    static const double params[] = {0.5, 9, 1, 9};
    double out[6];
    FILL(out);
    nurbs *g = make(circle());
    CHECK_OK(nurbs_curve_lengths(g, 2, params, 2, 1e-12, out, 3));
    CHECK_NEAR(&out[0], &(double){PI}, 1, 1e-14);
    CHECK_NEAR(&out[3], &(double){2 * PI}, 1, 1e-14);
    CHECK_OK(nurbs_curve_lengths(g, 0, NULL, 0, 1e-12, NULL, 0));
    CHECK_OK(nurbs_curve_params_at_lengths(g, 0, NULL, 0, 1e-12, NULL, 0, 0));
    nurbs_destroy(g);
}

/* Periodic curves have no ends that rounding could keep apart; a jump at the seam is one. */
static void closed_by_their_knots(void) {
    static const int32_t degree = 3, one = 1;
    static const int64_t count = 9, five = 5;
    static const double points[] = {1,    0,   0.5,  0.9, -0.6, 0.8, -1,  0.1,  -0.4,
                                    -0.9, 0.7, -1.1, 1,   0,    0.5, 0.9, -0.6, 0.8},
                        jumps[] = {0, 0, 1, 0, 1, 1, 0, 0.25, 0, 0}, twice[] = {0, 0, 1, 2, 3, 3, 4};
    double knots[13], area = 0, breaks[7];
    for (int i = 0; i < 7; ++i) {
        breaks[i] = i / 6.0;
    }
    nurbs *g = NULL;
    CHECK_OK(nurbs_knots_periodic(3, 7, breaks, NULL, 13, knots));
    CHECK_OK(nurbs_create(1, &degree, &count, knots, 13, 2, points, 0, 0, NULL, 0, NURBS_PERIODIC, &g));
    CHECK_OK(nurbs_enclosed_area(1, (const nurbs *const *)&g, 0, 1e-12, &area, NULL, NULL, NULL));
    CHECK(area > 1 && area < 3);
    nurbs_destroy(g);
    CHECK_OK(nurbs_create(1, &one, &five, twice, 7, 2, jumps, 0, 0, NULL, 0, NURBS_PERIODIC, &g));
    CHECK_FAILS(nurbs_enclosed_area(1, (const nurbs *const *)&g, 0.2, 1e-12, &area, NULL, NULL, NULL),
                NURBS_ERROR_GAP, "curves[0] ends 0.25");
    CHECK_OK(nurbs_enclosed_area(1, (const nurbs *const *)&g, 0.25, 1e-12, &area, NULL, NULL, NULL));
    nurbs_destroy(g);
}

/* A closed chain takes a start for each end: one start within the tolerance of two ends is not enough. Where
 * several chains pass through a point, or ends have several starts in reach, there is one for each in some
 * order. */
static void one_start_for_each_end(void) {
    static const double knots[] = {0, 0, 1, 2, 2};
    static const int32_t degree = 1;
    static const int64_t count = 3;
    static const double tails[] = {5, 5, 3, 3, 1, 0}, left[] = {0, 0, 1, 1, 1, 0},
                        right[] = {1.5, 0, 1, -1, -0.5, 0};
    double area = 0;
    nurbs *g[2] = {make(circle()), NULL};
    CHECK_OK(nurbs_create(1, &degree, &count, knots, 5, 2, tails, 0, 0, NULL, 0, 0, &g[1]));
    const nurbs *const *curves = (const nurbs *const *)g;
    CHECK_FAILS(nurbs_enclosed_area(2, curves, 1e-9, 0, &area, NULL, NULL, NULL), NURBS_ERROR_GAP,
                "curves[1] ends|more|1e-09");
    nurbs_destroy(g[1]);
    g[1] = make(circle());
    CHECK_OK(nurbs_enclosed_area(2, curves, 1e-9, 1e-12, &area, NULL, NULL, NULL));
    CHECK_NEAR(&area, &(double){2 * PI}, 1, 1e-13);
    for (int i = 0; i < 2; ++i) {
        nurbs_destroy(g[i]);
    }
    /* ends at 1 and -0.5, starts at 0 and 1.5: in reach of 1 are both, in reach of -0.5 is only 0 */
    CHECK_OK(nurbs_create(1, &degree, &count, knots, 5, 2, left, 0, 0, NULL, 0, 0, &g[0]));
    CHECK_OK(nurbs_create(1, &degree, &count, knots, 5, 2, right, 0, 0, NULL, 0, 0, &g[1]));
    CHECK_OK(nurbs_enclosed_area(2, curves, 1, 1e-12, &area, NULL, NULL, NULL));
    CHECK_FAILS(nurbs_enclosed_area(2, curves, 0.375, 0, &area, NULL, NULL, NULL), NURBS_ERROR_GAP,
                "curves[0] ends 0.5");
    nurbs_destroy(g[0]);
    nurbs_destroy(g[1]);
}

static void divisions(void) {
    double params[5], size;
    nurbs *g = make(circle());
    CHECK_OK(nurbs_curve_divide(g, NULL, 4, 1e-12, 0, params, &size));
    CHECK_NEAR(params, ((const double[]){0, 0.25, 0.5, 0.75, 1}), 5, 1e-15);
    CHECK_NEAR(&size, &(double){PI / 2}, 1, 1e-14);
    CHECK_OK(nurbs_curve_divide(g, NULL, 4, 1e-12, NURBS_EQUAL_CHORDS, params, &size));
    CHECK_NEAR(params, ((const double[]){0, 0.25, 0.5, 0.75, 1}), 5, 1e-11);
    CHECK_NEAR(&size, &(double){2 * HALF_ROOT}, 1, 1e-11);
    CHECK_OK(nurbs_curve_divide(g, (const double[]){0, 0.5}, 1, 1e-12, NURBS_EQUAL_CHORDS, params, &size));
    CHECK_NEAR(&size, &(double){2}, 1, 1e-14);
    nurbs_destroy(g);
}

/* A part that ends where the curve jumps ends before the jump: a corner of two sides of length 1. */
static void divided_before_a_jump(void) {
    static const int32_t degree = 1;
    static const int64_t count = 5;
    static const double knots[] = {0, 0, 1, 2, 2, 3, 3}, points[] = {0, 0, 1, 0, 1, 1, 7, 7, 8, 8};
    double params[5], size;
    nurbs *g = NULL;
    CHECK_OK(nurbs_create(1, &degree, &count, knots, 7, 2, points, 0, 0, NULL, 0, 0, &g));
    for (int parts = 1; parts <= 4; ++parts) {
        const double step = parts == 1 ? sqrt(2) : parts == 3 ? 2 - sqrt(2) : 2.0 / parts;
        CHECK_OK(
            nurbs_curve_divide(g, (const double[]){0, 2}, parts, 1e-12, NURBS_EQUAL_CHORDS, params, &size));
        CHECK_NEAR(&size, &step, 1, 1e-11);
    }
    nurbs_destroy(g);
}

static void areas(void) {
    double area, error, centroid[4], inertia[16];
    nurbs *g = make(trough()); /* (u, v, u^2 + v): sqrt(2 + 4 u^2) over [0, 1] x [0, 3] */
    const double whole = 3 * (sqrt(6) / 2 + asinh(sqrt(2)) / 2);
    CHECK_OK(nurbs_surface_area(g, NULL, 1e-12, &area, &error));
    CHECK_NEAR(&area, &whole, 1, 1e-14);
    CHECK_OK(nurbs_surface_area(g, (const double[]){0, 1, 0.5, 2}, 1e-12, &area, NULL));
    CHECK_NEAR(&area, &(double){whole / 2}, 1, 1e-14);
    CHECK_OK(nurbs_moments(g, 1e-12, &area, centroid, NULL, NULL));
    CHECK_NEAR(&area, &whole, 1, 1e-14);
    CHECK_NEAR(&centroid[1], &(double){1.5}, 1, 1e-14);
    nurbs_destroy(g);
    g = make(loop());
    CHECK_OK(
        nurbs_enclosed_area(1, (const nurbs *const *)&g, 1e-12, 1e-12, &area, centroid, inertia, &error));
    CHECK_NEAR(&area, &(double){10. / 3}, 1, 1e-14);
    CHECK_NEAR(centroid, ((const double[]){0, 0}), 2, 1e-15);
    CHECK_NEAR(&inertia[0], &inertia[3], 1, 1e-14);
    CHECK_NEAR(&inertia[1], &(double){0}, 1, 1e-15);
    nurbs_destroy(g);
}

/* The unit cube as a volume and by its faces. */
static void bodies(void) {
    static const double corners[] = {0, 0, 0, 0, 0, 1, 0, 1, 0, 0, 1, 1, 1, 0, 0, 1, 0, 1, 1, 1, 0, 1, 1, 1};
    static const double middle[] = {0.5, 0.5, 0.5};
    static const double about[] = {1. / 6, 0, 0, 0, 1. / 6, 0, 0, 0, 1. / 6};
    double volume, centroid[3], inertia[9], openness, error;
    nurbs *g = NULL, *faces[6];
    nurbs_list *list = NULL;
    CHECK_OK(nurbs_volume_trilinear(3, corners, 0, 0, &g));
    CHECK_OK(nurbs_moments(g, 0, &volume, centroid, inertia, &error));
    CHECK_NEAR(&volume, &(double){1}, 1, 1e-14);
    CHECK_NEAR(centroid, middle, 3, 1e-15);
    CHECK_NEAR(inertia, about, 9, 1e-15);
    CHECK_OK(nurbs_boundaries(g, &list));
    for (int i = 0; i < 6; ++i) {
        nurbs *face = NULL;
        CHECK_OK(nurbs_list_get(list, i, &face));
        faces[i] = face;
        if (i == 0 || i == 3 || i == 4) {
            CHECK_OK(nurbs_reverse(face, 0, 0, &faces[i]));
            nurbs_destroy(face);
        }
    }
    CHECK_OK(nurbs_enclosed_volume(6, (const nurbs *const *)faces, 0, &volume, centroid, inertia, &openness,
                                   &error));
    CHECK_NEAR(&volume, &(double){1}, 1, 1e-14);
    CHECK_NEAR(centroid, middle, 3, 1e-15);
    CHECK_NEAR(inertia, about, 9, 1e-15);
    CHECK(openness < 1e-15);
    CHECK_OK(nurbs_enclosed_volume(5, (const nurbs *const *)faces, 0, &volume, NULL, NULL, &openness, NULL));
    CHECK_NEAR(&openness, &(double){1}, 1, 1e-14);
    for (int i = 0; i < 6; ++i) {
        nurbs_destroy(faces[i]);
    }
    nurbs_list_destroy(list);
    nurbs_destroy(g);
}

static void bad_curves(void) {
    double length = 5, out[4];
    FILL(out);
    nurbs *g = make(circle()), *s = make(trough()), *still = make(stairs());
    CHECK_FAILS(nurbs_curve_length(NULL, NULL, 0, &length, NULL), NURBS_ERROR_NULL, "g");
    CHECK_FAILS(nurbs_curve_length(g, NULL, 0, NULL, NULL), NURBS_ERROR_NULL, "length");
    CHECK_FAILS(nurbs_curve_length(s, NULL, 0, &length, NULL), NURBS_ERROR_AXES, "2|curve");
    CHECK_FAILS(nurbs_curve_length(g, NULL, -1, &length, NULL), NURBS_ERROR_TOLERANCE,
                "relative_tolerance|-1");
    CHECK_FAILS(nurbs_curve_length(g, NULL, NAN, &length, NULL), NURBS_ERROR_TOLERANCE,
                "relative_tolerance|nan");
    CHECK_FAILS(nurbs_curve_length(g, (const double[]){0, NAN}, 0, &length, NULL),
                NURBS_ERROR_PARAMETER_NOT_FINITE, "range|nan");
    CHECK_FAILS(nurbs_curve_length(g, (const double[]){0, 1.5}, 0, &length, NULL), NURBS_ERROR_OUTSIDE_DOMAIN,
                "range|1.5");
    CHECK_FAILS(nurbs_curve_length(g, (const double[]){0.5, 0.5}, 0, &length, NULL), NURBS_ERROR_EMPTY_DOMAIN,
                "range|0.5");
    CHECK_FAILS(nurbs_curve_length(g, NULL, 0, &length, &length), NURBS_ERROR_OVERLAP, "length|error");
    CHECK_FAILS(nurbs_curve_lengths(g, -1, out, 0, 0, out, 0), NURBS_ERROR_COUNT, "n = -1");
    CHECK_FAILS(nurbs_curve_lengths(g, 1, NULL, 0, 0, out, 0), NURBS_ERROR_NULL, "params");
    CHECK_FAILS(nurbs_curve_lengths(g, 1, out, -1, 0, out + 1, 0), NURBS_ERROR_STRIDE, "params|-1");
    CHECK_FAILS(nurbs_curve_lengths(g, 1, out, 0, 0, out, 0), NURBS_ERROR_OVERLAP, "lengths|params");
    CHECK_FAILS(nurbs_curve_lengths(g, 2, (const double[]){0, 2}, 0, 0, out, 0), NURBS_ERROR_OUTSIDE_DOMAIN,
                "params[1] = 2");
    CHECK_FAILS(nurbs_curve_params_at_lengths(g, 2, (const double[]){0, 7}, 0, 0, out, 0, 0),
                NURBS_ERROR_LENGTH, "lengths[1] = 7|6.28");
    CHECK_FAILS(nurbs_curve_params_at_lengths(g, 1, (const double[]){NAN}, 0, 0, out, 0, NURBS_CLAMP),
                NURBS_ERROR_LENGTH, "lengths[0] = nan");
    CHECK_FAILS(nurbs_curve_params_at_lengths(g, 1, (const double[]){0}, 0, 0, out, 0, NURBS_LEFT),
                NURBS_ERROR_FLAGS, "flags = 0x1");
    CHECK_FAILS(nurbs_curve_divide(g, NULL, 0, 0, 0, out, &length), NURBS_ERROR_COUNT, "parts = 0");
    CHECK_FAILS(nurbs_curve_divide(g, NULL, INT64_MAX, 0, 0, out, &length), NURBS_ERROR_OVERFLOW, "params");
    CHECK_FAILS(nurbs_curve_divide(g, NULL, 2, 0, 1, out, &length), NURBS_ERROR_FLAGS, "flags = 0x1");
    CHECK_FAILS(nurbs_curve_divide(g, NULL, 2, 0, 0, NULL, &length), NURBS_ERROR_NULL, "params");
    CHECK_FAILS(nurbs_curve_divide(still, NULL, 2, 0, 0, out, &length), NURBS_ERROR_LENGTH, "no length");
    CHECK_FAILS(nurbs_curve_divide(g, NULL, 2, 0, 0, out, out + 1), NURBS_ERROR_OVERLAP, "params|size");
    CHECK_DOUBLE(length, 5);
    CHECK_UNTOUCHED(out);
    nurbs_destroy(g);
    nurbs_destroy(s);
    nurbs_destroy(still);
}

static void bad_shapes(void) {
    double area = 5, out[9];
    FILL(out);
    nurbs *curve = make(circle()), *surface = make(trough()), *volume = make(cube()), *open = make(arch());
    const nurbs *pair[] = {curve, NULL}, *arcs[] = {curve, open}, *one[] = {surface}, *spatial[] = {NULL};
    nurbs *space = make(twist());
    spatial[0] = space;
    CHECK_FAILS(nurbs_surface_area(curve, NULL, 0, &area, NULL), NURBS_ERROR_AXES, "1|surface");
    CHECK_FAILS(nurbs_surface_area(surface, (const double[]){0, 1, 2, 4}, 0, &area, NULL),
                NURBS_ERROR_OUTSIDE_DOMAIN, "range|4");
    CHECK_FAILS(nurbs_moments(volume, 0, &area, NULL, NULL, NULL), NURBS_ERROR_DIMENSION, "4|3");
    CHECK_FAILS(nurbs_moments(curve, 0, NULL, NULL, NULL, NULL), NURBS_ERROR_NULL, "content");
    CHECK_FAILS(nurbs_moments(curve, 0, &area, out, out + 1, NULL), NURBS_ERROR_OVERLAP, "centroid|inertia");
    CHECK_FAILS(nurbs_enclosed_area(0, NULL, 0, 0, &area, NULL, NULL, NULL), NURBS_ERROR_COUNT, "0");
    CHECK_FAILS(nurbs_enclosed_area(2, pair, 0, 0, &area, NULL, NULL, NULL), NURBS_ERROR_NULL, "curves[1]");
    CHECK_FAILS(nurbs_enclosed_area(1, one, 0, 0, &area, NULL, NULL, NULL), NURBS_ERROR_AXES, "curves[0]");
    CHECK_FAILS(nurbs_enclosed_area(1, spatial, 0, 0, &area, NULL, NULL, NULL), NURBS_ERROR_DIMENSION,
                "curves[0]|3|2");
    CHECK_FAILS(nurbs_enclosed_area(2, arcs, 1e-9, 0, &area, NULL, NULL, NULL), NURBS_ERROR_GAP,
                "curves[1]|3|1e-09");
    CHECK_FAILS(nurbs_enclosed_area(1, arcs, -1, 0, &area, NULL, NULL, NULL), NURBS_ERROR_TOLERANCE,
                "tolerance = -1");
    CHECK_FAILS(nurbs_enclosed_volume(1, pair, 0, &area, NULL, NULL, NULL, NULL), NURBS_ERROR_AXES,
                "surfaces[0]|1");
    CHECK_FAILS(nurbs_enclosed_volume(1, one, 0, NULL, NULL, NULL, NULL, NULL), NURBS_ERROR_NULL, "volume");
    nurbs *still = make(stairs());
    CHECK_FAILS(nurbs_moments(still, 0, &area, out, NULL, NULL), NURBS_ERROR_LENGTH, "0");
    CHECK_DOUBLE(area, 5);
    CHECK_UNTOUCHED(out);
    nurbs_destroy(still);
    nurbs_destroy(curve);
    nurbs_destroy(surface);
    nurbs_destroy(volume);
    nurbs_destroy(open);
    nurbs_destroy(space);
}

static nurbs *line(double x) {
    static const int32_t degree = 1;
    const double points[] = {-x, x};
    nurbs *g = NULL;
    CHECK_OK(nurbs_create_bezier(1, &degree, 1, points, 0, 0, NULL, 0, &g));
    return g;
}

/* Of a square with sides of 2 size: what is not asked for may overflow. */
static void large_regions(void) {
    static const int32_t degree = 1;
    static const int64_t count = 5;
    static const double knots[] = {0, 0, 1, 2, 3, 4, 4}, corners[] = {-1, -1, 1, -1, 1, 1, -1, 1, -1, -1};
    double points[10], area = 5, centroid[2] = {5, 5}, inertia[4], error;
    for (int power = -500; power <= 500; power += 250) {
        const double size = ldexp(1, power);
        nurbs *g = NULL;
        for (int i = 0; i < 10; ++i) {
            points[i] = size * corners[i];
        }
        CHECK_OK(nurbs_create(1, &degree, &count, knots, 7, 2, points, 0, 0, NULL, 0, 0, &g));
        const nurbs *const *curves = (const nurbs *const *)&g;
        CHECK_OK(nurbs_enclosed_area(1, curves, 0, 0, &area, centroid, NULL, &error));
        CHECK_NEAR(&area, &(double){4 * size * size}, 1, 1e-14 * size * size);
        CHECK_NEAR(centroid, ((const double[]){0, 0}), 2, 1e-15 * size);
        CHECK_OK(nurbs_moments(g, 0, &area, centroid, NULL, &error));
        CHECK_NEAR(&area, &(double){8 * size}, 1, 1e-14 * size);
        FILL(inertia);
        if (power == 500) {
            CHECK_FAILS(nurbs_enclosed_area(1, curves, 0, 0, &area, NULL, inertia, NULL),
                        NURBS_ERROR_NOT_REPRESENTABLE, "inertia");
            CHECK_FAILS(nurbs_moments(g, 0, &area, NULL, inertia, NULL), NURBS_ERROR_NOT_REPRESENTABLE,
                        "inertia");
            CHECK_UNTOUCHED(inertia);
        } else {
            CHECK_OK(nurbs_enclosed_area(1, curves, 0, 0, &area, NULL, inertia, NULL));
            CHECK_NEAR(&inertia[0], &(double){ldexp(4. / 3, 4 * power)}, 1, ldexp(1e-14, 4 * power));
        }
        nurbs_destroy(g);
    }
}

/* Lengths that overflow, and curves with a pole. */
static void out_of_range(void) {
    static const int32_t degree = 1;
    static const double pole[] = {1, 1, 1, -1};
    double length = 5;
    nurbs *g = line(1e308);
    CHECK_FAILS(nurbs_curve_length(g, NULL, 0, &length, NULL), NURBS_ERROR_NOT_REPRESENTABLE, "overflow");
    nurbs_destroy(g);
    g = line(5e307);
    CHECK_OK(nurbs_curve_length(g, NULL, 0, &length, NULL));
    CHECK_NEAR(&length, &(double){1e308}, 1, 1e293);
    nurbs_destroy(g);
    g = line(5e-324);
    CHECK_OK(nurbs_curve_length(g, NULL, 0, &length, NULL));
    CHECK_DOUBLE(length, 1e-323);
    nurbs_destroy(g);
    static const double knots[] = {0, 0, 1, 1};
    static const int64_t count = 2;
    CHECK_OK(nurbs_create_homogeneous(1, &degree, &count, knots, 4, 1, pole, 0, 0, 0, &g));
    length = 5;
    CHECK_FAILS(nurbs_curve_length(g, NULL, 1e-3, &length, NULL), NURBS_ERROR_NOT_CONVERGED, "length|0.001");
    CHECK_DOUBLE(length, 5);
    nurbs_destroy(g);
}

int main(void) {
    lengths();
    strides();
    closed_by_their_knots();
    one_start_for_each_end();
    divisions();
    divided_before_a_jump();
    areas();
    bodies();
    bad_curves();
    bad_shapes();
    large_regions();
    out_of_range();
    return check_summary("measure");
}
