/* SPDX-License-Identifier: MIT */
/* Contours, algebraic levels and level curves of surfaces: known ones, bad input. */
#include "shapes.h"

#include <math.h>

static const double turn = 6.283185307179586, along[] = {0, 0, 3}, cosines[] = {0.5, -0.5, 0};

static nurbs *ball(void) {
    nurbs *g = NULL;
    CHECK_OK(nurbs_surface_sphere(NULL, NULL, NULL, 2, NURBS_ARC_QUARTERS, &g));
    return g;
}

/* Of a meet of a ball: all branches lie at heights z of their levels. */
static void check_heights(nurbs_meet *meet, int64_t branches, const double *heights) {
    int64_t count = 0, levels[8];
    int32_t complete = 0;
    double deviations[8];
    CHECK_OK(nurbs_meet_counts(meet, &count, NULL, &complete));
    CHECK(count == branches && complete == 1);
    CHECK_OK(nurbs_meet_branches(meet, 8, levels, NULL, NULL, deviations, NULL));
    for (int64_t i = 0; i < branches; ++i) {
        nurbs *space = NULL, *on = NULL;
        double domain[2], x[3];
        CHECK_OK(nurbs_meet_branch(meet, i, &space, &on));
        CHECK_OK(nurbs_domain(space, 0, domain));
        for (int j = 0; j <= 10; ++j) {
            const double t = j == 10 ? domain[1] : domain[0] + (domain[1] - domain[0]) * j / 10;
            CHECK_OK(nurbs_eval(space, 1, &t, 0, 0, x, 0, 0, 0));
            CHECK(fabs(x[2] - heights[levels[i]]) <= deviations[i] + 1e-12 && deviations[i] <= 1e-6);
        }
        nurbs_destroy(on);
        nurbs_destroy(space);
    }
    nurbs_meet_destroy(meet);
}

static void of_a_ball(void) {
    nurbs *g = ball();
    nurbs_meet *meet = NULL;
    const double equator[] = {0}, eye[] = {0, 0, 4}, seen[] = {1}, lit[] = {1, -1, 0};
    CHECK_OK(nurbs_surface_contours(g, NURBS_CONTOUR_SILHOUETTE, along, 0, NULL, 1e-6, &meet));
    check_heights(meet, 1, equator);
    CHECK_OK(nurbs_surface_contours(g, NURBS_CONTOUR_PERSPECTIVE, eye, 0, NULL, 1e-6, &meet));
    check_heights(meet, 1, seen);
    CHECK_OK(nurbs_surface_contours_with(g, NURBS_CONTOUR_ISOPHOTE, along, 3, cosines, 1e-6, NULL, &meet));
    check_heights(meet, 3, lit);
    CHECK_OK(nurbs_surface_contours(g, NURBS_CONTOUR_ISOPHOTE, along, 0, NULL, 1e-6, &meet));
    check_heights(meet, 0, lit);
    CHECK_OK(nurbs_surface_contours(g, NURBS_CONTOUR_PARABOLIC, NULL, 0, NULL, 1e-6, &meet));
    check_heights(meet, 0, lit);
    nurbs_destroy(g);
}

/* Normals of a ball meet a line in the plane of the centre and the line; seen along that plane from afar, or from a point in it,
 * the same circle is a part of what mirrors the line. */
static void reflections_of_a_ball(void) {
    nurbs *g = ball();
    const double along_x[] = {1, 0, 0}, below[] = {0, 0, -1}, lights[] = {0, 0, 5, 7, 0, 0, 6, 7},
                 eye[] = {1, 0, 9};
    for (int32_t kind = NURBS_REFLECTION_HIGHLIGHT; kind <= NURBS_REFLECTION_FROM; ++kind) {
        nurbs_meet *meet = NULL;
        int64_t branches = 0, levels[64];
        int32_t complete = 0;
        double deviations[64], middle = INFINITY;
        CHECK_OK(nurbs_surface_reflections(g, kind, kind == NURBS_REFLECTION_FROM ? eye : below, along_x, 2,
                                           lights, 4, 1, 1e-6, &meet));
        CHECK_OK(nurbs_meet_counts(meet, &branches, NULL, &complete));
        CHECK(branches >= 2 && branches <= 64 && complete == 1);
        CHECK_OK(nurbs_meet_branches(meet, 64, levels, NULL, NULL, deviations, NULL));
        CHECK(levels[0] == 0 && levels[branches - 1] == 1);
        for (int64_t i = 0; i < branches && levels[i] == 0; ++i) {
            nurbs *space = NULL, *on = NULL;
            double domain[2], x[3];
            CHECK_OK(nurbs_meet_branch(meet, i, &space, &on));
            CHECK_OK(nurbs_domain(space, 0, domain));
            const double t = domain[0] / 2 + domain[1] / 2;
            CHECK_OK(nurbs_eval(space, 1, &t, 0, 0, x, 0, 0, 0));
            CHECK(fabs(sqrt(x[0] * x[0] + x[1] * x[1] + x[2] * x[2]) - 2) <= deviations[i] + 1e-12);
            middle = fmin(middle, fabs(x[1]));
            nurbs_destroy(on);
            nurbs_destroy(space);
        }
        CHECK(middle <= 1e-6);
        nurbs_meet_destroy(meet);
    }
    nurbs_destroy(g);
}

/* x^2 + y^2 = 3 at z = 1 and -1, and a plane. */
static void levels_of_a_ball(void) {
    nurbs *g = ball();
    nurbs_meet *meet = NULL;
    const double cylinder[] = {1, 0, 0, 0, 1, 0, 0, 0, 0, -3}, plane[] = {0, 0, 1, -0.5}, height[] = {0.5};
    CHECK_OK(nurbs_surface_level(g, 1, plane, 1e-6, &meet));
    check_heights(meet, 1, height);
    CHECK_OK(nurbs_surface_level_with(g, 2, cylinder, 1e-6, NULL, &meet));
    int64_t branches = 0;
    CHECK_OK(nurbs_meet_counts(meet, &branches, NULL, NULL));
    CHECK_INT(branches, 2);
    nurbs_meet_destroy(meet);
    nurbs_destroy(g);
}

/* The coordinate z of the ball as a function, on fewer knots in v: v itself is one. */
static nurbs *function_of(const nurbs *g) {
    double u[2], v[2];
    CHECK_OK(nurbs_domain(g, 0, u));
    CHECK_OK(nurbs_domain(g, 1, v));
    const int32_t degrees[] = {0, 1};
    const int64_t counts[] = {1, 2};
    const double knots[] = {u[0], u[1], v[0], v[0], v[1], v[1]}, points[] = {-1, 1};
    nurbs *scalar = NULL;
    CHECK_OK(nurbs_create(2, degrees, counts, knots, 6, 1, points, 0, 0, NULL, 0, 0, &scalar));
    return scalar;
}

static void level_curves_of_a_ball(void) {
    nurbs *g = ball(), *scalar = function_of(g);
    nurbs_meet *meet = NULL;
    const double middle[] = {0, 5}, height[] = {0, NAN};
    CHECK_OK(nurbs_surface_level_curves(g, scalar, 2, middle, 1e-6, &meet));
    check_heights(meet, 1, height);
    CHECK_OK(nurbs_surface_level_curves_with(g, scalar, 0, NULL, 1e-6, NULL, &meet));
    check_heights(meet, 0, height);
    nurbs_destroy(scalar);
    nurbs_destroy(g);
}

/* A limit of work leaves open what was not looked at. */
static void limited(void) {
    nurbs *g = NULL, *scalar = NULL;
    CHECK_OK(nurbs_surface_torus(NULL, NULL, NULL, 3, 1, 0, turn, 0, turn, NURBS_ARC_QUARTERS, &g));
    scalar = function_of(g);
    const double plane[] = {0, 0, 1, -0.5}, value[] = {0.3};
    nurbs_call_options call;
    CHECK_OK(nurbs_call_options_init(&call, sizeof call));
    call.work = 10;
    for (int i = 0; i < 4; ++i) {
        nurbs_meet *meet = NULL;
        int32_t complete = 1;
        if (i == 0) {
            CHECK_OK(
                nurbs_surface_contours_with(g, NURBS_CONTOUR_SILHOUETTE, along, 0, NULL, 1e-6, &call, &meet));
        } else if (i == 1) {
            CHECK_OK(nurbs_surface_level_with(g, 1, plane, 1e-6, &call, &meet));
        } else if (i == 2) {
            CHECK_OK(nurbs_surface_reflections_with(g, NURBS_REFLECTION_ALONG, along, along, 1, plane + 1, 0,
                                                    0, 1e-6, &call, &meet));
        } else {
            CHECK_OK(nurbs_surface_level_curves_with(g, scalar, 1, value, 1e-6, &call, &meet));
        }
        CHECK_OK(nurbs_meet_counts(meet, NULL, NULL, &complete));
        CHECK_INT(complete, 0);
        nurbs_meet_destroy(meet);
    }
    nurbs_destroy(scalar);
    nurbs_destroy(g);
}

#define REFUSED(call, status, text)                                                                          \
    do {                                                                                                     \
        nurbs_meet *none = (nurbs_meet *)(void *)check_poison();                                             \
        CHECK_FAILS(call, status, text);                                                                     \
        CHECK(none == NULL);                                                                                 \
    } while (0)

static void refused_reflections(void) {
    nurbs *g = ball(), *curve = make(arch());
    const double nowhere[] = {0, 0, 0}, unknown[] = {0, NAN, 1}, light[] = {1, 2, 3},
                 lost[] = {1, 2, INFINITY};
    const int32_t highlight = NURBS_REFLECTION_HIGHLIGHT, seen = NURBS_REFLECTION_ALONG,
                  from = NURBS_REFLECTION_FROM;
#define REFLECT(...) nurbs_surface_reflections(__VA_ARGS__, &none)
    REFUSED(REFLECT(NULL, seen, along, along, 1, light, 0, 0, 1e-3), NURBS_ERROR_NULL, "g is NULL");
    REFUSED(REFLECT(curve, seen, along, along, 1, light, 0, 0, 1e-3), NURBS_ERROR_AXES, "surface");
    REFUSED(REFLECT(g, 0, along, along, 1, light, 0, 0, 1e-3), NURBS_ERROR_RULE, "kind = 0");
    REFUSED(REFLECT(g, 4, along, along, 1, light, 0, 0, 1e-3), NURBS_ERROR_RULE, "kind = 4");
    REFUSED(REFLECT(g, seen, NULL, along, 1, light, 0, 0, 1e-3), NURBS_ERROR_NULL, "eye is NULL");
    REFUSED(REFLECT(g, from, unknown, along, 1, light, 0, 0, 1e-3), NURBS_ERROR_DIRECTION, "eye[1]");
    REFUSED(REFLECT(g, seen, nowhere, along, 1, light, 0, 0, 1e-3), NURBS_ERROR_DIRECTION, "eye is 0");
    REFUSED(REFLECT(g, highlight, NULL, NULL, 1, light, 0, 0, 1e-3), NURBS_ERROR_NULL, "direction is NULL");
    REFUSED(REFLECT(g, highlight, NULL, nowhere, 1, light, 0, 0, 1e-3), NURBS_ERROR_DIRECTION,
            "direction is 0");
    REFUSED(REFLECT(g, highlight, NULL, along, -1, light, 0, 0, 1e-3), NURBS_ERROR_COUNT, "n = -1");
    REFUSED(REFLECT(g, highlight, NULL, along, INT64_MAX, light, 0, 0, 1e-3), NURBS_ERROR_OVERFLOW, "points");
    REFUSED(REFLECT(g, highlight, NULL, along, 1, NULL, 0, 0, 1e-3), NURBS_ERROR_NULL, "points");
    REFUSED(REFLECT(g, highlight, NULL, along, 1, light, -3, 1, 1e-3), NURBS_ERROR_STRIDE, "stride");
    REFUSED(REFLECT(g, highlight, NULL, along, 1, lost, 0, 0, 1e-3), NURBS_ERROR_POINT_NOT_FINITE, "points");
    REFUSED(REFLECT(g, highlight, NULL, along, 1, light, 0, 0, 0), NURBS_ERROR_TOLERANCE, "tolerance");
    nurbs_meet *none = NULL;
    CHECK_FAILS(nurbs_surface_reflections(g, highlight, NULL, along, 1, light, 0, 0, 1e-3, NULL),
                NURBS_ERROR_NULL, "out");
    CHECK_OK(REFLECT(g, highlight, NULL, along, 0, NULL, 0, 0, 1e-3));
    nurbs_meet_destroy(none);
    nurbs_destroy(curve);
    nurbs_destroy(g);
}

static void refused_contours(void) {
    nurbs *g = ball(), *curve = make(arch());
    const double nowhere[] = {0, 0, 0}, unknown[] = {0, NAN, 1}, beyond[] = {0, 1.5};
    const int32_t outline = NURBS_CONTOUR_SILHOUETTE, lit = NURBS_CONTOUR_ISOPHOTE;
    REFUSED(nurbs_surface_contours(NULL, outline, along, 0, NULL, 1e-3, &none), NURBS_ERROR_NULL,
            "g is NULL");
    REFUSED(nurbs_surface_contours(curve, outline, along, 0, NULL, 1e-3, &none), NURBS_ERROR_AXES, "surface");
    REFUSED(nurbs_surface_contours(g, 0, along, 0, NULL, 1e-3, &none), NURBS_ERROR_RULE, "kind = 0");
    REFUSED(nurbs_surface_contours(g, 5, along, 0, NULL, 1e-3, &none), NURBS_ERROR_RULE, "kind = 5");
    REFUSED(nurbs_surface_contours(g, outline, NULL, 0, NULL, 1e-3, &none), NURBS_ERROR_NULL, "d is NULL");
    REFUSED(nurbs_surface_contours(g, outline, nowhere, 0, NULL, 1e-3, &none), NURBS_ERROR_DIRECTION,
            "d is 0");
    REFUSED(nurbs_surface_contours(g, lit, unknown, 0, NULL, 1e-3, &none), NURBS_ERROR_DIRECTION, "d[1]");
    REFUSED(nurbs_surface_contours(g, outline, along, 1, cosines, 1e-3, &none), NURBS_ERROR_COUNT, "n = 1");
    REFUSED(nurbs_surface_contours(g, lit, along, -1, cosines, 1e-3, &none), NURBS_ERROR_COUNT, "n = -1");
    REFUSED(nurbs_surface_contours(g, lit, along, INT64_MAX, cosines, 1e-3, &none), NURBS_ERROR_OVERFLOW,
            "cosines");
    REFUSED(nurbs_surface_contours(g, lit, along, 1, NULL, 1e-3, &none), NURBS_ERROR_NULL, "cosines");
    REFUSED(nurbs_surface_contours(g, lit, along, 2, beyond, 1e-3, &none), NURBS_ERROR_FACTOR, "cosines[1]");
    REFUSED(nurbs_surface_contours(g, outline, along, 0, NULL, 0, &none), NURBS_ERROR_TOLERANCE, "tolerance");
    REFUSED(nurbs_surface_contours(g, outline, along, 0, NULL, NAN, &none), NURBS_ERROR_TOLERANCE,
            "tolerance");
    CHECK_FAILS(nurbs_surface_contours(g, outline, along, 0, NULL, 1e-3, NULL), NURBS_ERROR_NULL, "out");
    nurbs *high = NULL;
    CHECK_OK(nurbs_elevate(g, 0, 10, &high));
    REFUSED(nurbs_surface_contours(high, NURBS_CONTOUR_PARABOLIC, NULL, 0, NULL, 1e-3, &none),
            NURBS_ERROR_DEGREE, "degree 12");
    nurbs_destroy(high);
    nurbs_destroy(curve);
    nurbs_destroy(g);
}

static void refused_levels(void) {
    nurbs *g = ball(), *curve = make(arch()), *scalar = function_of(g), *moved = NULL;
    const double plane[] = {0, 0, 1, -0.5}, constant[] = {0, 0, 0, 1}, unknown[] = {0, 0, INFINITY, 1},
                 bad[] = {0, NAN};
    REFUSED(nurbs_surface_level(NULL, 1, plane, 1e-3, &none), NURBS_ERROR_NULL, "g is NULL");
    REFUSED(nurbs_surface_level(curve, 1, plane, 1e-3, &none), NURBS_ERROR_AXES, "surface");
    REFUSED(nurbs_surface_level(g, 0, plane, 1e-3, &none), NURBS_ERROR_DEGREE, "degree = 0");
    REFUSED(nurbs_surface_level(g, 1, NULL, 1e-3, &none), NURBS_ERROR_NULL, "coefficients");
    REFUSED(nurbs_surface_level(g, 1, constant, 1e-3, &none), NURBS_ERROR_DIRECTION, "coefficients");
    REFUSED(nurbs_surface_level(g, 1, unknown, 1e-3, &none), NURBS_ERROR_POINT_NOT_FINITE, "coefficients[2]");
    REFUSED(nurbs_surface_level(g, 1, plane, -1, &none), NURBS_ERROR_TOLERANCE, "tolerance");
    REFUSED(nurbs_surface_level_curves(NULL, scalar, 1, plane, 1e-3, &none), NURBS_ERROR_NULL, "g is NULL");
    REFUSED(nurbs_surface_level_curves(g, NULL, 1, plane, 1e-3, &none), NURBS_ERROR_NULL, "scalar is NULL");
    REFUSED(nurbs_surface_level_curves(g, curve, 1, plane, 1e-3, &none), NURBS_ERROR_AXES, "scalar");
    REFUSED(nurbs_surface_level_curves(g, g, 1, plane, 1e-3, &none), NURBS_ERROR_DIMENSION, "scalar");
    REFUSED(nurbs_surface_level_curves(g, scalar, -1, plane, 1e-3, &none), NURBS_ERROR_COUNT, "n = -1");
    REFUSED(nurbs_surface_level_curves(g, scalar, INT64_MAX, plane, 1e-3, &none), NURBS_ERROR_OVERFLOW,
            "values");
    REFUSED(nurbs_surface_level_curves(g, scalar, 1, NULL, 1e-3, &none), NURBS_ERROR_NULL, "values");
    REFUSED(nurbs_surface_level_curves(g, scalar, 2, bad, 1e-3, &none), NURBS_ERROR_POINT_NOT_FINITE,
            "values[1]");
    REFUSED(nurbs_surface_level_curves(g, scalar, 1, plane, 0, &none), NURBS_ERROR_TOLERANCE, "tolerance");
    CHECK_OK(nurbs_reparametrize(scalar, 1, 0, 7, &moved));
    REFUSED(nurbs_surface_level_curves(g, moved, 1, plane, 1e-3, &none), NURBS_ERROR_INCOMPATIBLE, "axis 1");
    nurbs_destroy(moved);
    nurbs_destroy(scalar);
    nurbs_destroy(curve);
    nurbs_destroy(g);
}

int main(void) {
    of_a_ball();
    reflections_of_a_ball();
    levels_of_a_ball();
    level_curves_of_a_ball();
    limited();
    refused_contours();
    refused_reflections();
    refused_levels();
    return check_summary("contours");
}
