/* SPDX-License-Identifier: MIT */
/* nurbs_rational_basis(). */
#include "batch.h"
#include "check.h"
#include "shapes.h"

/* Without the spans, which the common checks do not know. */
static nurbs_status rational_basis(const nurbs *g, int64_t n, const double *params, int64_t stride,
                                   int64_t component_stride, double *out, int64_t out_stride,
                                   int64_t out_component_stride, uint32_t flags) {
    return nurbs_rational_basis(g, n, params, stride, component_stride, NULL, out, out_stride,
                                out_component_stride, flags);
}

/* Weights 1, 1, 2 at t = 1/2: (1/4, 1/2, 1/2) / (5/4). */
static void quadratic(void) {
    static const int32_t degree = 2;
    static const double points[] = {1, 0, 1, 1, 0, 1}, weights[] = {1, 1, 2}, params[] = {0, 0.5, 1};
    static const double expected[] = {1, 0, 0, 0.2, 0.4, 0.4, 0, 0, 1};
    double values[9];
    int64_t spans[3];
    nurbs *g = NULL;
    CHECK_OK(nurbs_create_bezier(1, &degree, 2, points, 0, 0, weights, 0, &g));
    CHECK_OK(nurbs_rational_basis(g, 3, params, 0, 0, spans, values, 0, 0, 0));
    CHECK_NEAR(values, expected, 9, 4 * 0x1p-52);
    CHECK_DOUBLES(values, expected, 3);
    CHECK_DOUBLES(values + 6, expected + 6, 3);
    for (int i = 0; i < 3; ++i) {
        CHECK_INT(spans[i], 2);
    }
    nurbs_destroy(g);
}

static void polynomial_tensors(void) {
    static const double params[] = {0.25, 0.5, 0.5};
    static const double surface[] = {0.375, 0.375, 0.125, 0.125};
    static const double volume[] = {0.1875, 0.1875, 0.1875, 0.1875, 0.0625, 0.0625, 0.0625, 0.0625};
    double values[8];
    int64_t spans[3];
    nurbs *g = make(patch());
    CHECK_OK(nurbs_rational_basis(g, 1, params, 0, 0, spans, values, 0, 0, 0));
    CHECK_DOUBLES(values, surface, 4);
    CHECK_INT(spans[0], 1);
    CHECK_INT(spans[1], 1);
    nurbs_destroy(g);
    g = make(cube());
    CHECK_OK(nurbs_rational_basis(g, 1, params, 0, 0, spans, values, 0, 0, 0));
    CHECK_DOUBLES(values, volume, 8);
    nurbs_destroy(g);
    g = make(trough());
    CHECK_OK(nurbs_rational_basis(g, 1, (const double[]){0.5, 1}, 0, 0, spans, values, 0, 0, 0));
    CHECK_DOUBLES(values, ((const double[]){0.25, 0, 0.5, 0, 0.25, 0}), 6);
    CHECK_INT(spans[0], 2);
    CHECK_INT(spans[1], 2);
    CHECK_OK(nurbs_rational_basis(g, 1, (const double[]){0.5, 1}, 0, 0, spans, values, 0, 0,
                                  NURBS_ON_AXIS(1, NURBS_LEFT)));
    CHECK_DOUBLES(values, ((const double[]){0, 0.25, 0, 0.5, 0, 0.25}), 6);
    CHECK_INT(spans[1], 1);
    nurbs_destroy(g);
}

/* Sum R_i = 1 and sum R_i P_i = C(t), on the circle. */
static void laws(void) {
    double values[3 * 33], params[33], points[66];
    int64_t spans[33];
    nurbs *g = make(circle());
    for (int i = 0; i < 33; ++i) {
        params[i] = i / 32.0;
    }
    CHECK_OK(nurbs_rational_basis(g, 33, params, 0, 0, spans, values, 0, 0, 0));
    CHECK_OK(nurbs_eval(g, 33, params, 0, 0, points, 0, 0, 0));
    for (int i = 0; i < 33; ++i) {
        double sum[3] = {0, 0, 0};
        for (int j = 0; j < 3; ++j) {
            const double *p = circle().points + 2 * (spans[i] - 2 + j), r = values[3 * i + j];
            CHECK(r >= 0);
            sum[0] += r;
            sum[1] += r * p[0];
            sum[2] += r * p[1];
        }
        CHECK(fabs(sum[0] - 1) <= 8 * 0x1p-52);
        CHECK(fabs(sum[1] - points[2 * i]) <= 16 * 0x1p-52);
        CHECK(fabs(sum[2] - points[2 * i + 1]) <= 16 * 0x1p-52);
    }
    nurbs_destroy(g);
}

/* A zero weight gives an exact 0, on every place where it is active. */
static void zero_weight(void) {
    static const int32_t degree = 2;
    static const double points[] = {1, 5, 2}, weights[] = {1, 0, 1}, params[] = {0.25, 0.5};
    static const double expected[] = {0.9, 0, 0.1, 0.5, 0, 0.5};
    double values[6];
    nurbs *g = NULL;
    CHECK_OK(nurbs_create_bezier(1, &degree, 1, points, 0, 0, weights, 0, &g));
    CHECK_OK(nurbs_rational_basis(g, 2, params, 0, 0, NULL, values, 0, 0, 0));
    CHECK_NEAR(values, expected, 6, 4 * 0x1p-52);
    CHECK_DOUBLE(values[1], 0);
    CHECK_DOUBLE(values[4], 0);
    nurbs_destroy(g);
}

static void outside(void) {
    static const double params[] = {NAN, 2};
    double values[4];
    int64_t spans[2];
    static const int32_t degree = 1;
    static const double points[] = {1, 5};
    nurbs *g = NULL;
    CHECK_OK(nurbs_create_bezier(1, &degree, 1, points, 0, 0, NULL, 0, &g));
    CHECK_OK(nurbs_rational_basis(g, 2, params, 0, 0, spans, values, 0, 0, NURBS_NAN | NURBS_EXTRAPOLATE));
    CHECK_DOUBLES(values, ((const double[]){NAN, NAN, -1, 2}), 4);
    CHECK_INT(spans[0], -1);
    CHECK_INT(spans[1], 1);
    nurbs_destroy(g);
}

static void spans_over_params(void) {
    double shared[8] = {0.25, 0.5}, values[8];
    nurbs *g = make(patch());
    FILL(values);
    CHECK_FAILS(nurbs_rational_basis(g, 1, shared, 0, 0, (int64_t *)(void *)(shared + 1), values, 0, 0, 0),
                NURBS_ERROR_OVERLAP, "spans|params");
    CHECK_DOUBLE(shared[1], 0.5);
    CHECK_UNTOUCHED(values);
    nurbs_destroy(g);
}

int main(void) {
    nurbs *curve = make(arch()), *surface = make(patch()), *volume = make(cube()), *ring = make(circle());
    BatchCase cases[] = {{rational_basis, curve, 1, 4, "values", "value", 1, 1, 1, 1},
                         {rational_basis, ring, 1, 3, "values", "value", 1, 1, 1, 1},
                         {rational_basis, surface, 2, 4, "values", "value", 1, 1, 1, 1},
                         {rational_basis, volume, 3, 8, "values", "value", 1, 1, 1, 1}};
    quadratic();
    polynomial_tensors();
    laws();
    zero_weight();
    outside();
    spans_over_params();
    for (int i = 0; i < 4; ++i) {
        batch_checks(cases + i);
    }
    nurbs_destroy(curve);
    nurbs_destroy(surface);
    nurbs_destroy(volume);
    nurbs_destroy(ring);
    return check_summary("rational_basis");
}
