/* SPDX-License-Identifier: MIT */
/* What all functions over arrays of parameters refuse, checked once for all of them. */
#ifndef NURBS_TESTS_CAPI_BATCH_H
#define NURBS_TESTS_CAPI_BATCH_H

#include "check.h"

#include <stdint.h>

/* The common shape. Functions with fewer arguments get an adapter that drops some. */
typedef nurbs_status (*Batch)(const nurbs *g, int64_t n, const double *params, int64_t param_stride,
                              int64_t param_component_stride, double *out, int64_t stride,
                              int64_t component_stride, uint32_t flags);

typedef struct BatchCase {
    Batch f;
    const nurbs *g; /* domain [0, 1] on every axis; ignored by adapters that need no spline */
    int axes;
    int64_t width;                                   /* doubles in a record of the output */
    const char *output;                              /* how a message calls the output */
    const char *stride;                              /* how a message calls its strides */
    int param_components, components, domain, flags; /* which arguments the function has */
} BatchCase;

enum { batch_length = 512 };

typedef struct BatchArgs {
    int64_t n;
    const double *params;
    int64_t param_stride, param_component_stride;
    double *out;
    int64_t stride, component_stride;
    uint32_t flags;
} BatchArgs;

static double batch_out[batch_length];
static const double batch_params[] = {0.25, 0.5, 0.75, 0.125, 0.375, 0.625};

static inline BatchArgs batch_good(void) {
    BatchArgs a = {2, batch_params, 0, 0, batch_out, 0, 0, 0};
    return a;
}

static inline nurbs_status batch_call(const BatchCase *c, const BatchArgs *a) {
    return c->f(c->g, a->n, a->params, a->param_stride, a->param_component_stride, a->out, a->stride,
                a->component_stride, a->flags);
}

static inline void batch_refuse(int line, const BatchCase *c, BatchArgs a, nurbs_status status,
                                const char *words) {
    FILL(batch_out);
    check_forget();
    nurbs_status actual = batch_call(c, &a);
    int before = check_failures;
    check_refusal(__FILE__, line, actual, status, words);
    check_untouched(__FILE__, line, batch_out, sizeof batch_out);
    if (check_failures != before) {
        fprintf(stderr, "    ... for the output %s\n", c->output);
    }
}

#define BATCH_REFUSE(c, field, value, status, words)                                                         \
    do {                                                                                                     \
        BatchArgs args_ = batch_good();                                                                      \
        args_.field = (value);                                                                               \
        batch_refuse(__LINE__, c, args_, status, words);                                                     \
    } while (0)

static inline void batch_counts(const BatchCase *c) {
    BatchArgs none = {0, NULL, 0, 0, NULL, 0, 0, 0};
    BATCH_REFUSE(c, params, NULL, NURBS_ERROR_NULL, "params");
    CHECK_OK(batch_call(c, &none));
    none.n = -1;
    batch_refuse(__LINE__, c, none, NURBS_ERROR_COUNT, "n|-1");
    BATCH_REFUSE(c, n, INT64_MIN, NURBS_ERROR_COUNT, "n|-9223372036854775808");
    BATCH_REFUSE(c, n, INT64_MAX, NURBS_ERROR_OVERFLOW, "");
    BATCH_REFUSE(c, n, INT64_MAX / 2, NURBS_ERROR_OVERFLOW, "");
    BATCH_REFUSE(c, n, INT64_MAX / 8 + 1, NURBS_ERROR_OVERFLOW, "");
}

static inline void batch_param_strides(const BatchCase *c) {
    BatchArgs a = batch_good();
    BATCH_REFUSE(c, param_stride, -1, NURBS_ERROR_STRIDE, "param|-1");
    BATCH_REFUSE(c, param_stride, INT64_MIN, NURBS_ERROR_STRIDE, "param|-9223372036854775808");
    BATCH_REFUSE(c, param_stride, INT64_MAX, NURBS_ERROR_OVERFLOW, "param");
    if (c->param_components) {
        BATCH_REFUSE(c, param_component_stride, -1, NURBS_ERROR_STRIDE, "param|-1");
        BATCH_REFUSE(c, param_component_stride, INT64_MIN, NURBS_ERROR_STRIDE, "param");
    }
    if (c->axes > 1) {
        BATCH_REFUSE(c, param_stride, c->axes - 1, NURBS_ERROR_STRIDE, "param");
        BATCH_REFUSE(c, param_component_stride, INT64_MAX, NURBS_ERROR_OVERFLOW, "param");
        a.param_stride = 1;
        a.param_component_stride = 1;
        batch_refuse(__LINE__, c, a, NURBS_ERROR_STRIDE, "param");
    }
}

static inline void batch_out_strides(const BatchCase *c) {
    BatchArgs a = batch_good();
    BATCH_REFUSE(c, stride, -1, NURBS_ERROR_STRIDE, c->stride);
    BATCH_REFUSE(c, stride, -1, NURBS_ERROR_STRIDE, "-1");
    BATCH_REFUSE(c, stride, INT64_MIN, NURBS_ERROR_STRIDE, c->stride);
    BATCH_REFUSE(c, stride, INT64_MAX, NURBS_ERROR_OVERFLOW, "");
    if (c->components) {
        BATCH_REFUSE(c, component_stride, -1, NURBS_ERROR_STRIDE, c->stride);
    }
    if (c->components && c->width > 1) {
        BATCH_REFUSE(c, stride, c->width - 1, NURBS_ERROR_STRIDE, c->stride);
        BATCH_REFUSE(c, component_stride, INT64_MAX, NURBS_ERROR_OVERFLOW, "");
        a.stride = 1;
        a.component_stride = 1;
        batch_refuse(__LINE__, c, a, NURBS_ERROR_STRIDE, c->stride);
        a.stride = 2;
        a.component_stride = 2;
        batch_refuse(__LINE__, c, a, NURBS_ERROR_STRIDE, c->stride);
    }
}

/* The last of the six values is bad: params[n - 1]. */
static inline void batch_parameters(const BatchCase *c) {
    const int values = 2 * c->axes;
    BATCH_REFUSE(c, params, edited(batch_params, 6, values - 1, NAN), NURBS_ERROR_PARAMETER_NOT_FINITE,
                 "params[1|nan");
    BATCH_REFUSE(c, params, edited(batch_params, 6, 0, NAN), NURBS_ERROR_PARAMETER_NOT_FINITE,
                 "params[0|nan");
    BATCH_REFUSE(c, params, edited(batch_params, 6, values - 1, INFINITY), NURBS_ERROR_PARAMETER_NOT_FINITE,
                 "params[1|inf");
    BATCH_REFUSE(c, params, edited(batch_params, 6, 0, -INFINITY), NURBS_ERROR_PARAMETER_NOT_FINITE,
                 "params[0|-inf");
    if (c->domain) {
        BATCH_REFUSE(c, params, edited(batch_params, 6, values - 1, 1.5), NURBS_ERROR_OUTSIDE_DOMAIN,
                     "params[1|1.5|0|1");
        BATCH_REFUSE(c, params, edited(batch_params, 6, 0, -0.25), NURBS_ERROR_OUTSIDE_DOMAIN,
                     "params[0|-0.25|0|1");
        BATCH_REFUSE(c, params, edited(batch_params, 6, 0, 1 + 0x1p-52), NURBS_ERROR_OUTSIDE_DOMAIN,
                     "params[0|1.0000000000000002");
    }
}

/* Evaluation flags that no function accepts: unknown bits, exclusive ones together, axes that are not there.
 */
static inline void bad_flags(const BatchCase *c) {
    static const uint32_t bad[] = {0x20u,
                                   0x40u,
                                   0x80u,
                                   0xffu,
                                   0x01000000u,
                                   0x80000000u,
                                   0xffffffffu,
                                   NURBS_CLAMP | NURBS_EXTRAPOLATE,
                                   NURBS_CLAMP | NURBS_WRAP,
                                   NURBS_EXTRAPOLATE | NURBS_WRAP,
                                   NURBS_CLAMP | NURBS_EXTRAPOLATE | NURBS_WRAP,
                                   NURBS_CLAMP | NURBS_WRAP | NURBS_NAN | NURBS_LEFT};
    for (size_t i = 0; i < sizeof bad / sizeof *bad; ++i) {
        BATCH_REFUSE(c, flags, bad[i], NURBS_ERROR_FLAGS, "flags");
    }
    for (int axis = 1; axis < 3; ++axis) {
        uint32_t both = NURBS_CLAMP | NURBS_WRAP;
        BATCH_REFUSE(c, flags, NURBS_ON_AXIS(axis, axis < c->axes ? both : NURBS_LEFT), NURBS_ERROR_FLAGS,
                     "flags");
    }
}

/* The output begins inside the parameters, or ends there. */
static inline void batch_overlap(const BatchCase *c) {
    double shared[batch_length], copy[batch_length];
    for (int i = 0; i < batch_length; ++i) {
        shared[i] = 0.25 + 0x1p-12 * i;
    }
    memcpy(copy, shared, sizeof copy);
    const double *params = shared + 200;
    const int64_t starts[] = {200, 200 + 2 * c->axes - 1, 200 - 2 * c->width + 1};
    for (int i = 0; i < 3; ++i) {
        CHECK_FAILS(c->f(c->g, 2, params, 0, 0, shared + starts[i], 0, 0, 0), NURBS_ERROR_OVERLAP, c->output);
        CHECK_BITS(shared, copy, sizeof copy);
    }
    CHECK_OK(c->f(c->g, 2, params, 0, 0, shared + 200 + 2 * c->axes, 0, 0, 0));
    CHECK_OK(c->f(c->g, 2, params, 0, 0, shared + 200 - 2 * c->width, 0, 0, 0));
    CHECK_BITS(params, copy + 200, (size_t)(2 * c->axes) * sizeof *params);
}

/* Records apart and components apart hold the values of the packed layout; the gaps are left alone. */
static inline void batch_layouts(const BatchCase *c) {
    double packed[batch_length / 4], transposed[6], gap;
    const int64_t n = 2, width = c->width;
    BatchArgs a = batch_good();
    memset(&gap, 0x5a, sizeof gap);
    a.out = packed;
    CHECK_OK(batch_call(c, &a));
    FILL(batch_out);
    CHECK_OK(c->f(c->g, n, batch_params, 0, 0, batch_out, width + 1, 0, 0));
    CHECK_BITS(batch_out, packed, (size_t)width * sizeof *packed);
    CHECK_BITS(batch_out + width + 1, packed + width, (size_t)width * sizeof *packed);
    CHECK_BITS(batch_out + width, &gap, sizeof gap);
    for (int64_t i = 0; i < n; ++i) {
        for (int k = 0; k < c->axes; ++k) {
            transposed[n * k + i] = batch_params[c->axes * i + k];
        }
    }
    FILL(batch_out);
    CHECK_OK(c->f(c->g, n, transposed, 1, n, batch_out, c->components ? 1 : 0, n, 0));
    for (int64_t i = 0; i < n * width; ++i) {
        CHECK_DOUBLE(batch_out[c->components ? n * (i % width) + i / width : i], packed[i]);
    }
}

/* For an output that may be NULL. */
static inline void batch_checks_optional(const BatchCase *c) {
    batch_counts(c);
    batch_param_strides(c);
    batch_out_strides(c);
    batch_parameters(c);
    batch_overlap(c);
    batch_layouts(c);
    if (c->flags) {
        bad_flags(c);
    }
    if (c->g != NULL) {
        BatchCase none = *c;
        none.g = NULL;
        BATCH_REFUSE(&none, flags, 0, NURBS_ERROR_NULL, "g");
    }
}

static inline void batch_checks(const BatchCase *c) {
    BATCH_REFUSE(c, out, NULL, NURBS_ERROR_NULL, c->output);
    batch_checks_optional(c);
}

#endif
