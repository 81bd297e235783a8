/* SPDX-License-Identifier: MIT */
/* nurbs_eval_f32() and nurbs_eval_grid_f32(): the doubles of nurbs_eval(), each rounded once. */
#include "check.h"
#include "shapes.h"

#include <stdint.h>

enum { n = 150 }; /* more than two blocks of the evaluation */

static double params[3 * n], points[4 * n];
static float out[4 * n + 1], other[8 * n];

#define COUNTS(...) ((const int64_t[]){__VA_ARGS__})

static void places(const nurbs *g, int32_t axes) {
    double domain[2];
    for (int32_t k = 0; k < axes; ++k) {
        CHECK_OK(nurbs_domain(g, k, domain));
        for (int i = 0; i < n; ++i) {
            params[axes * i + k] = domain[0] + (domain[1] - domain[0]) * ((i * (7 + 2 * k)) % n) / (n - 1.0);
        }
    }
}

static void each_is_rounded_once(SplineArgs a) {
    nurbs *g = make(a);
    places(g, a.axes);
    CHECK_OK(nurbs_eval(g, n, params, 0, 0, points, 0, 0, 0));
    FILL(out);
    CHECK_OK(nurbs_eval_f32(g, n, params, 0, 0, out, 0, 0, 0));
    check_untouched(__FILE__, __LINE__, out + n * a.dim, sizeof *out);
    CHECK_OK(nurbs_eval_f32(g, n, params, 0, 0, other, 1, n, 0));
    for (int i = 0; i < n; ++i) {
        for (int c = 0; c < a.dim; ++c) {
            const float wanted = (float)points[a.dim * i + c];
            CHECK_BITS(out + a.dim * i + c, &wanted, sizeof wanted);
            CHECK_BITS(other + n * c + i, &wanted, sizeof wanted);
        }
    }
    nurbs_destroy(g);
}

static void grids_are_rounded_once(SplineArgs a) {
    static const double fractions[] = {0.1, 1, 0, 0.7, 0.5, 0.3};
    const int64_t counts[] = {3, 2, 6};
    double domain[2];
    int64_t total = 1, used = 0;
    nurbs *g = make(a);
    for (int32_t k = 0; k < a.axes; ++k) {
        CHECK_OK(nurbs_domain(g, k, domain));
        for (int64_t i = 0; i < counts[k]; ++i) {
            params[used++] = domain[0] + fractions[i] * (domain[1] - domain[0]);
        }
        total *= counts[k];
    }
    CHECK_OK(nurbs_eval_grid(g, counts, params, points, 0, 0, 0));
    FILL(other);
    CHECK_OK(nurbs_eval_grid_f32(g, counts, params, other, a.dim + 1, 1, 0));
    for (int64_t i = 0; i < total; ++i) {
        for (int c = 0; c < a.dim; ++c) {
            CHECK(other[(a.dim + 1) * i + c] == (float)points[a.dim * i + c]);
        }
        check_untouched(__FILE__, __LINE__, other + (a.dim + 1) * i + a.dim, sizeof *other);
    }
    nurbs_destroy(g);
}

/* Ties go to even, large numbers to infinity, and places without a value to NaN. */
static void special_values(void) {
    static const int32_t degree = 0;
    static const double knots[] = {0, 1, 2, 3, 4}, at[] = {0.5, 1.5, 2.5, 3.5, NAN};
    static const double values[] = {1 + 0x1p-24, 1 + 0x3p-24, 1e39, -0x1p-149};
    static const float wanted[] = {1, 1 + 0x1p-22f, INFINITY, -0x1p-149f};
    const int64_t count = 4;
    nurbs *g = NULL;
    CHECK_OK(nurbs_create(1, &degree, &count, knots, 5, 1, values, 0, 0, NULL, 0, 0, &g));
    CHECK_OK(nurbs_eval_f32(g, 5, at, 0, 0, out, 0, 0, NURBS_NAN));
    CHECK_BITS(out, wanted, sizeof wanted);
    CHECK(isnan(out[4]));
    CHECK_OK(nurbs_eval_grid_f32(g, COUNTS(5), at, out, 0, 0, NURBS_NAN));
    CHECK_BITS(out, wanted, sizeof wanted);
    CHECK(isnan(out[4]));
    nurbs_destroy(g);
}

static const double good[] = {0.5, 1, 0.25, 0, 1, 0.125};

#define REFUSE(call, status, words)                                                                          \
    do {                                                                                                     \
        FILL(out);                                                                                           \
        CHECK_FAILS(call, status, words);                                                                    \
        CHECK_UNTOUCHED(out);                                                                                \
    } while (0)

static void bad_batches(const nurbs *g) {
    CHECK_OK(nurbs_eval_f32(g, 0, NULL, 0, 0, NULL, 0, 0, 0));
    REFUSE(nurbs_eval_f32(NULL, 3, good, 0, 0, out, 0, 0, 0), NURBS_ERROR_NULL, "g");
    REFUSE(nurbs_eval_f32(g, 3, NULL, 0, 0, out, 0, 0, 0), NURBS_ERROR_NULL, "params");
    REFUSE(nurbs_eval_f32(g, 3, good, 0, 0, NULL, 0, 0, 0), NURBS_ERROR_NULL, "points");
    REFUSE(nurbs_eval_f32(g, -1, good, 0, 0, out, 0, 0, 0), NURBS_ERROR_COUNT, "n|-1");
    REFUSE(nurbs_eval_f32(g, INT64_MAX, good, 0, 0, out, 0, 0, 0), NURBS_ERROR_OVERFLOW, "");
    REFUSE(nurbs_eval_f32(g, 3, good, 1, 0, out, 0, 0, 0), NURBS_ERROR_STRIDE, "params");
    REFUSE(nurbs_eval_f32(g, 3, good, 0, -1, out, 0, 0, 0), NURBS_ERROR_STRIDE, "params");
    REFUSE(nurbs_eval_f32(g, 3, good, 0, 0, out, -1, 0, 0), NURBS_ERROR_STRIDE, "points");
    REFUSE(nurbs_eval_f32(g, 3, good, 0, 0, out, 2, 0, 0), NURBS_ERROR_STRIDE, "points");
    REFUSE(nurbs_eval_f32(g, 3, good, 0, 0, out, 0, INT64_MAX, 0), NURBS_ERROR_OVERFLOW, "points");
    REFUSE(nurbs_eval_f32(g, 3, good, 0, 0, out, 0, 0, 0x20u), NURBS_ERROR_FLAGS, "flags");
    REFUSE(nurbs_eval_f32(g, 3, edited(good, 6, 5, NAN), 0, 0, out, 0, 0, 0),
           NURBS_ERROR_PARAMETER_NOT_FINITE, "params[2][1]|nan");
    REFUSE(nurbs_eval_f32(g, 3, edited(good, 6, 2, 1.5), 0, 0, out, 0, 0, 0), NURBS_ERROR_OUTSIDE_DOMAIN,
           "params[1][0]|1.5");
}

static void bad_grids(const nurbs *g) {
    const int64_t *counts = COUNTS(2, 3);
    CHECK_OK(nurbs_eval_grid_f32(g, COUNTS(0, 2), good, NULL, 0, 0, 0));
    REFUSE(nurbs_eval_grid_f32(NULL, counts, good, out, 0, 0, 0), NURBS_ERROR_NULL, "g");
    REFUSE(nurbs_eval_grid_f32(g, NULL, good, out, 0, 0, 0), NURBS_ERROR_NULL, "counts");
    REFUSE(nurbs_eval_grid_f32(g, counts, NULL, out, 0, 0, 0), NURBS_ERROR_NULL, "params");
    REFUSE(nurbs_eval_grid_f32(g, counts, good, NULL, 0, 0, 0), NURBS_ERROR_NULL, "points");
    REFUSE(nurbs_eval_grid_f32(g, COUNTS(2, -3), good, out, 0, 0, 0), NURBS_ERROR_COUNT, "counts[1]");
    REFUSE(nurbs_eval_grid_f32(g, COUNTS(INT64_MAX, 3), good, out, 0, 0, 0), NURBS_ERROR_OVERFLOW, "");
    REFUSE(nurbs_eval_grid_f32(g, counts, good, out, 2, 0, 0), NURBS_ERROR_STRIDE, "points");
    REFUSE(nurbs_eval_grid_f32(g, counts, good, out, 0, 0, 0x01000000u), NURBS_ERROR_FLAGS, "flags");
    REFUSE(nurbs_eval_grid_f32(g, counts, edited(good, 5, 3, INFINITY), out, 0, 0, 0),
           NURBS_ERROR_PARAMETER_NOT_FINITE, "params[3]|inf");
}

/* Floats are half as wide: the first call touches the parameters by half a double, the second just not. */
static void overlap(const nurbs *g) {
    double shared[32] = {0};
    float *floats = (float *)(void *)shared; /* 9 floats: 36 bytes, 4 and a half doubles */
    CHECK_FAILS(nurbs_eval_f32(g, 3, shared + 4, 0, 0, floats, 0, 0, 0), NURBS_ERROR_OVERLAP,
                "points|params");
    CHECK_OK(nurbs_eval_f32(g, 3, shared + 5, 0, 0, floats, 0, 0, 0));
    CHECK_FAILS(nurbs_eval_grid_f32(g, COUNTS(1, 3), shared + 4, floats, 0, 0, 0), NURBS_ERROR_OVERLAP,
                "points|params");
    CHECK_OK(nurbs_eval_grid_f32(g, COUNTS(1, 3), shared + 5, floats, 0, 0, 0));
    CHECK_DOUBLE(shared[5], 0);
}

int main(void) {
    const SplineArgs shapes[] = {arch(),   circle(), hill(),   loop(), jump(),
                                 stairs(), patch(),  trough(), cube()};
    nurbs *g = make(patch());
    for (size_t i = 0; i < sizeof shapes / sizeof *shapes; ++i) {
        each_is_rounded_once(shapes[i]);
        grids_are_rounded_once(shapes[i]);
    }
    special_values();
    bad_batches(g);
    bad_grids(g);
    overlap(g);
    nurbs_destroy(g);
    return check_summary("eval_f32");
}
