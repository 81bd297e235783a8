/* SPDX-License-Identifier: MIT */
/* nurbs_bernstein(). */
#include "batch.h"
#include "check.h"

static void quadratic(void) {
    static const double params[] = {0.25, 0, 1, 2, -1};
    static const double expected[] = {0.5625, 0.375, 0.0625, -1.5, 1,  0.5, 2, -4, 2, 0, 0, 0,  /* t = 1/4 */
                                      1,      0,     0,      -2,   2,  0,   2, -4, 2, 0, 0, 0,  /* 0 */
                                      0,      0,     1,      0,    -2, 2,   2, -4, 2, 0, 0, 0,  /* 1 */
                                      1,      -4,    4,      2,    -6, 4,   2, -4, 2, 0, 0, 0,  /* 2 */
                                      4,      -4,    1,      -4,   6,  -2,  2, -4, 2, 0, 0, 0}; /* -1 */
    double values[61];
    FILL(values);
    CHECK_OK(nurbs_bernstein(2, 3, 5, params, 0, values, 0, 0));
    CHECK_DOUBLES(values, expected, 60);
    check_untouched(__FILE__, __LINE__, values + 60, sizeof *values);
}

static void degree_zero(void) {
    static const double params[] = {0, 0.3, 7};
    static const double expected[] = {1, 0, 1, 0, 1, 0};
    double values[6];
    CHECK_OK(nurbs_bernstein(0, 1, 3, params, 0, values, 0, 0));
    CHECK_DOUBLES(values, expected, 6);
}

/* At t = 1/2 the values are binomials over 2^p: exact in double precision to degree 31. */
static void binomials(void) {
    static const double half = 0.5;
    double values[32], binomial = 1;
    CHECK_OK(nurbs_bernstein(31, 0, 1, &half, 0, values, 0, 0));
    for (int j = 0; j <= 31; ++j) {
        double expected = binomial * 0x1p-31;
        /* componentwise accurate: about two roundings a degree */
        CHECK_NEAR(values + j, &expected, 1, 64 * 0x1p-52 * expected);
        binomial = binomial * (31 - j) / (j + 1);
    }
}

/* Componentwise accuracy near the ends, where t^j is tiny: B_(j,3)(t) for t = 2^-30. */
static void tiny_values(void) {
    static const double t = 0x1p-30;
    double values[4];
    const double s = 1 - t, expected[] = {s * s * s, 3 * t * s * s, 3 * t * t * s, t * t * t};
    CHECK_OK(nurbs_bernstein(3, 0, 1, &t, 0, values, 0, 0));
    for (int j = 0; j < 4; ++j) {
        CHECK_NEAR(values + j, expected + j, 1, 16 * 0x1p-52 * expected[j]);
    }
}

/* Partition of unity, and derivatives that add up to 0, at every degree. */
static void sums(void) {
    static const double params[] = {0, 0.125, 0.3, 0.5, 0.9, 1};
    double values[3 * 32 * 6];
    for (int32_t p = 0; p <= 31; ++p) {
        CHECK_OK(nurbs_bernstein(p, 2, 6, params, 0, values, 0, 0));
        for (int i = 0; i < 6; ++i) {
            const double *record = values + i * 3 * (p + 1);
            double sum[3] = {0, 0, 0}, size[3] = {0, 0, 0};
            for (int c = 0; c < 3 * (p + 1); ++c) {
                sum[c / (p + 1)] += record[c];
                size[c / (p + 1)] += fabs(record[c]);
            }
            CHECK(fabs(sum[0] - 1) <= 2 * (p + 1) * 0x1p-52);
            CHECK(fabs(sum[1]) <= 4 * (p + 1) * 0x1p-52 * size[1]);
            CHECK(fabs(sum[2]) <= 6 * (p + 1) * 0x1p-52 * size[2]);
        }
    }
}

static nurbs_status as_batch(const nurbs *g, int64_t n, const double *params, int64_t stride, int64_t unused,
                             double *out, int64_t out_stride, int64_t component_stride, uint32_t flags) {
    (void)g, (void)unused, (void)flags;
    return nurbs_bernstein(2, 1, n, params, stride, out, out_stride, component_stride);
}

static void bad_degrees_and_orders(void) {
    static const double param = 0.5;
    double values[16];
    FILL(values);
    CHECK_FAILS(nurbs_bernstein(-1, 0, 1, &param, 0, values, 0, 0), NURBS_ERROR_DEGREE, "degree|-1");
    CHECK_FAILS(nurbs_bernstein(32, 0, 1, &param, 0, values, 0, 0), NURBS_ERROR_DEGREE, "degree|32");
    CHECK_FAILS(nurbs_bernstein(INT32_MAX, 0, 1, &param, 0, values, 0, 0), NURBS_ERROR_DEGREE, "degree");
    CHECK_FAILS(nurbs_bernstein(2, -1, 1, &param, 0, values, 0, 0), NURBS_ERROR_ORDER, "order|-1");
    CHECK_FAILS(nurbs_bernstein(2, 256, 1, &param, 0, values, 0, 0), NURBS_ERROR_ORDER, "order|256|255");
    CHECK_FAILS(nurbs_bernstein(2, INT32_MAX, 1, &param, 0, values, 0, 0), NURBS_ERROR_ORDER, "order");
    CHECK_UNTOUCHED(values);
}

static void highest_order(void) {
    static const double param = 0.5;
    static double values[256 * 2];
    CHECK_OK(nurbs_bernstein(1, 255, 1, &param, 0, values, 0, 0));
    CHECK_DOUBLES(values, ((const double[]){0.5, 0.5, -1, 1, 0, 0}), 6);
    for (int i = 4; i < 512; ++i) {
        CHECK_DOUBLE(values[i], 0);
    }
}

int main(void) {
    BatchCase c = {as_batch, NULL, 1, 6, "values", "value", 0, 1, 0, 0};
    quadratic();
    degree_zero();
    binomials();
    tiny_values();
    sums();
    bad_degrees_and_orders();
    highest_order();
    batch_checks(&c);
    return check_summary("bernstein");
}
