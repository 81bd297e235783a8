/* SPDX-License-Identifier: MIT */
/* nurbs_eval_grid() and nurbs_eval_grid_derivs(). The points are those of nurbs_eval() and
 * nurbs_eval_derivs(), bit for bit. */
#include "check.h"
#include "shapes.h"

#include <stdint.h>

#define COUNTS(...) ((const int64_t[]){__VA_ARGS__})

enum { orders = 3 }; /* nurbs_eval_grid(), and derivatives of orders 0 to 2 */

/* Grid functions as one: order -1 is nurbs_eval_grid(). */
static nurbs_status grid(const nurbs *g, int32_t order, const int64_t *counts, const double *params,
                         double *out, int64_t stride, int64_t component_stride, uint32_t flags) {
    return order < 0 ? nurbs_eval_grid(g, counts, params, out, stride, component_stride, flags)
                     : nurbs_eval_grid_derivs(g, order, counts, params, out, stride, component_stride, flags);
}

static nurbs_status single(const nurbs *g, int32_t order, const double *param, double *out, uint32_t flags) {
    return order < 0 ? nurbs_eval(g, 1, param, 0, 0, out, 0, 0, flags)
                     : nurbs_eval_derivs(g, order, 1, param, 0, 0, out, 0, 0, flags);
}

/* Unsorted parameters, ends and knots among them, a different number on each axis. */
static void same_bits_as_single(SplineArgs a, int32_t order, uint32_t flags) {
    static const double places[] = {0.7, 0, 1, 0.3, 0.5, 0.25, 0.9};
    static double params[18], values[7 * 6 * 5 * 40];
    const int64_t counts[] = {7, 6, 5};
    double domain[2], one[40], at[3];
    int64_t slots = 1, offset = 0, total = 1;
    nurbs *g = make(a);
    if (order > 0) {
        CHECK_OK(nurbs_derivative_slots(a.axes, order, &slots));
    }
    for (int32_t k = 0; k < a.axes; ++k) {
        CHECK_OK(nurbs_domain(g, k, domain));
        for (int64_t i = 0; i < counts[k]; ++i) {
            params[offset + i] = domain[0] + places[i] * (domain[1] - domain[0]);
        }
        offset += counts[k];
        total *= counts[k];
    }
    CHECK_OK(grid(g, order, counts, params, values, 0, 0, flags));
    for (int64_t i = 0; i < total; ++i) {
        int64_t rest = i, start = offset;
        for (int32_t k = a.axes; k-- > 0; rest /= counts[k]) {
            start -= counts[k];
            at[k] = params[start + rest % counts[k]];
        }
        CHECK_OK(single(g, order, at, one, flags));
        CHECK_BITS(one, values + i * slots * a.dim, (size_t)(slots * a.dim) * sizeof *one);
    }
    nurbs_destroy(g);
}

static void all_shapes(void) {
    const SplineArgs shapes[] = {arch(),   circle(), hill(),   loop(), jump(),
                                 stairs(), patch(),  trough(), cube()};
    for (int i = 0; i < 9; ++i) {
        for (int32_t order = -1; order < orders; ++order) {
            same_bits_as_single(shapes[i], order, 0);
            same_bits_as_single(shapes[i], order, NURBS_ON_ALL_AXES(shapes[i].axes, NURBS_LEFT));
        }
    }
}

static void known_values(void) {
    static const double params[] = {0.5, 1, 0.25, 0, 1}; /* u: 1/2, 1; v: 1/4, 0, 1 */
    static const double expected[] = {0.5, 0.25, 0.125, 0.5, 0, 0, 0.5, 1, 0.5,
                                      1,   0.25, 0.25,  1,   0, 0, 1,   1, 1};
    double points[19];
    nurbs *g = make(patch());
    FILL(points);
    CHECK_OK(nurbs_eval_grid(g, COUNTS(2, 3), params, points, 0, 0, 0));
    CHECK_DOUBLES(points, expected, 18);
    check_untouched(__FILE__, __LINE__, points + 18, sizeof *points);
    nurbs_destroy(g);
}

static void layouts(const nurbs *g, int32_t order, int64_t width) {
    static const double params[] = {0.5, 1, 0.25, 0, 1};
    double packed[6 * 9], apart[6 * 10], transposed[6 * 9], gap;
    memset(&gap, 0x5a, sizeof gap);
    FILL(apart);
    CHECK_OK(grid(g, order, COUNTS(2, 3), params, packed, 0, 0, 0));
    CHECK_OK(grid(g, order, COUNTS(2, 3), params, apart, width + 1, 1, 0));
    CHECK_OK(grid(g, order, COUNTS(2, 3), params, transposed, 1, 6, 0));
    for (int64_t i = 0; i < 6; ++i) {
        CHECK_BITS(apart + (width + 1) * i, packed + width * i, (size_t)width * sizeof gap);
        CHECK_BITS(apart + (width + 1) * i + width, &gap, sizeof gap);
        for (int64_t c = 0; c < width; ++c) {
            CHECK_BITS(transposed + 6 * c + i, packed + width * i + c, sizeof gap);
        }
    }
}

static void flags_of_axes(const nurbs *g, int32_t order) {
    static const double params[] = {2, NAN, -0.25, 0.5};
    double values[4 * 9], point[9];
    const uint32_t flags = NURBS_CLAMP | NURBS_NAN | NURBS_ON_AXIS(1, NURBS_EXTRAPOLATE);
    const int64_t width = order < 1 ? 3 : 9;
    CHECK_OK(grid(g, order, COUNTS(2, 2), params, values, 0, 0, flags));
    CHECK_OK(single(g, order, (const double[]){2, -0.25}, point, flags));
    CHECK_BITS(values, point, (size_t)width * sizeof *point);
    CHECK_DOUBLES(values, ((const double[]){1, -0.25, -0.25}), 3);
    for (int64_t c = 2 * width; c < 4 * width; ++c) {
        CHECK(isnan(values[c]));
    }
}

/* An axis without parameters makes an empty grid, and pointers that name nothing may be NULL. */
static void empty_grids(const nurbs *g, int32_t order) {
    static const double params[] = {0.5, 1};
    double values[8];
    FILL(values);
    CHECK_OK(grid(g, order, COUNTS(0, 0), NULL, NULL, 0, 0, 0));
    CHECK_OK(grid(g, order, COUNTS(0, 2), params, NULL, 0, 0, 0));
    CHECK_OK(grid(g, order, COUNTS(2, 0), params, values, 0, 0, 0));
    CHECK_UNTOUCHED(values);
}

static double out[64];
static const double good[] = {0.5, 1, 0.25, 0, 1};

#define REFUSE(call, status, words)                                                                          \
    do {                                                                                                     \
        FILL(out);                                                                                           \
        CHECK_FAILS(call, status, words);                                                                    \
        CHECK_UNTOUCHED(out);                                                                                \
    } while (0)

static void bad_sizes(const nurbs *g, int32_t order, const char *name, const char *stride) {
    const int64_t big = INT64_C(1) << 31;
    const int64_t *counts = COUNTS(2, 3);
    REFUSE(grid(NULL, order, counts, good, out, 0, 0, 0), NURBS_ERROR_NULL, "g");
    REFUSE(grid(g, order, NULL, good, out, 0, 0, 0), NURBS_ERROR_NULL, "counts");
    REFUSE(grid(g, order, counts, NULL, out, 0, 0, 0), NURBS_ERROR_NULL, "params");
    REFUSE(grid(g, order, counts, good, NULL, 0, 0, 0), NURBS_ERROR_NULL, name);
    REFUSE(grid(g, order, COUNTS(-1, 3), good, out, 0, 0, 0), NURBS_ERROR_COUNT, "counts[0|-1");
    REFUSE(grid(g, order, COUNTS(2, INT64_MIN), good, out, 0, 0, 0), NURBS_ERROR_COUNT, "counts[1|-9223");
    REFUSE(grid(g, order, COUNTS(INT64_MAX, 3), good, out, 0, 0, 0), NURBS_ERROR_OVERFLOW, "");
    REFUSE(grid(g, order, COUNTS(INT64_MAX / 2, 2), good, out, 0, 0, 0), NURBS_ERROR_OVERFLOW, "");
    REFUSE(grid(g, order, COUNTS(big, big), good, out, 0, 0, 0), NURBS_ERROR_OVERFLOW, "");
    REFUSE(grid(g, order, counts, good, out, -1, 0, 0), NURBS_ERROR_STRIDE, stride);
    REFUSE(grid(g, order, counts, good, out, 2, 0, 0), NURBS_ERROR_STRIDE, stride);
    REFUSE(grid(g, order, counts, good, out, 0, -1, 0), NURBS_ERROR_STRIDE, stride);
    REFUSE(grid(g, order, counts, good, out, 1, 5, 0), NURBS_ERROR_STRIDE, stride);
    REFUSE(grid(g, order, counts, good, out, INT64_MAX, 0, 0), NURBS_ERROR_OVERFLOW, "");
    REFUSE(grid(g, order, counts, good, out, 0, INT64_MAX, 0), NURBS_ERROR_OVERFLOW, "");
}

/* The index counts along params. */
static void bad_values(const nurbs *g, int32_t order) {
    const int64_t *counts = COUNTS(2, 3);
    REFUSE(grid(g, order, counts, edited(good, 5, 3, NAN), out, 0, 0, 0), NURBS_ERROR_PARAMETER_NOT_FINITE,
           "params[3|nan");
    REFUSE(grid(g, order, counts, edited(good, 5, 0, INFINITY), out, 0, 0, 0),
           NURBS_ERROR_PARAMETER_NOT_FINITE, "params[0|inf");
    REFUSE(grid(g, order, counts, edited(good, 5, 4, 1.5), out, 0, 0, 0), NURBS_ERROR_OUTSIDE_DOMAIN,
           "params[4|1.5|0|1");
    REFUSE(grid(g, order, counts, edited(good, 5, 1, -0.5), out, 0, 0, 0), NURBS_ERROR_OUTSIDE_DOMAIN,
           "params[1|-0.5|0|1");
    REFUSE(grid(g, order, counts, good, out, 0, 0, 0x20u), NURBS_ERROR_FLAGS, "flags");
    REFUSE(grid(g, order, counts, good, out, 0, 0, 0x01000000u), NURBS_ERROR_FLAGS, "flags");
    REFUSE(grid(g, order, counts, good, out, 0, 0, NURBS_CLAMP | NURBS_WRAP), NURBS_ERROR_FLAGS, "flags");
    REFUSE(grid(g, order, counts, good, out, 0, 0, NURBS_ON_AXIS(2, NURBS_LEFT)), NURBS_ERROR_FLAGS, "flags");
}

static void overlap(const nurbs *g, int32_t order, const char *name) {
    double shared[128], copy[128];
    for (int i = 0; i < 128; ++i) {
        shared[i] = 0.25 + 0x1p-10 * i;
    }
    memcpy(copy, shared, sizeof copy);
    CHECK_FAILS(grid(g, order, COUNTS(2, 3), shared + 60, shared + 60, 0, 0, 0), NURBS_ERROR_OVERLAP, name);
    CHECK_FAILS(grid(g, order, COUNTS(2, 3), shared + 60, shared + 64, 0, 0, 0), NURBS_ERROR_OVERLAP, name);
    CHECK_BITS(shared, copy, sizeof copy);
    CHECK_OK(grid(g, order, COUNTS(2, 3), shared + 60, shared + 65, 0, 0, 0));
    CHECK_BITS(shared + 60, copy + 60, 5 * sizeof *copy);
}

static void bad_orders(const nurbs *g) {
    REFUSE(nurbs_eval_grid_derivs(g, -1, COUNTS(2, 3), good, out, 0, 0, 0), NURBS_ERROR_ORDER, "order|-1");
    REFUSE(nurbs_eval_grid_derivs(g, 256, COUNTS(2, 3), good, out, 0, 0, 0), NURBS_ERROR_ORDER, "order|256");
}

int main(void) {
    nurbs *g = make(patch());
    all_shapes();
    known_values();
    for (int32_t order = -1; order <= 1; ++order) {
        const char *name = order < 0 ? "points" : "derivs", *stride = order < 0 ? "point" : "deriv";
        layouts(g, order, order < 1 ? 3 : 9);
        flags_of_axes(g, order);
        empty_grids(g, order);
        bad_sizes(g, order, name, stride);
        bad_values(g, order);
        overlap(g, order, name);
    }
    bad_orders(g);
    nurbs_destroy(g);
    return check_summary("eval_grid");
}
