/* SPDX-License-Identifier: MIT */
/* nurbs_eval_knot_derivative() and nurbs_eval_adjoint_knots(). */
#include "check.h"
#include "shapes.h"

#include <stdint.h>

enum { room = 16 };

static double grads[room];

/* A polyline 0, 1, 3 over knots 0, 0, 1, 2, 2: before the knot 1 it is t / tau, after it 1 + 2 (t - tau) / (2 -
 * tau). */
static SplineArgs bent(void) {
    static const int32_t degrees[] = {1};
    static const int64_t counts[] = {3};
    static const double knots[] = {0, 0, 1, 2, 2}, points[] = {0, 1, 3};
    SplineArgs a = {1, degrees, counts, knots, 5, 1, points, 0, 0, NULL, 0, 0};
    return a;
}

static nurbs_status adjoint(const nurbs *g, int32_t axis, int32_t order, int64_t n, const double *params,
                            const double *cotangents, uint32_t flags) {
    return nurbs_eval_adjoint_knots(g, axis, order, n, params, 0, 0, cotangents, 0, 0, grads, flags);
}

static void check_derivative(const nurbs *g, int64_t knot, double param, uint32_t flags, double expected) {
    nurbs *h = NULL;
    double value = 0;
    CHECK_OK(nurbs_eval_knot_derivative(g, 0, knot, &h));
    CHECK_OK(nurbs_eval(h, 1, &param, 0, 0, &value, 0, 0, flags));
    CHECK(fabs(value - expected) <= 1e-15);
    nurbs_destroy(h);
}

static void one_knot(void) {
    static const double params[] = {0.25, 1.5}, ones[] = {1, 2};
    nurbs *g = make(bent());
    check_derivative(g, 2, 0.25, 0, -0.25);
    check_derivative(g, 2, 1.5, 0, -1);
    /* at the knot: from the right and from the left */
    check_derivative(g, 2, 1, 0, -2);
    check_derivative(g, 2, 1, NURBS_LEFT, -1);
    /* the outer knots have no influence, those at the ends of the domain move with it */
    check_derivative(g, 0, 0.25, 0, 0);
    check_derivative(g, 4, 1.5, 0, 0);
    check_derivative(g, 1, 0.25, 0, -0.75);
    check_derivative(g, 3, 1.5, 0, -1);
    CHECK_OK(adjoint(g, 0, 0, 2, params, ones, 0));
    CHECK_DOUBLES(grads, ((const double[]){0, -0.75, -0.25 - 2, -2, 0}), 5);
    CHECK_OK(adjoint(g, 0, 0, 1, params + 1, ones, NURBS_ACCUMULATE));
    CHECK_DOUBLES(grads, ((const double[]){0, -0.75, -0.25 - 3, -3, 0}), 5);
    CHECK_OK(adjoint(g, 0, 0, 0, NULL, NULL, 0));
    CHECK_DOUBLES(grads, ((const double[]){0, 0, 0, 0, 0}), 5);
    nurbs_destroy(g);
}

/* C' = 1 / tau before the knot, 2 / (2 - tau) after it. */
static void derivatives(void) {
    static const double param = 0.25, slope[] = {0, 1};
    nurbs *g = make(bent());
    CHECK_OK(adjoint(g, 0, 1, 1, &param, slope, 0));
    CHECK_DOUBLES(grads, ((const double[]){0, 1, -1, 0, 0}), 5);
    nurbs_destroy(g);
}

/* A parameter that is moved to an end stays there; one that gives NaN adds nothing. */
static void outside(void) {
    static const double beyond = 9, one = 1;
    nurbs *g = make(bent());
    CHECK_OK(adjoint(g, 0, 0, 1, &beyond, &one, NURBS_CLAMP));
    CHECK_DOUBLES(grads, ((const double[]){0, 0, 0, -2, 0}), 5);
    CHECK_OK(adjoint(g, 0, 0, 1, &beyond, &one, NURBS_NAN));
    CHECK_DOUBLES(grads, ((const double[]){0, 0, 0, 0, 0}), 5);
    nurbs_destroy(g);
}

/* A jump: the knot 1 occurs twice at degree 1, and 1 is a limit from either side. */
static void jumps(void) {
    static const double param = 1.5, one = 1;
    nurbs *g = make(jump());
    nurbs *h = NULL;
    int64_t count = 0;
    CHECK_OK(nurbs_eval_knot_derivative(g, 0, 2, &h));
    CHECK_OK(nurbs_count(h, 0, &count));
    CHECK(count == 4);
    nurbs_destroy(h);
    CHECK_OK(adjoint(g, 0, 0, 1, &param, &one, 0));
    CHECK(grads[2] == 0 && grads[0] == 0);
    nurbs_destroy(g);
}

/* At degree 0 only the places of jumps move. */
static void steps(void) {
    static const int32_t degree = 0;
    static const int64_t count = 2;
    static const double knots[] = {0, 1, 2}, points[] = {3, 4}, param = 0.5, one = 1;
    SplineArgs a = {1, &degree, &count, knots, 3, 1, points, 0, 0, NULL, 0, 0};
    nurbs *g = make(a);
    check_derivative(g, 1, 0.5, 0, 0);
    CHECK_OK(adjoint(g, 0, 0, 1, &param, &one, 0));
    CHECK_DOUBLES(grads, ((const double[]){0, 0, 0}), 3);
    nurbs_destroy(g);
}

typedef struct Args {
    const nurbs *g;
    int32_t axis, order;
    int64_t n;
    const double *params;
    int64_t ps, pcs;
    const double *cotangents;
    int64_t cs, ccs;
    double *out;
    uint32_t flags;
} Args;

static const double good[] = {0.25, 0.5, 0.75, 0.125}, given[] = {1, 2, 3, 4, 5, 6};

#define BAD(field, value, status, words)                                                                     \
    do {                                                                                                     \
        Args a_ = {g, 0, 0, 2, good, 0, 0, given, 0, 0, grads, 0};                                           \
        a_.field = (value);                                                                                  \
        FILL(grads);                                                                                         \
        CHECK_FAILS(nurbs_eval_adjoint_knots(a_.g, a_.axis, a_.order, a_.n, a_.params, a_.ps, a_.pcs,        \
                                             a_.cotangents, a_.cs, a_.ccs, a_.out, a_.flags),                \
                    status, words);                                                                          \
        CHECK_UNTOUCHED(grads);                                                                              \
    } while (0)

static void bad_arguments(void) {
    nurbs *g = make(patch());
    nurbs *h = NULL;
    BAD(g, NULL, NURBS_ERROR_NULL, "g");
    BAD(axis, 2, NURBS_ERROR_AXIS, "axis|2");
    BAD(axis, -1, NURBS_ERROR_AXIS, "axis|-1");
    BAD(order, -1, NURBS_ERROR_ORDER, "order|-1");
    BAD(order, 256, NURBS_ERROR_ORDER, "order|256");
    BAD(n, -1, NURBS_ERROR_COUNT, "n|-1");
    BAD(n, INT64_MAX, NURBS_ERROR_OVERFLOW, "");
    BAD(params, NULL, NURBS_ERROR_NULL, "params");
    BAD(ps, 1, NURBS_ERROR_STRIDE, "stride");
    BAD(cotangents, NULL, NURBS_ERROR_NULL, "cotangents");
    BAD(cs, 1, NURBS_ERROR_STRIDE, "stride");
    BAD(out, NULL, NURBS_ERROR_NULL, "grad_knots");
    BAD(out, (double *)(uintptr_t)good, NURBS_ERROR_OVERLAP, "grad_knots|params");
    BAD(out, (double *)(uintptr_t)given, NURBS_ERROR_OVERLAP, "grad_knots|cotangents");
    BAD(flags, 0x80000000u, NURBS_ERROR_FLAGS, "flags");
    BAD(params, edited(good, 4, 1, NAN), NURBS_ERROR_PARAMETER_NOT_FINITE, "params[0][1]|nan");
    BAD(params, edited(good, 4, 3, 1.5), NURBS_ERROR_OUTSIDE_DOMAIN, "params[1][1]|1.5");
    CHECK_FAILS(nurbs_eval_knot_derivative(NULL, 0, 0, &h), NURBS_ERROR_NULL, "g");
    CHECK_FAILS(nurbs_eval_knot_derivative(g, 0, 0, NULL), NURBS_ERROR_NULL, "out");
    CHECK_FAILS(nurbs_eval_knot_derivative(g, 2, 0, &h), NURBS_ERROR_AXIS, "axis|2");
    CHECK_FAILS(nurbs_eval_knot_derivative(g, 0, -1, &h), NURBS_ERROR_INDEX, "knot|-1");
    CHECK_FAILS(nurbs_eval_knot_derivative(g, 0, INT64_MAX, &h), NURBS_ERROR_INDEX, "knot");
    CHECK(h == NULL);
    nurbs_destroy(g);
}

/* Twice the degree has to be possible. */
static void degrees(void) {
    static const int32_t degree = 16;
    static const int64_t count = 17;
    double knots[34], points[17], weights[17];
    nurbs *h = NULL;
    for (int i = 0; i < 17; ++i) {
        knots[i] = 0;
        knots[17 + i] = 1;
        points[i] = i;
        weights[i] = 1 + i % 2;
    }
    SplineArgs a = {1, &degree, &count, knots, 34, 1, points, 0, 0, weights, 0, 0};
    nurbs *g = make(a);
    CHECK_FAILS(nurbs_eval_knot_derivative(g, 0, 3, &h), NURBS_ERROR_DEGREE, "16|32|31");
    nurbs_destroy(g);
}

int main(void) {
    one_knot();
    derivatives();
    outside();
    jumps();
    steps();
    bad_arguments();
    degrees();
    return check_summary("knot_gradients");
}
