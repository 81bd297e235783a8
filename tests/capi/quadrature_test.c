/* SPDX-License-Identifier: MIT */
/* nurbs_quadrature() and nurbs_basis_gradients(). */
#include "batch.h"
#include "check.h"
#include "shapes.h"

#define VALUES(...) ((const double[]){__VA_ARGS__})

enum { most = 48 };

/* The integral of u^2 + v over [0, 1] x [0, 3], and the length of the circle. */
static void integrals(void) {
    double params[2 * most], weights[most], measures[most], points[3 * most], sum = 0, length = 0;
    int64_t count = -1;
    nurbs *g = make(trough());
    CHECK_OK(nurbs_quadrature(g, 0, 0, NULL, NULL, NULL, &count));
    CHECK_INT(count, 3 * 1 * 2 * 3);
    CHECK_OK(nurbs_quadrature(g, 0, most, params, weights, NULL, &count));
    CHECK_INT(count, 18);
    CHECK_OK(nurbs_eval(g, count, params, 0, 0, points, 0, 0, 0));
    for (int i = 0; i < count; ++i) {
        sum += weights[i] * points[3 * i + 2];
        CHECK(params[2 * i + 1] > i / 6 && params[2 * i + 1] < i / 6 + 1);
    }
    CHECK_NEAR(&sum, VALUES(1 + 4.5), 1, 1e-14);
    nurbs_destroy(g);
    g = make(circle());
    CHECK_OK(nurbs_quadrature(g, 12, most, params, NULL, measures, NULL));
    for (int i = 0; i < 48; ++i) {
        length += measures[i];
    }
    CHECK_NEAR(&length, VALUES(6.283185307179586), 1, 1e-12);
    CHECK_OK(nurbs_quadrature(g, 64, 0, params, weights, measures, NULL));
    nurbs_destroy(g);
}

/* A square of side 2: the functions are bilinear, and so are their gradients. */
static void on_a_square(void) {
    static const int32_t degrees[] = {1, 1};
    static const double points[] = {0, 0, 0, 2, 2, 0, 2, 2}, params[] = {0.25, 0.5};
    double gradients[8];
    int64_t spans[2];
    nurbs *g = NULL;
    CHECK_OK(nurbs_create_bezier(2, degrees, 2, points, 0, 0, NULL, 0, &g));
    CHECK_OK(nurbs_basis_gradients(g, 1, params, 0, 0, spans, gradients, 0, 0, 0));
    CHECK_NEAR(gradients, VALUES(-0.25, -0.375, -0.25, 0.375, 0.25, -0.125, 0.25, 0.125), 8, 1e-15);
    CHECK(spans[0] == 1 && spans[1] == 1);
    double apart[16];
    CHECK_OK(nurbs_basis_gradients(g, 1, params, 0, 0, NULL, apart, 16, 2, 0));
    for (int i = 0; i < 8; ++i) {
        CHECK_DOUBLE(apart[2 * i], gradients[i]);
    }
    nurbs_destroy(g);
}

/* Along S(u, v) = (u, v, u v): n . grad = 0, and the gradients of z are those of u v along it. */
static void on_a_surface(void) {
    static const double params[] = {0.25, 0.5};
    double gradients[12];
    nurbs *g = make(patch());
    CHECK_OK(nurbs_basis_gradients(g, 1, params, 0, 0, NULL, gradients, 0, 0, 0));
    for (int j = 0; j < 4; ++j) {
        const double *a = gradients + 3 * j;
        CHECK(fabs(-0.5 * a[0] - 0.25 * a[1] + a[2]) < 1e-15);
    }
    CHECK(fabs(gradients[0] + gradients[3] + gradients[6] + gradients[9]) < 1e-15);
    CHECK(fabs(gradients[9] + 0.5 * gradients[11] - 0.5) < 1e-15); /* . S_u = v, of the function u v */
    nurbs_destroy(g);
}

/* The arc (1 - 2 t, 2 t (1 - t)) over its weight (1 - t)^2 + t^2, whose middle control point is far away with
 * a small weight: its derivative at 1/2 is (-4, 0), and so are the gradients dR_i / dx. */
static void a_far_point_of_small_weight(void) {
    static const int32_t degree = 2;
    static const double points[] = {1, 0, 0, 1e16, -1, 0}, weights[] = {1, 1e-16, 1}, half = 0.5;
    double gradients[6];
    nurbs *g = NULL;
    CHECK_OK(nurbs_create_bezier(1, &degree, 2, points, 0, 0, weights, 0, &g));
    CHECK_OK(nurbs_basis_gradients(g, 1, &half, 0, 0, NULL, gradients, 0, 0, 0));
    CHECK_NEAR(gradients, VALUES(0.5, 0, 0, 0, -0.5, 0), 6, 1e-15);
    nurbs_destroy(g);
}

/* At the pole of a cone, and of a parameter that is none, there are no gradients. */
static void where_there_are_none(void) {
    static const int32_t degrees[] = {1, 1};
    static const double points[] = {0, 0, 0, 0, 0, 1, 1, 1}, params[] = {0, 0.5, NAN, 0.5};
    double gradients[16];
    int64_t spans[4];
    nurbs *g = NULL;
    CHECK_OK(nurbs_create_bezier(2, degrees, 2, points, 0, 0, NULL, 0, &g));
    CHECK_OK(nurbs_basis_gradients(g, 2, params, 0, 0, spans, gradients, 0, 0, NURBS_NAN));
    for (int i = 0; i < 16; ++i) {
        CHECK(isnan(gradients[i]));
    }
    CHECK(spans[0] == 1 && spans[2] == -1 && spans[3] == -1);
    nurbs_destroy(g);
}

static void refused(void) {
    static const double params[] = {0.25, 0.5};
    double shared[8] = {0.25, 0.5}, a[2 * most], b[most], c[most];
    int64_t count = -7;
    nurbs *g = make(patch()), *line = NULL;
    FILL(a);
    FILL(b);
    FILL(c);
    CHECK_FAILS(nurbs_quadrature(NULL, -1, -1, a, b, c, &count), NURBS_ERROR_NULL, "g is NULL");
    CHECK_FAILS(nurbs_quadrature(g, -1, most, a, b, c, &count), NURBS_ERROR_COUNT, "nodes = -1");
    CHECK_FAILS(nurbs_quadrature(g, 65, most, a, b, c, &count), NURBS_ERROR_COUNT, "nodes = 65");
    CHECK_FAILS(nurbs_quadrature(g, 0, -1, a, b, c, &count), NURBS_ERROR_COUNT, "cap = -1");
    CHECK_FAILS(nurbs_quadrature(g, 0, 3, a, b, c, &count), NURBS_ERROR_SIZE, "cap = 3|4");
    CHECK_FAILS(nurbs_quadrature(g, 0, 4, a, a + 7, c, &count), NURBS_ERROR_OVERLAP, "weights|params");
    CHECK_FAILS(nurbs_quadrature(g, 0, 4, a, b, b, &count), NURBS_ERROR_OVERLAP, "measures|weights");
    CHECK_INT(count, -7);
    static const int32_t degrees[] = {1, 1};
    static const double points[] = {0, 1, 2, 4};
    CHECK_OK(nurbs_create_bezier(2, degrees, 1, points, 0, 0, NULL, 0, &line));
    CHECK_FAILS(nurbs_basis_gradients(line, 1, params, 0, 0, NULL, a, 0, 0, 0), NURBS_ERROR_DIMENSION,
                "2 axes|dimension 1");
    CHECK_FAILS(nurbs_basis_gradients(g, 1, shared, 0, 0, (int64_t *)(void *)(shared + 1), a, 0, 0, 0),
                NURBS_ERROR_OVERLAP, "spans|params");
    CHECK_DOUBLE(shared[1], 0.5);
    CHECK_UNTOUCHED(a);
    CHECK_UNTOUCHED(b);
    CHECK_UNTOUCHED(c);
    CHECK_OK(nurbs_quadrature(line, 1, most, NULL, NULL, c, NULL)); /* two axes on a line: no area */
    CHECK_DOUBLE(c[0], 0);
    nurbs_destroy(line);
    nurbs_destroy(g);
}

/* Without the spans, which the common checks do not know. */
static nurbs_status gradients(const nurbs *g, int64_t n, const double *params, int64_t stride,
                              int64_t component_stride, double *out, int64_t out_stride,
                              int64_t out_component_stride, uint32_t flags) {
    return nurbs_basis_gradients(g, n, params, stride, component_stride, NULL, out, out_stride,
                                 out_component_stride, flags);
}

int main(void) {
    nurbs *curve = make(arch()), *ring = make(circle()), *surface = make(patch()), *volume = make(cube());
    BatchCase cases[] = {{gradients, curve, 1, 8, "gradients", "gradient", 1, 1, 1, 1},
                         {gradients, ring, 1, 6, "gradients", "gradient", 1, 1, 1, 1},
                         {gradients, surface, 2, 12, "gradients", "gradient", 1, 1, 1, 1},
                         {gradients, volume, 3, 32, "gradients", "gradient", 1, 1, 1, 1}};
    integrals();
    on_a_square();
    on_a_surface();
    a_far_point_of_small_weight();
    where_there_are_none();
    refused();
    for (int i = 0; i < 4; ++i) {
        batch_checks(cases + i);
    }
    nurbs_destroy(curve);
    nurbs_destroy(ring);
    nurbs_destroy(surface);
    nurbs_destroy(volume);
    return check_summary("quadrature");
}
