/* SPDX-License-Identifier: MIT */
/* nurbs_derivative_slots() and nurbs_eval_derivs(). */
#include "batch.h"
#include "check.h"
#include "shapes.h"

static nurbs_status first_order(const nurbs *g, int64_t n, const double *params, int64_t stride,
                                int64_t component_stride, double *out, int64_t out_stride,
                                int64_t out_component_stride, uint32_t flags) {
    return nurbs_eval_derivs(g, 1, n, params, stride, component_stride, out, out_stride, out_component_stride,
                             flags);
}

static void slot_counts(void) {
    int64_t slots = -7;
    static const int64_t expected[3][4] = {{1, 2, 3, 4}, {1, 3, 6, 10}, {1, 4, 10, 20}};
    for (int32_t axes = 1; axes <= 3; ++axes) {
        for (int32_t order = 0; order < 4; ++order) {
            CHECK_OK(nurbs_derivative_slots(axes, order, &slots));
            CHECK_INT(slots, expected[axes - 1][order]);
        }
    }
    CHECK_OK(nurbs_derivative_slots(3, 255, &slots));
    CHECK_INT(slots, INT64_C(258) * 257 * 256 / 6); /* binomial(258, 3) */
    slots = -7;
    CHECK_FAILS(nurbs_derivative_slots(0, 1, &slots), NURBS_ERROR_AXES, "axes|0");
    CHECK_FAILS(nurbs_derivative_slots(4, 1, &slots), NURBS_ERROR_AXES, "axes|4");
    CHECK_FAILS(nurbs_derivative_slots(-1, 1, &slots), NURBS_ERROR_AXES, "axes|-1");
    CHECK_FAILS(nurbs_derivative_slots(1, -1, &slots), NURBS_ERROR_ORDER, "order|-1");
    CHECK_FAILS(nurbs_derivative_slots(1, 256, &slots), NURBS_ERROR_ORDER, "order|256");
    CHECK_FAILS(nurbs_derivative_slots(1, INT32_MAX, &slots), NURBS_ERROR_ORDER, "order");
    CHECK_FAILS(nurbs_derivative_slots(1, 1, NULL), NURBS_ERROR_NULL, "slots");
    CHECK_INT(slots, -7);
}

#define VALUES(...) ((const double[]){__VA_ARGS__})

static void values_at(SplineArgs a, int32_t order, const double *param, uint32_t flags,
                      const double *expected, double bound) {
    double derivs[128];
    int64_t slots = 0;
    nurbs *g = make(a);
    FILL(derivs);
    CHECK_OK(nurbs_derivative_slots(a.axes, order, &slots));
    CHECK_OK(nurbs_eval_derivs(g, order, 1, param, 0, 0, derivs, 0, 0, flags));
    CHECK_NEAR(derivs, expected, slots * a.dim, bound);
    check_untouched(__FILE__, __LINE__, derivs + slots * a.dim,
                    sizeof derivs - (size_t)(slots * a.dim) * sizeof *derivs);
    nurbs_destroy(g);
}

static void curves(void) {
    values_at(arch(), 4, VALUES(0.5), 0, VALUES(2, 1.5, 4.5, 0, 0, -12, -12, 0, 0, 0), 0);
    values_at(arch(), 4, VALUES(0), 0, VALUES(0, 0, 3, 6, 6, -12, -12, 0, 0, 0), 0);
    values_at(arch(), 2, VALUES(1), 0, VALUES(4, 0, 3, -6, -6, -12), 0);
    values_at(arch(), 1, VALUES(2), NURBS_EXTRAPOLATE, VALUES(2, -12, -9, -18), 0);
    values_at(arch(), 1, VALUES(2), NURBS_CLAMP, VALUES(4, 0, 3, -6), 0);
    values_at(hill(), 2, VALUES(3), 0, VALUES(3, 2, -4), 0);
    values_at(hill(), 2, VALUES(3), NURBS_LEFT, VALUES(3, 2, 0), 0);
    values_at(jump(), 2, VALUES(1), 0, VALUES(5, 1, 0), 0);
    values_at(jump(), 2, VALUES(1), NURBS_LEFT, VALUES(1, 1, 0), 0);
    values_at(stairs(), 1, VALUES(1), 0, VALUES(20, 0), 0);
    values_at(stairs(), 1, VALUES(1), NURBS_LEFT, VALUES(10, 0), 0);
    values_at(loop(), 1, VALUES(6), NURBS_WRAP, VALUES(0, 1, -2, 0), 0);
    values_at(arch(), 1, VALUES(7), NURBS_NAN, VALUES(NAN, NAN, NAN, NAN), 0);
}

/* Slots of a surface: S, S_u, S_v, S_uu, S_uv, S_vv. */
static void surfaces(void) {
    values_at(trough(), 2, VALUES(0.5, 1.5), 0,
              VALUES(0.5, 1.5, 1.75, 1, 0, 1, 0, 1, 1, 0, 0, 2, 0, 0, 0, 0, 0, 0), 0);
    values_at(patch(), 2, VALUES(0.25, 0.5), 0,
              VALUES(0.25, 0.5, 0.125, 1, 0, 0.5, 0, 1, 0.25, 0, 0, 0, 0, 0, 1, 0, 0, 0), 0);
}

/* Derivative (a, b, c) of u v w. */
static double monomial(const double *t, const int *order) {
    double value = 1;
    for (int k = 0; k < 3; ++k) {
        value *= order[k] == 0 ? t[k] : order[k] == 1 ? 1 : 0;
    }
    return value;
}

/* Every slot of a volume to order 4, by the formula of the header. */
static void volume_slots(void) {
    static const double t[] = {0.5, 0.25, 0.75};
    double derivs[35 * 4];
    nurbs *g = make(cube());
    CHECK_OK(nurbs_eval_derivs(g, 4, 1, t, 0, 0, derivs, 0, 0, 0));
    for (int a = 0; a <= 4; ++a) {
        for (int b = 0; a + b <= 4; ++b) {
            for (int c = 0; a + b + c <= 4; ++c) {
                const int s = a + b + c, r = b + c, slot = s * (s + 1) * (s + 2) / 6 + r * (r + 1) / 2 + c;
                CHECK_DOUBLE(derivs[4 * slot + 3], monomial(t, (const int[]){a, b, c}));
                CHECK_DOUBLE(derivs[4 * slot], s == 0 ? t[0] : s == 1 && a == 1 ? 1 : 0);
                CHECK_DOUBLE(derivs[4 * slot + 2], s == 0 ? t[2] : s == 1 && c == 1 ? 1 : 0);
            }
        }
    }
    nurbs_destroy(g);
}

/* The quarter circle ((1 - t^2), 2 t) / (1 + t^2) at its start: x = 1 - 2 t^2 + 2 t^4, y = 2 t - 2 t^3 + ...
 */
static void quotient_rule(void) {
    static const int32_t degree = 2;
    static const double points[] = {1, 0, 1, 1, 0, 1}, weights[] = {1, 1, 2}, start = 0;
    static const double expected[] = {1, 0, 0, 2, -4, 0, 0, -12, 48, 0};
    /* E_k of the header's bound with H[w] = 1, 4, 10 and H[wP] <= 1, 4, 10 */
    static const double sizes[] = {1, 8, 84, 1248, 25008};
    double derivs[10];
    nurbs *g = NULL;
    CHECK_OK(nurbs_create_bezier(1, &degree, 2, points, 0, 0, weights, 0, &g));
    CHECK_OK(nurbs_eval_derivs(g, 4, 1, &start, 0, 0, derivs, 0, 0, 0));
    for (int k = 0; k <= 4; ++k) {
        CHECK_NEAR(derivs + 2 * k, expected + 2 * k, 2, 2 * (4 + 2 * k) * 0x1p-52 * sizes[k]);
    }
    nurbs_destroy(g);
}

/* Derivative 0 is the point that nurbs_eval() gives, bit for bit. */
static void points_are_the_same(SplineArgs a) {
    static double params[3 * 50], points[4 * 50], derivs[4 * 20 * 50];
    int64_t slots = 0;
    double domain[2];
    nurbs *g = make(a);
    CHECK_OK(nurbs_derivative_slots(a.axes, 3, &slots));
    for (int32_t k = 0; k < a.axes; ++k) {
        CHECK_OK(nurbs_domain(g, k, domain));
        for (int i = 0; i < 50; ++i) {
            params[a.axes * i + k] = domain[0] + (domain[1] - domain[0]) * ((i * (3 + 4 * k)) % 50) / 49;
        }
    }
    for (int32_t order = 0; order <= 3; ++order) {
        CHECK_OK(nurbs_derivative_slots(a.axes, order, &slots));
        CHECK_OK(nurbs_eval(g, 50, params, 0, 0, points, 0, 0, 0));
        CHECK_OK(nurbs_eval_derivs(g, order, 50, params, 0, 0, derivs, 0, 0, 0));
        for (int i = 0; i < 50; ++i) {
            CHECK_BITS(derivs + slots * a.dim * i, points + a.dim * i, (size_t)a.dim * sizeof *points);
        }
    }
    nurbs_destroy(g);
}

static void bad_orders(void) {
    static const double param = 0.5;
    double derivs[16];
    nurbs *g = make(arch());
    FILL(derivs);
    CHECK_FAILS(nurbs_eval_derivs(g, -1, 1, &param, 0, 0, derivs, 0, 0, 0), NURBS_ERROR_ORDER, "order|-1");
    CHECK_FAILS(nurbs_eval_derivs(g, 256, 1, &param, 0, 0, derivs, 0, 0, 0), NURBS_ERROR_ORDER, "order|256");
    CHECK_FAILS(nurbs_eval_derivs(g, INT32_MIN, 1, &param, 0, 0, derivs, 0, 0, 0), NURBS_ERROR_ORDER,
                "order");
    CHECK_UNTOUCHED(derivs);
    nurbs_destroy(g);
}

/* The highest order that is computed: derivatives above the degree of a polynomial are 0. */
static void highest_order(void) {
    static const double param = 0.5;
    static double derivs[256 * 2];
    nurbs *g = make(arch());
    CHECK_OK(nurbs_eval_derivs(g, 255, 1, &param, 0, 0, derivs, 0, 0, 0));
    for (int i = 8; i < 512; ++i) {
        CHECK_DOUBLE(derivs[i], 0);
    }
    nurbs_destroy(g);
}

int main(void) {
    nurbs *curve = make(arch()), *ring = make(circle()), *surface = make(patch()), *volume = make(cube());
    const SplineArgs shapes[] = {arch(),   circle(), hill(),   loop(), jump(),
                                 stairs(), patch(),  trough(), cube()};
    BatchCase cases[] = {{first_order, curve, 1, 4, "derivs", "deriv", 1, 1, 1, 1},
                         {first_order, ring, 1, 4, "derivs", "deriv", 1, 1, 1, 1},
                         {first_order, surface, 2, 9, "derivs", "deriv", 1, 1, 1, 1},
                         {first_order, volume, 3, 16, "derivs", "deriv", 1, 1, 1, 1}};
    slot_counts();
    curves();
    surfaces();
    volume_slots();
    quotient_rule();
    for (int i = 0; i < 9; ++i) {
        points_are_the_same(shapes[i]);
    }
    bad_orders();
    highest_order();
    for (int i = 0; i < 4; ++i) {
        batch_checks(cases + i);
    }
    nurbs_destroy(curve);
    nurbs_destroy(ring);
    nurbs_destroy(surface);
    nurbs_destroy(volume);
    return check_summary("eval_derivs");
}
