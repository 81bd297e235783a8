/* SPDX-License-Identifier: MIT */
/* Closest points of curves. */
#include "shapes.h"

#include <stdint.h>

/* The arguments of nurbs_closest_points() and nurbs_farthest_points(), and what they write. */
typedef struct Request {
    const nurbs *g;
    int64_t n;
    const double *points;
    int64_t point_stride, point_component_stride;
    const double *range;
    double tolerance;
    int64_t budget;
    double *params;
    int64_t param_stride, param_component_stride;
    double *feet;
    int64_t foot_stride, foot_component_stride;
    double *distances;
    int64_t distance_stride;
    int32_t *status;
    uint32_t flags;
} Request;

static double params[8], feet[16], distances[8];
static int32_t states[8];

static Request request(const nurbs *g, int64_t n, const double *points) {
    Request r = {g, n, points, 0, 0, NULL, 0, 0, params, 0, 0, feet, 0, 0, distances, 0, states, 0};
    return r;
}

static nurbs_status closest(const Request *r) {
    return nurbs_closest_points(r->g, r->n, r->points, r->point_stride, r->point_component_stride, r->range,
                                r->tolerance, r->budget, r->params, r->param_stride,
                                r->param_component_stride, r->feet, r->foot_stride, r->foot_component_stride,
                                r->distances, r->distance_stride, r->status, r->flags);
}

static nurbs_status farthest(const Request *r) {
    return nurbs_farthest_points(r->g, r->n, r->points, r->point_stride, r->point_component_stride, r->range,
                                 r->tolerance, r->budget, r->params, r->param_stride,
                                 r->param_component_stride, r->feet, r->foot_stride, r->foot_component_stride,
                                 r->distances, r->distance_stride, r->status, r->flags);
}

static const double segment_knots[] = {0, 0, 1, 1};
static const double corner_knots[] = {0, 0, 1, 2, 2};
static const int32_t one[] = {1};

/* From (0, 0) to (4, 0) at t in [0, 1]. */
static nurbs *segment(void) {
    static const int64_t counts[] = {2};
    static const double points[] = {0, 0, 4, 0};
    SplineArgs a = {1, one, counts, segment_knots, 4, 2, points, 0, 0, NULL, 0, 0};
    return make(a);
}

/* From (0, 0) over (1, 0) to (1, 1). */
static nurbs *corner(void) {
    static const int64_t counts[] = {3};
    static const double points[] = {0, 0, 1, 0, 1, 1};
    SplineArgs a = {1, one, counts, corner_knots, 5, 2, points, 0, 0, NULL, 0, 0};
    return make(a);
}

static nurbs *unit_circle(void) {
    static const double center[] = {0, 0}, x[] = {1, 0};
    nurbs *g = NULL;
    CHECK_OK(nurbs_curve_circle(2, center, NULL, x, 1, NURBS_ARC_QUARTERS, &g));
    return g;
}

static void known_answers(void) {
    static const double points[] = {1, 3, -3, 4, 4, 0}, expected[] = {0.25, 0, 1}, far[] = {3, 5, 0};
    static const double foot[] = {1, 0, 0, 0, 4, 0}, farther[] = {4, 0, 4, 0, 0, 0};
    nurbs *g = segment();
    Request r = request(g, 3, points);
    CHECK_OK(closest(&r));
    CHECK_NEAR(params, expected, 3, 1e-15);
    CHECK_NEAR(feet, foot, 6, 1e-15);
    CHECK_NEAR(distances, far, 3, 1e-15);
    CHECK_INT(states[0], NURBS_CLOSEST_CERTIFIED);
    CHECK_INT(states[1], NURBS_CLOSEST_CERTIFIED | NURBS_CLOSEST_BOUNDARY);
    CHECK_INT(states[2], NURBS_CLOSEST_CERTIFIED | NURBS_CLOSEST_BOUNDARY);
    CHECK_OK(farthest(&r));
    CHECK_DOUBLES(feet, farther, 6);
    CHECK_INT(states[0], NURBS_CLOSEST_CERTIFIED | NURBS_CLOSEST_BOUNDARY);
    nurbs_destroy(g);
}

static void ranges_and_strides(void) {
    static const double points[] = {1, 9, 3, 3, 9, 9}, range[] = {0.5, 1}, expected[] = {0.5, 0.75};
    double wide[6] = {7, 7, 7, 7, 7, 7}, apart[4];
    nurbs *g = segment();
    Request r = request(g, 2, points);
    r.range = range;
    r.point_stride = 1;
    r.point_component_stride = 2; /* x of both, then y of both: (1, 3) and (9, 3) */
    r.params = wide;
    r.param_stride = 3;
    r.feet = apart;
    r.foot_stride = 1;
    r.foot_component_stride = 2;
    CHECK_OK(closest(&r));
    CHECK_DOUBLE(wide[0], expected[0]);
    CHECK_DOUBLE(wide[1], 7);
    CHECK_DOUBLE(wide[3], 1);
    CHECK_DOUBLES(apart, ((const double[]){2, 4, 0, 0}), 4);
    CHECK_INT(states[0], NURBS_CLOSEST_CERTIFIED | NURBS_CLOSEST_BOUNDARY);
    r.params = NULL;
    r.feet = NULL;
    r.distances = NULL;
    r.status = NULL;
    CHECK_OK(closest(&r));
    r = request(g, 0, NULL);
    r.params = NULL;
    CHECK_OK(closest(&r));
    nurbs_destroy(g);
}

static void ties_and_budgets(void) {
    static const double middle[] = {0, 0}, near[] = {0.5, 0.25};
    nurbs *g = unit_circle();
    Request r = request(g, 1, middle);
    CHECK_OK(closest(&r));
    CHECK((states[0] & NURBS_CLOSEST_CERTIFIED) != 0 && (states[0] & NURBS_CLOSEST_NOT_UNIQUE) != 0);
    CHECK_NEAR(distances, ((const double[]){1}), 1, 1e-15);
    r = request(g, 1, near);
    r.budget = 1;
    CHECK_OK(closest(&r));
    CHECK_INT(states[0], NURBS_CLOSEST_BUDGET);
    r.budget = 0;
    CHECK_OK(closest(&r));
    CHECK_INT(states[0], NURBS_CLOSEST_CERTIFIED);
    nurbs_destroy(g);
}

static void points_that_are_no_numbers(void) {
    const double bad[] = {1, 3, NAN, 3, 2, -1};
    nurbs *g = segment();
    Request r = request(g, 3, bad);
    FILL(params);
    CHECK_FAILS(closest(&r), NURBS_ERROR_POINT_NOT_FINITE, "points[1][0]|nan");
    CHECK_UNTOUCHED(params);
    r.flags = NURBS_NAN_POINTS;
    CHECK_OK(closest(&r));
    CHECK_DOUBLE(params[0], 0.25);
    CHECK(isnan(params[1]) && isnan(feet[2]) && isnan(feet[3]) && isnan(distances[1]));
    CHECK_INT(states[1], NURBS_CLOSEST_INVALID);
    CHECK_DOUBLE(params[2], 0.5);
    nurbs_destroy(g);
}

static void refuse(int line, Request r, nurbs_status status, const char *words) {
    FILL(params);
    FILL(feet);
    FILL(distances);
    FILL(states);
    nurbs_status (*const calls[])(const Request *) = {closest, farthest};
    for (int i = 0; i < 2; ++i) {
        check_forget();
        check_refusal(__FILE__, line, calls[i](&r), status, words);
        CHECK_UNTOUCHED(params);
        CHECK_UNTOUCHED(feet);
        CHECK_UNTOUCHED(distances);
        CHECK_UNTOUCHED(states);
    }
}

#define REFUSE(field, value, status, words)                                                                  \
    do {                                                                                                     \
        Request request_ = request(g, 2, points);                                                            \
        request_.field = (value);                                                                            \
        refuse(__LINE__, request_, status, words);                                                           \
    } while (0)

static void bad_input(void) {
    static const double points[] = {1, 3, 2, 2}, empty[] = {0.5, 0.5}, outside[] = {0.5, 1.5};
    const double no_number[] = {NAN, 1}, endless[] = {0, INFINITY};
    nurbs *g = segment();
    REFUSE(g, NULL, NURBS_ERROR_NULL, "g");
    REFUSE(points, NULL, NURBS_ERROR_NULL, "points");
    REFUSE(n, -1, NURBS_ERROR_COUNT, "n|-1");
    REFUSE(n, INT64_MAX, NURBS_ERROR_OVERFLOW, "");
    REFUSE(point_stride, -2, NURBS_ERROR_STRIDE, "point");
    REFUSE(param_stride, -1, NURBS_ERROR_STRIDE, "param");
    REFUSE(foot_stride, 1, NURBS_ERROR_STRIDE, "feet");
    REFUSE(distance_stride, -1, NURBS_ERROR_STRIDE, "distances");
    REFUSE(tolerance, -1, NURBS_ERROR_TOLERANCE, "tolerance|-1");
    REFUSE(tolerance, NAN, NURBS_ERROR_TOLERANCE, "tolerance");
    REFUSE(budget, -1, NURBS_ERROR_COUNT, "budget|-1");
    REFUSE(flags, NURBS_NAN, NURBS_ERROR_FLAGS, "flags");
    REFUSE(range, empty, NURBS_ERROR_EMPTY_DOMAIN, "range");
    REFUSE(range, outside, NURBS_ERROR_OUTSIDE_DOMAIN, "range|1.5");
    REFUSE(range, no_number, NURBS_ERROR_PARAMETER_NOT_FINITE, "range");
    REFUSE(range, endless, NURBS_ERROR_PARAMETER_NOT_FINITE, "range");
    REFUSE(params, distances, NURBS_ERROR_OVERLAP, "params|distances");
    REFUSE(feet, params, NURBS_ERROR_OVERLAP, "params|feet");
    REFUSE(params, (double *)states, NURBS_ERROR_OVERLAP, "params|status");
    nurbs_destroy(g);
}

static void local_minima(void) {
    static const double points[] = {0.9, 0.9, 0.9, 0.9}, guesses[] = {0.1, 1.9};
    const double bad[] = {0.1, 2.5}, no_number[] = {NAN, 1};
    double same[] = {0.1, 1.9};
    nurbs *g = corner();
    CHECK_OK(nurbs_closest_local(g, 2, points, 0, 0, guesses, 0, 0, params, 0, 0, feet, 0, 0, distances, 0,
                                 states, 0));
    CHECK_NEAR(feet, ((const double[]){0.9, 0, 1, 0.9}), 4, 1e-15);
    CHECK_NEAR(distances, ((const double[]){0.9, 0.1}), 2, 1e-15);
    CHECK_INT(states[0], 0);
    FILL(params);
    CHECK_FAILS(
        nurbs_closest_local(g, 2, points, 0, 0, bad, 0, 0, params, 0, 0, NULL, 0, 0, NULL, 0, NULL, 0),
        NURBS_ERROR_OUTSIDE_DOMAIN, "guesses|2.5");
    CHECK_FAILS(
        nurbs_closest_local(g, 2, points, 0, 0, no_number, 0, 0, params, 0, 0, NULL, 0, 0, NULL, 0, NULL, 0),
        NURBS_ERROR_PARAMETER_NOT_FINITE, "guesses");
    CHECK_FAILS(
        nurbs_closest_local(g, 2, points, 0, 0, NULL, 0, 0, params, 0, 0, NULL, 0, 0, NULL, 0, NULL, 0),
        NURBS_ERROR_NULL, "guesses");
    CHECK_FAILS(nurbs_closest_local(g, 2, points, 0, 0, same, 0, 0, params, 0, 0, NULL, 0, 0, NULL, 0,
                                    (int32_t *)same, 0),
                NURBS_ERROR_OVERLAP, "status|guesses");
    CHECK_UNTOUCHED(params);
    nurbs_destroy(g);
}

static void sides(void) {
    static const double points[] = {0.5, 0.25, 0.5, -0.25, 2, -1, 1, 3, -1, -1};
    static const double expected[] = {0.25, -0.25, -1.4142135623730951, 2, -1.4142135623730951};
    nurbs *g = corner(), *space = make(twist());
    CHECK_OK(nurbs_curve_signed_distances(g, 5, points, 0, 0, 0, 0, distances, 0, params, 0, states, 0));
    CHECK_NEAR(distances, expected, 5, 1e-15);
    CHECK_NEAR(params, ((const double[]){0.5, 0.5, 1, 2, 0}), 5, 1e-15);
    CHECK_FAILS(nurbs_curve_signed_distances(g, 5, points, 0, 0, 0, 0, NULL, 0, NULL, 0, NULL, 0),
                NURBS_ERROR_NULL, "distances");
    CHECK_FAILS(nurbs_curve_signed_distances(space, 1, points, 0, 0, 0, 0, distances, 0, NULL, 0, NULL, 0),
                NURBS_ERROR_DIMENSION, "3");
    CHECK_FAILS(nurbs_curve_signed_distances(g, 1, points, 0, 0, -1, 0, distances, 0, NULL, 0, NULL, 0),
                NURBS_ERROR_TOLERANCE, "tolerance");
    nurbs_destroy(g);
    nurbs_destroy(space);
}

static void lists_of_points(void) {
    static const double point[] = {2, 1}, range[] = {0.75, 1}, empty[] = {1, 1};
    const double no_number[] = {2, NAN};
    nurbs *g = segment();
    int32_t kinds[4], status = -1;
    int64_t count = -1;
    CHECK_OK(nurbs_critical_points(g, point, NULL, 0, 0, 4, params, distances, kinds, &count, &status));
    CHECK_INT(count, 3);
    CHECK_DOUBLES(params, ((const double[]){0, 0.5, 1}), 3);
    CHECK_NEAR(distances, ((const double[]){2.2360679774997898, 1, 2.2360679774997898}), 3, 1e-15);
    CHECK_INT(kinds[0], NURBS_CRITICAL_MAXIMUM);
    CHECK_INT(kinds[1], NURBS_CRITICAL_MINIMUM);
    CHECK_INT(kinds[2], NURBS_CRITICAL_MAXIMUM);
    CHECK_INT(status, NURBS_CLOSEST_CERTIFIED);
    CHECK_OK(nurbs_critical_points(g, point, range, 0, 0, 0, NULL, NULL, NULL, &count, NULL));
    CHECK_INT(count, 2);
    CHECK_OK(nurbs_closest_all(g, point, NULL, 0, 0, 1, params, NULL, &count, &status));
    CHECK_INT(count, 1);
    CHECK_DOUBLE(params[0], 0.5);
    CHECK_INT(status, NURBS_CLOSEST_CERTIFIED);
    CHECK_OK(nurbs_closest_all(g, point, NULL, 0, 0, 0, NULL, NULL, NULL, NULL));

    FILL(params);
    CHECK_FAILS(nurbs_critical_points(g, point, NULL, 0, 0, 2, params, NULL, NULL, NULL, NULL),
                NURBS_ERROR_SIZE, "cap = 2|3");
    CHECK_FAILS(nurbs_critical_points(g, point, NULL, 0, 0, -1, params, NULL, NULL, NULL, NULL),
                NURBS_ERROR_COUNT, "cap|-1");
    CHECK_FAILS(nurbs_critical_points(g, NULL, NULL, 0, 0, 4, params, NULL, NULL, NULL, NULL),
                NURBS_ERROR_NULL, "point");
    CHECK_FAILS(nurbs_critical_points(NULL, point, NULL, 0, 0, 4, params, NULL, NULL, NULL, NULL),
                NURBS_ERROR_NULL, "g");
    CHECK_FAILS(nurbs_critical_points(g, no_number, NULL, 0, 0, 4, params, NULL, NULL, NULL, NULL),
                NURBS_ERROR_POINT_NOT_FINITE, "point|nan");
    CHECK_FAILS(nurbs_critical_points(g, point, empty, 0, 0, 4, params, NULL, NULL, NULL, NULL),
                NURBS_ERROR_EMPTY_DOMAIN, "range");
    CHECK_FAILS(nurbs_critical_points(g, point, NULL, 0, 0, 4, params, params, NULL, NULL, NULL),
                NURBS_ERROR_OVERLAP, "params|distances");
    CHECK_FAILS(nurbs_closest_all(g, point, NULL, -1, 0, 4, params, NULL, NULL, NULL), NURBS_ERROR_TOLERANCE,
                "tolerance");
    CHECK_FAILS(nurbs_closest_all(g, point, NULL, 0, -5, 4, params, NULL, NULL, NULL), NURBS_ERROR_COUNT,
                "budget|-5");
    CHECK_UNTOUCHED(params);
    nurbs_destroy(g);
}

int main(void) {
    known_answers();
    ranges_and_strides();
    ties_and_budgets();
    points_that_are_no_numbers();
    bad_input();
    local_minima();
    sides();
    lists_of_points();
    return check_summary("closest_curve_test");
}
