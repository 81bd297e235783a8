/* SPDX-License-Identifier: MIT */
/* nurbs_eval_adjoint(). */
#include "check.h"
#include "shapes.h"

#include <stdint.h>

enum { room = 32 };

static double points[room], weights[room], slopes[room];

static void clear(void) {
    FILL(points);
    FILL(weights);
    FILL(slopes);
}

static nurbs_status adjoint(const nurbs *g, int32_t order, int64_t n, const double *params,
                            const double *cotangents, uint32_t flags) {
    return nurbs_eval_adjoint(g, order, n, params, 0, 0, cotangents, 0, 0, points, 0, 0, weights, 0, slopes,
                              0, 0, flags);
}

/* x of a cubic: the Bernstein polynomials at 1/2, and x' = 3 + 6 t - 6 t^2; dC/dw_i = N_i (P_i - C). */
static void cubic(void) {
    static const double half = 0.5, along_x[] = {1, 0};
    static const double x[] = {0.125, 0, 0.375, 0, 0.375, 0, 0.125, 0};
    static const double by_weight[] = {-0.25, -0.375, 0.375, 0.25};
    nurbs *g = make(arch());
    clear();
    CHECK_OK(adjoint(g, 0, 1, &half, along_x, 0));
    CHECK_DOUBLES(points, x, 8);
    CHECK_DOUBLES(weights, by_weight, 4);
    CHECK_DOUBLE(slopes[0], 4.5);
    check_untouched(__FILE__, __LINE__, points + 8, sizeof points - 8 * sizeof *points);
    check_untouched(__FILE__, __LINE__, weights + 4, sizeof weights - 4 * sizeof *weights);
    check_untouched(__FILE__, __LINE__, slopes + 1, sizeof slopes - sizeof *slopes);
    nurbs_destroy(g);
}

/* The second derivative of y alone: 6 (1 - t), -12 + 18 t, ... at t = 0, and y''' = 0. */
static void second_derivative(void) {
    static const double start = 0, cotangents[] = {0, 0, 0, 0, 0, 1};
    nurbs *g = make(arch());
    CHECK_OK(adjoint(g, 2, 1, &start, cotangents, 0));
    CHECK_DOUBLES(points, ((const double[]){0, 6, 0, -12, 0, 6, 0, 0}), 8);
    CHECK_DOUBLE(slopes[0], 0);
    nurbs_destroy(g);
}

/* Weights 1, 1, 2 at 1/2: R = (1, 2, 2) / 5, C = 0.2 * 1 + 0.4 * 2 + 0.4 * 4 = 2.6, w = 5/4. */
static void rational(void) {
    static const int32_t degree = 2;
    static const double net[] = {1, 2, 4}, w[] = {1, 1, 2}, half = 0.5, one = 1;
    static const double by_point[] = {0.2, 0.4, 0.4}, by_weight[] = {-0.32, -0.24, 0.28};
    nurbs *g = NULL;
    CHECK_OK(nurbs_create_bezier(1, &degree, 1, net, 0, 0, w, 0, &g));
    CHECK_OK(adjoint(g, 0, 1, &half, &one, 0));
    CHECK_NEAR(points, by_point, 3, 4 * 0x1p-52);
    CHECK_NEAR(weights, by_weight, 3, 8 * 0x1p-52);
    nurbs_destroy(g);
}

/* The same spline as homogeneous records, and one with a control point at infinity. */
static void homogeneous(void) {
    static const int32_t degree = 2;
    static const int64_t count = 3;
    static const double knots[] = {0, 0, 0, 1, 1, 1}, net[] = {1, 2, 4}, w[] = {1, 1, 2};
    static const double records[] = {1, 1, 2, 1, 8, 2}, infinite[] = {1, 1, 2, 0, 8, 2};
    static const double half = 0.5, cotangents[] = {1, -0.25};
    double by_point[3], by_weight[3];
    nurbs *g = NULL;
    CHECK_OK(nurbs_create_bezier(1, &degree, 1, net, 0, 0, w, 0, &g));
    CHECK_OK(adjoint(g, 1, 1, &half, cotangents, 0));
    nurbs_destroy(g);
    memcpy(by_point, points, sizeof by_point);
    memcpy(by_weight, weights, sizeof by_weight);
    CHECK_OK(nurbs_create_homogeneous(1, &degree, &count, knots, 6, 1, records, 0, 0, 0, &g));
    CHECK_OK(adjoint(g, 1, 1, &half, cotangents, 0));
    nurbs_destroy(g);
    CHECK_BITS(points, by_point, sizeof by_point);
    CHECK_BITS(weights, by_weight, sizeof by_weight);
    CHECK_OK(nurbs_create_homogeneous(1, &degree, &count, knots, 6, 1, infinite, 0, 0, 0, &g));
    CHECK_OK(adjoint(g, 1, 1, &half, cotangents, 0));
    nurbs_destroy(g);
    CHECK_DOUBLE(points[1], 0);
    CHECK(isfinite(points[0]) && isfinite(points[2]) && isfinite(weights[0]) && isfinite(weights[2]));
    CHECK(!isfinite(weights[1]));
}

/* Finite differences, as a test of signs and factors. */
static double loss(const nurbs *g, const double *net, const double *w, const double *params,
                   const double *cotangents) {
    double derivs[12], sum = 0;
    nurbs *moved = NULL;
    CHECK_OK(nurbs_with_points(g, net, 0, 0, w, 0, &moved));
    CHECK_OK(nurbs_eval_derivs(moved, 1, 3, params, 0, 0, derivs, 0, 0, 0));
    for (int i = 0; i < 12; ++i) {
        sum += derivs[i] * cotangents[i];
    }
    nurbs_destroy(moved);
    return sum;
}

static void slopes_of_the_circle(void) {
    static const double params[] = {0.1, 0.6, 0.85};
    static const double cotangents[] = {1, -0.5, 0.2, 0.1, -1, 0.25, 0.4, 0.3, 0.5, 2, -0.1, 0.6};
    const double h = 0x1p-20;
    double net[18], w[9], at[3], wanted;
    nurbs *g = make(circle());
    CHECK_OK(adjoint(g, 1, 3, params, cotangents, 0));
    for (int i = 0; i < 30; ++i) {
        double both[2];
        for (int side = 0; side < 2; ++side) {
            memcpy(net, circle().points, sizeof net);
            memcpy(w, circle().weights, sizeof w);
            memcpy(at, params, sizeof at);
            *(i < 18 ? net + i : i < 27 ? w + (i - 18) : at + (i - 27)) += side ? h : -h;
            both[side] = loss(g, net, w, at, cotangents);
        }
        wanted = (both[1] - both[0]) / (2 * h);
        CHECK_NEAR(i < 18 ? points + i : i < 27 ? weights + (i - 18) : slopes + (i - 27), &wanted, 1, 1e-6);
    }
    nurbs_destroy(g);
}

/* On a periodic axis the stored points have gradients of their own. */
static void periodic(void) {
    static const double start = 2, along_x[] = {1, 0};
    nurbs *g = make(loop());
    CHECK_OK(adjoint(g, 0, 1, &start, along_x, 0));
    CHECK_DOUBLES(points, ((const double[]){0.5, 0, 0.5, 0, 0, 0, 0, 0, 0, 0, 0, 0}), 12);
    CHECK_OK(nurbs_eval_adjoint(g, 0, 1, &start, 0, 0, along_x, 0, 0, points, 0, 0, NULL, 0, NULL, 0, 0,
                                NURBS_LEFT | NURBS_WRAP));
    CHECK_DOUBLES(points, ((const double[]){0, 0, 0, 0, 0, 0, 0, 0, 0.5, 0, 0.5, 0}), 12);
    nurbs_destroy(g);
}

/* Clamped parameters do not move the point; those without a value give the net nothing. */
static void outside(void) {
    static const double params[] = {2, NAN, 0.5}, cotangents[] = {1, 0, 1, 1, 1, 0};
    nurbs *g = make(arch());
    CHECK_OK(adjoint(g, 0, 3, params, cotangents, NURBS_CLAMP | NURBS_NAN));
    CHECK_DOUBLES(points, ((const double[]){0.125, 0, 0.375, 0, 0.375, 0, 1.125, 0}), 8);
    CHECK_DOUBLES(slopes, ((const double[]){0, NAN, 4.5}), 3);
    CHECK_OK(adjoint(g, 0, 1, params, cotangents, NURBS_EXTRAPOLATE));
    CHECK_DOUBLE(slopes[0], -9);
    nurbs_destroy(g);
}

static void accumulation(void) {
    static const double params[] = {0.25, 0.5}, cotangents[] = {1, 2, 3, 4};
    double whole[8];
    nurbs *g = make(arch());
    CHECK_OK(adjoint(g, 0, 2, params, cotangents, 0));
    memcpy(whole, points, sizeof whole);
    CHECK_OK(adjoint(g, 0, 1, params, cotangents, 0));
    CHECK_OK(adjoint(g, 0, 1, params + 1, cotangents + 2, NURBS_ACCUMULATE));
    CHECK_BITS(points, whole, sizeof whole);
    CHECK_OK(adjoint(g, 0, 0, NULL, NULL, NURBS_ACCUMULATE));
    CHECK_BITS(points, whole, sizeof whole);
    CHECK_OK(adjoint(g, 0, 0, NULL, NULL, 0));
    CHECK_DOUBLES(points, ((const double[]){0, 0, 0, 0, 0, 0, 0, 0}), 8);
    CHECK_OK(nurbs_eval_adjoint(g, 0, 2, params, 0, 0, cotangents, 0, 0, NULL, 0, 0, NULL, 0, NULL, 0, 0, 0));
    nurbs_destroy(g);
}

/* Points and weights interleaved in records of three, parameters and cotangents in columns. */
static void layouts(void) {
    static const double params[] = {0.25, 0.5}, cotangents[] = {1, 2, 3, 4}, columns[] = {1, 3, 0, 2, 4};
    double both[12], net[8], w[4], t[2], apart[3];
    nurbs *g = make(arch());
    CHECK_OK(adjoint(g, 0, 2, params, cotangents, 0));
    memcpy(net, points, sizeof net);
    memcpy(w, weights, sizeof w);
    memcpy(t, slopes, sizeof t);
    CHECK_OK(
        nurbs_eval_adjoint(g, 0, 2, params, 1, 0, columns, 1, 3, both, 3, 0, both + 2, 3, apart, 2, 0, 0));
    for (int i = 0; i < 4; ++i) {
        CHECK_BITS(both + 3 * i, net + 2 * i, 2 * sizeof *net);
        CHECK_DOUBLE(both[3 * i + 2], w[i]);
    }
    CHECK_DOUBLE(apart[2], t[1]);
    nurbs_destroy(g);
}

typedef struct Args {
    const nurbs *g;
    int32_t order;
    int64_t n;
    const double *params;
    int64_t ps, pcs;
    const double *cotangents;
    int64_t cs, ccs;
    double *points;
    int64_t gps, gpcs;
    double *weights;
    int64_t gws;
    double *slopes;
    int64_t gts, gtcs;
    uint32_t flags;
} Args;

static nurbs_status call(const Args *a) {
    return nurbs_eval_adjoint(a->g, a->order, a->n, a->params, a->ps, a->pcs, a->cotangents, a->cs, a->ccs,
                              a->points, a->gps, a->gpcs, a->weights, a->gws, a->slopes, a->gts, a->gtcs,
                              a->flags);
}

static const double good[] = {0.25, 0.5, 0.75, 0.125}, given[] = {1, 2, 3, 4, 5, 6};

#define BAD(field, value, status, words)                                                                     \
    do {                                                                                                     \
        Args a_ = {g, 0, 2, good, 0, 0, given, 0, 0, points, 0, 0, weights, 0, slopes, 0, 0, 0};             \
        a_.field = (value);                                                                                  \
        clear();                                                                                             \
        CHECK_FAILS(call(&a_), status, words);                                                               \
        CHECK_UNTOUCHED(points);                                                                             \
        CHECK_UNTOUCHED(weights);                                                                            \
        CHECK_UNTOUCHED(slopes);                                                                             \
    } while (0)

static void bad_arguments(const nurbs *g) {
    BAD(g, NULL, NURBS_ERROR_NULL, "g");
    BAD(order, -1, NURBS_ERROR_ORDER, "order|-1");
    BAD(order, 256, NURBS_ERROR_ORDER, "order|256");
    BAD(order, 255, NURBS_ERROR_ORDER, "order|255|254|grad_params");
    BAD(n, -1, NURBS_ERROR_COUNT, "n|-1");
    BAD(n, INT64_MAX, NURBS_ERROR_OVERFLOW, "");
    BAD(n, INT64_MAX / 16, NURBS_ERROR_OVERFLOW, "");
    BAD(params, NULL, NURBS_ERROR_NULL, "params");
    BAD(ps, 1, NURBS_ERROR_STRIDE, "params");
    BAD(pcs, -1, NURBS_ERROR_STRIDE, "params|-1");
    BAD(cotangents, NULL, NURBS_ERROR_NULL, "cotangents");
    BAD(cs, 2, NURBS_ERROR_STRIDE, "cotangents");
    BAD(cs, -1, NURBS_ERROR_STRIDE, "cotangents|-1");
    BAD(ccs, INT64_MIN, NURBS_ERROR_STRIDE, "cotangents");
    BAD(gps, 2, NURBS_ERROR_STRIDE, "grad_points");
    BAD(gpcs, -1, NURBS_ERROR_STRIDE, "grad_points|-1");
    BAD(gpcs, INT64_MAX, NURBS_ERROR_OVERFLOW, "grad_points");
    BAD(gws, -1, NURBS_ERROR_STRIDE, "grad_weights|-1");
    BAD(gws, INT64_MAX, NURBS_ERROR_OVERFLOW, "grad_weights");
    BAD(gts, 1, NURBS_ERROR_STRIDE, "grad_params");
    BAD(gtcs, -1, NURBS_ERROR_STRIDE, "grad_params|-1");
    BAD(flags, 0x20u, NURBS_ERROR_FLAGS, "flags");
    BAD(flags, 0x02000000u, NURBS_ERROR_FLAGS, "flags");
    BAD(flags, NURBS_ON_AXIS(2, NURBS_LEFT), NURBS_ERROR_FLAGS, "flags");
    BAD(params, edited(good, 4, 1, NAN), NURBS_ERROR_PARAMETER_NOT_FINITE, "params[0][1]|nan");
    BAD(params, edited(good, 4, 2, -INFINITY), NURBS_ERROR_PARAMETER_NOT_FINITE, "params[1][0]|-inf");
    BAD(params, edited(good, 4, 3, 1.5), NURBS_ERROR_OUTSIDE_DOMAIN, "params[1][1]|1.5");
    BAD(weights, points + 11, NURBS_ERROR_OVERLAP, "grad_points|grad_weights");
    BAD(slopes, points + 11, NURBS_ERROR_OVERLAP, "grad_points|grad_params");
    BAD(slopes, weights + 3, NURBS_ERROR_OVERLAP, "grad_weights|grad_params");
    BAD(points, (double *)(uintptr_t)good, NURBS_ERROR_OVERLAP, "grad_points|params");
    BAD(weights, (double *)(uintptr_t)(given + 2), NURBS_ERROR_OVERLAP, "grad_weights|cotangents");
    BAD(slopes, (double *)(uintptr_t)(given + 2), NURBS_ERROR_OVERLAP, "grad_params|cotangents");
}

/* A cotangent need not be a number, and spoils only what it reaches. */
static void strange_cotangents(void) {
    static const double params[] = {0.5, 1.5}, cotangents[] = {NAN, 1};
    nurbs *g = make(jump());
    CHECK_OK(adjoint(g, 0, 2, params, cotangents, 0));
    CHECK(isnan(points[0]) && isnan(points[1]) && isnan(weights[1]) && isnan(slopes[0]));
    CHECK_DOUBLES(points + 2, ((const double[]){0.5, 0.5}), 2);
    CHECK_DOUBLE(slopes[1], 1);
    nurbs_destroy(g);
}

int main(void) {
    nurbs *g = make(patch());
    cubic();
    second_derivative();
    rational();
    homogeneous();
    slopes_of_the_circle();
    periodic();
    outside();
    accumulation();
    layouts();
    bad_arguments(g);
    strange_cotangents();
    nurbs_destroy(g);
    return check_summary("eval_adjoint");
}
