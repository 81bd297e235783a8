/* SPDX-License-Identifier: MIT */
/* nurbs_constrain(). */
#include "check.h"
#include "shapes.h"

#include <stdint.h>

#define VALUES(...) ((const double[]){__VA_ARGS__})
#define INTS(...) ((const int32_t[]){__VA_ARGS__})

/* The arguments of a call, so that one can be changed at a time. */
typedef struct Call {
    const nurbs *g;
    int64_t count;
    const int32_t *kinds, *orders;
    const double *params, *targets;
    const int32_t *keep;
    const double *costs, *weight_costs;
    double tolerance;
} Call;

static double residuals[8], moved, optimality;
static int64_t rank;

static nurbs_status run(Call c, nurbs **out) {
    return nurbs_constrain(c.g, c.count, c.kinds, c.orders, c.params, c.targets, c.keep, c.costs,
                           c.weight_costs, c.tolerance, residuals, &rank, &moved, &optimality, out);
}

static Call one_value(const nurbs *g, const double *param, const double *target) {
    Call c = {g, 1, NULL, NULL, param, target, NULL, NULL, NULL, 0};
    return c;
}

/* The middle of the arch is (2, 3/2), R = 1/8, 3/8, 3/8, 1/8 and sum R^2 = 5/16. */
static void values(void) {
    nurbs *g = make(arch()), *h = NULL;
    double points[8];
    Call c = one_value(g, VALUES(0.5), VALUES(2, 4));
    CHECK_OK(run(c, &h));
    CHECK_OK(nurbs_points(h, 4, points, 0, 0));
    CHECK_NEAR(points, VALUES(0, 1, 1, 5, 3, 5, 4, 1), 8, 1e-14); /* e = R / (5/16) (0, 5/2) */
    CHECK(rank == 2 && fabs(moved - 3) < 1e-14 && residuals[0] < 1e-14 && optimality < 1e-14);
    nurbs_destroy(h);
    c.targets = VALUES(2, 1e250); /* whose square overflows */
    CHECK_OK(run(c, &h));
    CHECK(fabs(moved - 1.2e250) < 1e237 && optimality < 1e-14);
    nurbs_destroy(h);
    c.targets = VALUES(2, 4);
    c.costs = VALUES(INFINITY, 1, INFINITY, INFINITY); /* one point: e = (T - S) / R */
    CHECK_OK(run(c, &h));
    CHECK_OK(nurbs_points(h, 4, points, 0, 0));
    CHECK_NEAR(points, VALUES(0, 0, 1, 2 + 20.0 / 3, 3, 2, 4, 0), 8, 1e-14);
    CHECK(points[0] == 0 && points[4] == 3 && points[6] == 4);
    nurbs_destroy(h);
    c.costs = NULL;
    c.keep = INTS(0, 0); /* the ends stay: e = R / (9/32) (0, 5/2) */
    CHECK_OK(run(c, &h));
    CHECK_OK(nurbs_points(h, 4, points, 0, 0));
    CHECK_NEAR(points, VALUES(0, 0, 1, 2 + 10.0 / 3, 3, 2 + 10.0 / 3, 4, 0), 8, 1e-14);
    nurbs_destroy(h);
    c.keep = INTS(0, 2); /* only point 0 is left but stays */
    CHECK_NO_HANDLE(h, run(c, &h), NURBS_ERROR_INFLUENCE, "constraint 0|no control point that may move");
    c.keep = NULL;
    c.count = 2; /* a derivative that follows from the first constraint not */
    c.orders = INTS(0, 1);
    c.params = VALUES(0.5, 0.5);
    c.targets = VALUES(2, 4, 5, 0);
    CHECK_OK(run(c, &h));
    double derivs[4];
    CHECK_OK(nurbs_eval_derivs(h, 1, 1, VALUES(0.5), 0, 0, derivs, 0, 0, 0));
    CHECK_NEAR(derivs, VALUES(2, 4, 5, 0), 4, 1e-13);
    CHECK(rank == 4);
    nurbs_destroy(h);
    c.orders = NULL;
    c.targets = VALUES(2, 4, 2, 4); /* twice the same */
    CHECK_OK(run(c, &h));
    CHECK(rank == 2);
    nurbs_destroy(h);
    rank = 77;
    c.targets = VALUES(2, 4, 2, 5);
    CHECK_NO_HANDLE(h, run(c, &h), NURBS_ERROR_CONTRADICTION, "constraint |is missed by 1");
    CHECK(rank == 77);
    c.tolerance = 2;
    CHECK_OK(run(c, &h));
    CHECK(residuals[0] + residuals[1] <= 1 + 1e-13);
    nurbs_destroy(h);
    nurbs_destroy(g);
}

static void directions(void) {
    nurbs *g = make(arch()), *h = NULL;
    double derivs[6];
    Call c = one_value(g, VALUES(0.5), VALUES(-1, -1));
    c.kinds = INTS(NURBS_CONSTRAIN_DIRECTION);
    CHECK_OK(run(c, &h)); /* the derivative was (9/2, 0) */
    CHECK_OK(nurbs_eval_derivs(h, 1, 1, VALUES(0.5), 0, 0, derivs, 0, 0, 0));
    CHECK(fabs(derivs[2] - derivs[3]) < 1e-14 && fabs(derivs[2] - 2.25) < 1e-14);
    CHECK(rank == 1 && residuals[0] < 1e-14 && optimality < 1e-14);
    nurbs_destroy(h);
    c.kinds = INTS(NURBS_CONSTRAIN_NORMAL);
    CHECK_OK(run(c, &h));
    CHECK_OK(nurbs_eval_derivs(h, 1, 1, VALUES(0.5), 0, 0, derivs, 0, 0, 0));
    CHECK(fabs(derivs[2] + derivs[3]) < 1e-14 && rank == 1);
    nurbs_destroy(h);
    c.kinds = INTS(NURBS_CONSTRAIN_CURVATURE);
    c.targets = VALUES(0, -1);
    CHECK_OK(run(c, &h));
    CHECK_OK(nurbs_eval_derivs(h, 2, 1, VALUES(0.5), 0, 0, derivs, 0, 0, 0));
    const double s = derivs[2] * derivs[2] + derivs[3] * derivs[3],
                 along = (derivs[2] * derivs[4] + derivs[3] * derivs[5]) / s;
    CHECK(fabs((derivs[4] - along * derivs[2]) / s) < 1e-13);
    CHECK(fabs((derivs[5] - along * derivs[3]) / s + 1) < 1e-13);
    CHECK(optimality < 1e-6 && residuals[0] < 1e-13);
    nurbs_destroy(h);
    nurbs_destroy(g);
    g = make(patch());
    c = one_value(g, VALUES(0.5, 0.5), VALUES(0, 0, 1));
    c.kinds = INTS(NURBS_CONSTRAIN_NORMAL);
    CHECK_OK(run(c, &h));
    double both[9];
    CHECK_OK(nurbs_eval_derivs(h, 1, 1, VALUES(0.5, 0.5), 0, 0, both, 0, 0, 0));
    CHECK(fabs(both[5]) < 1e-15 && fabs(both[8]) < 1e-15 && rank == 2);
    nurbs_destroy(h);
    c.count = 2; /* and through a point */
    c.kinds = INTS(NURBS_CONSTRAIN_NORMAL, NURBS_CONSTRAIN_VALUE);
    c.params = VALUES(0.5, 0.5, 0.25, 0.75);
    c.targets = VALUES(0, 0, 1, 0, 1, 2);
    CHECK_OK(run(c, &h));
    CHECK_OK(nurbs_eval_derivs(h, 1, 1, VALUES(0.5, 0.5), 0, 0, both, 0, 0, 0));
    CHECK(fabs(both[5]) < 1e-14 && fabs(both[8]) < 1e-14 && rank == 5);
    CHECK_OK(nurbs_eval(h, 1, VALUES(0.25, 0.75), 0, 0, both, 0, 0, 0));
    CHECK_NEAR(both, VALUES(0, 1, 2), 3, 1e-14);
    nurbs_destroy(h);
    nurbs_destroy(g);
}

static void weights(void) {
    nurbs *g = make(circle()), *h = NULL;
    double at[2], w[9];
    Call c = one_value(g, VALUES(0.125), VALUES(0.75, 0.75));
    double infinite[9];
    for (int i = 0; i < 9; ++i) {
        infinite[i] = INFINITY;
    }
    c.costs = infinite;
    c.weight_costs = VALUES(INFINITY, 1, INFINITY, 1, 1, 1, 1, 1, 1); /* only weight 1: it becomes 1 */
    c.tolerance = 1e-12;
    CHECK_OK(run(c, &h));
    CHECK_OK(nurbs_weights(h, 9, w, 0));
    CHECK(fabs(w[1] - 1) < 1e-11 && w[3] == HALF_ROOT && moved == 0);
    nurbs_destroy(h);
    c.costs = NULL;
    c.targets = VALUES(0.7, 0.8);
    CHECK_OK(run(c, &h));
    CHECK_OK(nurbs_eval(h, 1, VALUES(0.125), 0, 0, at, 0, 0, 0));
    CHECK_NEAR(at, VALUES(0.7, 0.8), 2, 1e-12);
    CHECK(optimality < 1e-6 && moved > 0);
    nurbs_destroy(h);
    c.costs = infinite;
    c.targets = VALUES(0.25, 0.25); /* behind the chord */
    CHECK_NO_HANDLE(h, run(c, &h), NURBS_ERROR_WEIGHT_SIGN, "control point 1 would not be positive");
    nurbs_destroy(g);
}

static void refused(void) {
    nurbs *g = make(arch()), *h = NULL;
    const Call good = one_value(g, VALUES(0.5), VALUES(2, 4));
    Call c = good;
    FILL(residuals);
    rank = 77;
    c.g = NULL;
    CHECK_NO_HANDLE(h, run(c, &h), NURBS_ERROR_NULL, "g is NULL");
    c = good;
    c.params = NULL;
    CHECK_NO_HANDLE(h, run(c, &h), NURBS_ERROR_NULL, "params is NULL");
    c = good;
    c.targets = NULL;
    CHECK_NO_HANDLE(h, run(c, &h), NURBS_ERROR_NULL, "targets is NULL");
    CHECK_FAILS(run(good, NULL), NURBS_ERROR_NULL, "out is NULL");
    c = good;
    c.count = 0;
    CHECK_NO_HANDLE(h, run(c, &h), NURBS_ERROR_COUNT, "count = 0");
    c.count = INT64_MAX;
    CHECK_NO_HANDLE(h, run(c, &h), NURBS_ERROR_OVERFLOW, "targets");
    c = good;
    c.kinds = INTS(4);
    CHECK_NO_HANDLE(h, run(c, &h), NURBS_ERROR_CONSTRAINT, "kinds[0] = 4");
    c = good;
    c.orders = INTS(-1);
    CHECK_NO_HANDLE(h, run(c, &h), NURBS_ERROR_ORDER, "orders[0][0] = -1");
    c.orders = INTS(256);
    CHECK_NO_HANDLE(h, run(c, &h), NURBS_ERROR_ORDER, "orders[0][0] = 256");
    c.orders = INTS(1);
    c.kinds = INTS(NURBS_CONSTRAIN_CURVATURE);
    CHECK_NO_HANDLE(h, run(c, &h), NURBS_ERROR_ORDER, "orders[0][0] = 1, expected 0");
    c = good;
    c.orders = INTS(4); /* the derivative vanishes whatever the control points */
    CHECK_NO_HANDLE(h, run(c, &h), NURBS_ERROR_INFLUENCE, "constraint 0");
    c = good;
    c.keep = INTS(-2, 0);
    CHECK_NO_HANDLE(h, run(c, &h), NURBS_ERROR_ORDER, "keep[0][0] = -2");
    c = good;
    c.params = VALUES(2);
    CHECK_NO_HANDLE(h, run(c, &h), NURBS_ERROR_OUTSIDE_DOMAIN, "params[0] = 2");
    c.params = VALUES(NAN);
    CHECK_NO_HANDLE(h, run(c, &h), NURBS_ERROR_PARAMETER_NOT_FINITE, "params[0]");
    c = good;
    c.targets = VALUES(2, INFINITY);
    CHECK_NO_HANDLE(h, run(c, &h), NURBS_ERROR_POINT_NOT_FINITE, "targets[0][1] = inf");
    c.targets = VALUES(0, 0);
    c.kinds = INTS(NURBS_CONSTRAIN_NORMAL);
    CHECK_NO_HANDLE(h, run(c, &h), NURBS_ERROR_DIRECTION, "targets[0] is zero");
    c = good;
    c.costs = VALUES(1, 1, 0, 1);
    CHECK_NO_HANDLE(h, run(c, &h), NURBS_ERROR_FACTOR, "costs[2] = 0");
    c = good;
    c.weight_costs = VALUES(1, NAN, 0, 1);
    CHECK_NO_HANDLE(h, run(c, &h), NURBS_ERROR_FACTOR, "weight_costs[1] = nan");
    c = good;
    c.tolerance = -1;
    CHECK_NO_HANDLE(h, run(c, &h), NURBS_ERROR_TOLERANCE, "tolerance = -1");
    c = good;
    c.params = residuals;
    CHECK_NO_HANDLE(h, run(c, &h), NURBS_ERROR_OVERLAP, "residuals|params");
    c = good;
    c.targets = VALUES(2, 1.7e308);
    CHECK_NO_HANDLE(h, run(c, &h), NURBS_ERROR_NOT_REPRESENTABLE, "");
    CHECK_UNTOUCHED(residuals);
    CHECK(rank == 77);
    nurbs_destroy(g);
    g = make(patch());
    c = one_value(g, VALUES(0.5, 0.5), VALUES(0, 0, 1));
    c.kinds = INTS(NURBS_CONSTRAIN_CURVATURE);
    CHECK_NO_HANDLE(h, run(c, &h), NURBS_ERROR_AXES, "kinds[0] = NURBS_CONSTRAIN_CURVATURE is for curves");
    nurbs_destroy(g);
    g = make(hill());
    c = one_value(g, VALUES(3), VALUES(1));
    c.kinds = INTS(NURBS_CONSTRAIN_DIRECTION);
    CHECK_NO_HANDLE(h, run(c, &h), NURBS_ERROR_DIMENSION, "kinds[0] = 1 asks for dimension 2");
    nurbs_destroy(g);
}

/* The orders of a constraint are limited in sum, and what they take counts as work. */
static void high_orders(void) {
    SplineArgs a = cube();
    a.weights = VALUES(1, 2, 3, 4, 5, 6, 7, 8);
    nurbs *g = make(a), *h = NULL;
    nurbs_constraints wanted;
    nurbs_call_options call;
    Call c = one_value(g, VALUES(0.5, 0.5, 0.5), VALUES(0, 0, 0, 0));
    c.orders = INTS(127, 127, 2);
    CHECK_NO_HANDLE(h, run(c, &h), NURBS_ERROR_ORDER, "orders[0]|256|255");
    memset(&wanted, 0, sizeof wanted);
    wanted.struct_size = sizeof wanted;
    wanted.count = 1;
    wanted.orders = INTS(30, 30, 30);
    wanted.params = c.params;
    wanted.targets = c.targets;
    CHECK_OK(nurbs_call_options_init(&call, sizeof call));
    call.work = 1000000; /* of which this takes 31^6 / 8 */
    CHECK_NO_HANDLE(h, nurbs_constrain_with(g, &wanted, NULL, &call, &h), NURBS_ERROR_WORK, "");
    nurbs_destroy(g);
}

/* An infinite tolerance allows anything, also for equations that some control points do not enter. */
static void infinite_tolerance(void) {
    nurbs *g = make(arch()), *h = NULL;
    Call c = one_value(g, VALUES(0.5, 0.5), VALUES(2, 4, 2, 5));
    c.count = 2;
    c.tolerance = INFINITY;
    CHECK_OK(run(c, &h));
    CHECK(residuals[0] + residuals[1] <= 1 + 1e-13);
    nurbs_destroy(h);
    nurbs_destroy(g);
}

/* A curve that stands still has no curvature. */
static void curvature_of_a_point(void) {
    static const int32_t degree = 3;
    nurbs *g = NULL, *h = NULL;
    CHECK_OK(nurbs_create_bezier(1, &degree, 2, VALUES(1, 3, 1, 3, 1, 3, 1, 3), 0, 0, NULL, 0, &g));
    Call c = one_value(g, VALUES(0.25, 0.5), VALUES(1, 3, 0, 1));
    c.count = 2;
    c.kinds = INTS(NURBS_CONSTRAIN_VALUE, NURBS_CONSTRAIN_CURVATURE);
    CHECK_NO_HANDLE(h, run(c, &h), NURBS_ERROR_NOT_REPRESENTABLE, "constraint 1 is not finite");
    nurbs_destroy(g);
}

static void infinite_points(void) {
    static const int32_t degree = 2;
    static const int64_t count = 3;
    nurbs *g = NULL, *h = NULL;
    CHECK_OK(nurbs_create_homogeneous(1, &degree, &count, VALUES(0, 0, 0, 1, 1, 1), 6, 2,
                                      VALUES(1, 0, 1, 0, 1, 0, -1, 0, 1), 0, 0, 0, &g));
    CHECK_NO_HANDLE(h, run(one_value(g, VALUES(0.5), VALUES(0, 2)), &h), NURBS_ERROR_POINT_NOT_FINITE,
                    "control point 1 is at infinity");
    nurbs_destroy(g);
}

/* Copies on a periodic axis are one control point. */
static void periodic(void) {
    nurbs *g = make(loop()), *h = NULL;
    double at[2];
    CHECK_OK(run(one_value(g, VALUES(5.75), VALUES(3, 3)), &h));
    CHECK_OK(nurbs_eval(h, 1, VALUES(5.75), 0, 0, at, 0, 0, 0));
    CHECK_NEAR(at, VALUES(3, 3), 2, 1e-14);
    nurbs_destroy(h);
    nurbs_destroy(g);
}

int main(void) {
    values();
    directions();
    weights();
    refused();
    high_orders();
    infinite_tolerance();
    curvature_of_a_point();
    infinite_points();
    periodic();
    return check_summary("constrain");
}
