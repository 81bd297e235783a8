/* SPDX-License-Identifier: MIT */
/* nurbs_basis(). */
#include "batch.h"
#include "check.h"
#include "knot_args.h"

static const double clamped[] = {0, 0, 0, 1, 2, 2, 3, 3, 3}; /* degree 2, count 6 */
static const double unit[] = {0, 0, 1, 1};                   /* degree 1, count 2 */

/* N, N' and N'' on both sides of the knot 1, worked out by hand from the recurrence. */
static void both_sides_of_a_knot(void) {
    static const double at = 1;
    static const double right[] = {0.5, 0.5, 0, -1, 1, 0, 1, -3, 2, 0, 0, 0};
    static const double left[] = {0, 0.5, 0.5, 0, -1, 1, 2, -3, 1, 0, 0, 0};
    double values[12];
    int64_t span = -7;
    CHECK_OK(nurbs_basis(2, 6, clamped, 9, 3, 1, &at, 0, &span, values, 0, 0, 0));
    CHECK_INT(span, 3);
    CHECK_DOUBLES(values, right, 12);
    CHECK_OK(nurbs_basis(2, 6, clamped, 9, 3, 1, &at, 0, &span, values, 0, 0, NURBS_LEFT));
    CHECK_INT(span, 2);
    CHECK_DOUBLES(values, left, 12);
    CHECK_OK(nurbs_basis(2, 6, clamped, 9, 3, 1, &at, 0, NULL, values, 0, 0, 0));
    CHECK_DOUBLES(values, right, 12);
}

static void uniform_quadratic(void) {
    static const double knots[] = {0, 1, 2, 3, 4, 5, 6, 7}, params[] = {2, 3.5, 5};
    static const double expected[] = {0.5, 0.5, 0, 0.125, 0.75, 0.125, 0, 0.5, 0.5};
    static const int64_t at[] = {2, 3, 4};
    double values[9];
    int64_t spans[3];
    CHECK_OK(nurbs_basis(2, 5, knots, 8, 0, 3, params, 0, spans, values, 0, 0, 0));
    CHECK_DOUBLES(values, expected, 9);
    CHECK_BITS(spans, at, sizeof at);
}

static void degree_zero(void) {
    static const double knots[] = {0, 1, 2, 3}, params[] = {0, 1, 3};
    static const double expected[] = {1, 0, 1, 0, 1, 0};
    static const int64_t at[] = {0, 1, 2}, left[] = {0, 0, 2};
    double values[6];
    int64_t spans[3];
    CHECK_OK(nurbs_basis(0, 3, knots, 4, 1, 3, params, 0, spans, values, 0, 0, 0));
    CHECK_DOUBLES(values, expected, 6);
    CHECK_BITS(spans, at, sizeof at);
    CHECK_OK(nurbs_basis(0, 3, knots, 4, 1, 3, params, 0, spans, values, 0, 0, NURBS_LEFT));
    CHECK_BITS(spans, left, sizeof left);
}

static void outside(void) {
    static const double params[] = {2, NAN, -1}, out[] = {2.25, -0.5};
    static const double linear[] = {-1, 2, -1, 1, NAN, NAN, NAN, NAN, 2, -1, -1, 1};
    static const double ends[] = {0, 1, 1, 0}, wrapped[] = {0.75, 0.25, 0.5, 0.5};
    double values[12];
    int64_t spans[3];
    CHECK_OK(nurbs_basis(1, 2, unit, 4, 1, 3, params, 0, spans, values, 0, 0, NURBS_EXTRAPOLATE | NURBS_NAN));
    CHECK_DOUBLES(values, linear, 12);
    CHECK_INT(spans[0], 1);
    CHECK_INT(spans[1], -1);
    CHECK_OK(nurbs_basis(1, 2, unit, 4, 0, 2, out, 0, NULL, values, 0, 0, NURBS_CLAMP));
    CHECK_DOUBLES(values, ends, 4);
    CHECK_OK(nurbs_basis(1, 2, unit, 4, 0, 2, out, 0, NULL, values, 0, 0, NURBS_WRAP));
    CHECK_DOUBLES(values, wrapped, 4);
}

/* Partition of unity at every degree, and not one negative value inside the domain. */
static void partition_of_unity(void) {
    double knots[72], params[8], values[32 * 8];
    for (int32_t p = 0; p <= 31; ++p) {
        for (int i = 0; i < 2 * p + 10; ++i) {
            knots[i] = i + 0.125 * (i % 3);
        }
        const int64_t count = p + 9;
        for (int i = 0; i < 8; ++i) {
            params[i] = knots[p] + (knots[count] - knots[p]) * i / 7;
        }
        CHECK_OK(nurbs_basis(p, count, knots, count + p + 1, 0, 8, params, 0, NULL, values, 0, 0, 0));
        for (int i = 0; i < 8; ++i) {
            double sum = 0;
            for (int j = 0; j <= p; ++j) {
                CHECK(values[i * (p + 1) + j] >= 0);
                sum += values[i * (p + 1) + j];
            }
            CHECK(fabs(sum - 1) <= 2 * (p + 1) * 0x1p-52);
        }
    }
}

static nurbs_status as_batch(const nurbs *g, int64_t n, const double *params, int64_t stride, int64_t unused,
                             double *out, int64_t out_stride, int64_t component_stride, uint32_t flags) {
    (void)g, (void)unused;
    return nurbs_basis(1, 2, unit, 4, 1, n, params, stride, NULL, out, out_stride, component_stride, flags);
}

static nurbs_status on_knots(int32_t degree, int64_t count, const double *knots, int64_t knot_count) {
    static const double param = 0.5;
    int64_t spans[1];
    double values[64];
    FILL(spans);
    FILL(values);
    nurbs_status status =
        nurbs_basis(degree, count, knots, knot_count, 0, 1, &param, 0, spans, values, 0, 0, 0);
    CHECK_UNTOUCHED(spans);
    CHECK_UNTOUCHED(values);
    return status;
}

static void bad_orders(void) {
    static const double param = 0.5;
    double values[16];
    FILL(values);
    CHECK_FAILS(nurbs_basis(1, 2, unit, 4, -1, 1, &param, 0, NULL, values, 0, 0, 0), NURBS_ERROR_ORDER,
                "order|-1");
    CHECK_FAILS(nurbs_basis(1, 2, unit, 4, 256, 1, &param, 0, NULL, values, 0, 0, 0), NURBS_ERROR_ORDER,
                "order|256");
    CHECK_UNTOUCHED(values);
}

static void overlaps(void) {
    double knots[9], shared[16];
    static const double param = 1.5;
    memcpy(knots, clamped, sizeof knots);
    CHECK_FAILS(nurbs_basis(2, 6, knots, 9, 0, 1, &param, 0, NULL, knots + 6, 0, 0, 0), NURBS_ERROR_OVERLAP,
                "values|knots");
    CHECK_BITS(knots, clamped, sizeof knots);
    shared[0] = 1.5;
    CHECK_FAILS(
        nurbs_basis(2, 6, clamped, 9, 0, 1, shared, 0, (int64_t *)(void *)shared, shared + 4, 0, 0, 0),
        NURBS_ERROR_OVERLAP, "spans|params");
    CHECK_DOUBLE(shared[0], 1.5);
}

int main(void) {
    BatchCase c = {as_batch, NULL, 1, 4, "values", "value", 0, 1, 1, 1};
    both_sides_of_a_knot();
    uniform_quadratic();
    degree_zero();
    outside();
    partition_of_unity();
    bad_knot_arguments(on_knots);
    huge_counts(on_knots);
    bad_orders();
    overlaps();
    batch_checks(&c);
    return check_summary("basis");
}
