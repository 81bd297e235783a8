/* SPDX-License-Identifier: MIT */
/* nurbs_create(): what is stored, and every argument bad in turn. */
#include "check.h"

#include "shapes.h"

#include <stdint.h>

#define REFUSE_ARGS(args, status, words)                                                                     \
    do {                                                                                                     \
        nurbs *out_;                                                                                         \
        CHECK_NO_HANDLE(out_, create(&(args), &out_), status, words);                                        \
    } while (0)
#define REFUSE(shape, field, value, status, words)                                                           \
    do {                                                                                                     \
        SplineArgs args_ = shape();                                                                          \
        args_.field = (value);                                                                               \
        REFUSE_ARGS(args_, status, words);                                                                   \
    } while (0)
#define INTS(...) ((const int32_t[]){__VA_ARGS__})
#define COUNTS(...) ((const int64_t[]){__VA_ARGS__})

static void stores(SplineArgs a) {
    int64_t offset = 0;
    nurbs *g = NULL;
    CHECK_OK(create(&a, &g));
    CHECK_POINTS(g, a.points);
    if (a.weights != NULL) {
        CHECK_WEIGHTS(g, a.weights);
    }
    for (int32_t k = 0; k < a.axes; ++k) {
        CHECK_KNOTS(g, k, a.knots + offset);
        offset += a.counts[k] + a.degrees[k] + 1;
    }
    nurbs_destroy(g);
}

static void good_inputs(void) {
    stores(arch());
    stores(circle());
    stores(hill());
    stores(loop());
    stores(jump());
    stores(stairs());
    stores(patch());
    stores(trough());
    stores(cube());
}

static void highest_degree(void) {
    double knots[64], points[32];
    nurbs *g = NULL;
    for (int i = 0; i < 64; ++i) {
        knots[i] = i < 32 ? -1.0 : 1.0;
    }
    for (int i = 0; i < 32; ++i) {
        points[i] = 7.0;
    }
    CHECK_OK(nurbs_create(1, INTS(31), COUNTS(32), knots, 64, 1, points, 0, 0, NULL, 0, 0, &g));
    nurbs_destroy(g);
}

/* Layouts: padded records, Fortran's x(n, dim), weights inside the records. */
static void layouts(void) {
    static const double padded[] = {0, 0, 9, 1, 2, 9, 3, 2, 9, 4, 0, 9};
    static const double fortran[] = {0, 1, 3, 4, 0, 2, 2, 0};
    static const double with_weight[] = {0, 0, 1, 1, 2, 2, 3, 2, 3, 4, 0, 4};
    static const double weights[] = {1, 2, 3, 4};
    SplineArgs a = arch();
    nurbs *g = NULL;
    a.points = padded;
    a.point_stride = 3;
    CHECK_OK(create(&a, &g));
    CHECK_POINTS(g, arch().points);
    nurbs_destroy(g);
    a.points = fortran;
    a.point_stride = 1;
    a.component_stride = 4;
    CHECK_OK(create(&a, &g));
    CHECK_POINTS(g, arch().points);
    nurbs_destroy(g);
    a.points = with_weight;
    a.point_stride = 3;
    a.component_stride = 1;
    a.weights = with_weight + 2;
    a.weight_stride = 3;
    CHECK_OK(create(&a, &g));
    CHECK_POINTS(g, arch().points);
    CHECK_WEIGHTS(g, weights);
    nurbs_destroy(g);
}

/* Stored means stored: signed zeros, tiny values, and the point under a weight of 0. */
static void values_survive(void) {
    static const double points[] = {-0.0, 5e-324, 0.1, -1.7976931348623157e308, 3, 2, 4, 1e-300};
    static const double weights[] = {1, 0, 1e-300, 1e300};
    SplineArgs a = arch();
    a.points = points;
    a.weights = weights;
    stores(a);
}

static void null_arguments(void) {
    SplineArgs a = arch();
    REFUSE(arch, degrees, NULL, NURBS_ERROR_NULL, "degrees");
    REFUSE(arch, counts, NULL, NURBS_ERROR_NULL, "counts");
    REFUSE(arch, knots, NULL, NURBS_ERROR_NULL, "knots");
    REFUSE(arch, points, NULL, NURBS_ERROR_NULL, "points");
    CHECK_FAILS(create(&a, NULL), NURBS_ERROR_NULL, "out");
}

static void bad_sizes(void) {
    REFUSE(arch, axes, 0, NURBS_ERROR_AXES, "axes|0");
    REFUSE(arch, axes, -1, NURBS_ERROR_AXES, "axes|-1");
    REFUSE(arch, axes, 4, NURBS_ERROR_AXES, "axes|4");
    REFUSE(arch, axes, INT32_MAX, NURBS_ERROR_AXES, "axes|2147483647");
    REFUSE(arch, axes, INT32_MIN, NURBS_ERROR_AXES, "axes|-2147483648");
    REFUSE(arch, degrees, INTS(-1), NURBS_ERROR_DEGREE, "degrees[0|-1");
    REFUSE(arch, degrees, INTS(32), NURBS_ERROR_DEGREE, "degrees[0|32|31");
    REFUSE(arch, degrees, INTS(INT32_MAX), NURBS_ERROR_DEGREE, "degrees[0|2147483647");
    REFUSE(trough, degrees, INTS(2, -5), NURBS_ERROR_DEGREE, "degrees[1|-5");
    REFUSE(arch, counts, COUNTS(-1), NURBS_ERROR_COUNT, "counts[0|-1");
    REFUSE(arch, counts, COUNTS(INT64_MIN), NURBS_ERROR_COUNT, "counts[0|-9223372036854775808");
    REFUSE(arch, counts, COUNTS(0), NURBS_ERROR_COUNT, "counts[0|0");
    REFUSE(arch, counts, COUNTS(3), NURBS_ERROR_TOO_FEW_POINTS, "counts[0|3|4");
    REFUSE(trough, counts, COUNTS(3, 1), NURBS_ERROR_TOO_FEW_POINTS, "counts[1|1|2");
    REFUSE(arch, counts, COUNTS(INT64_MAX), NURBS_ERROR_OVERFLOW, "");
    REFUSE(arch, counts, COUNTS(INT64_MAX / 2), NURBS_ERROR_OVERFLOW, "");
    REFUSE(arch, counts, COUNTS(5), NURBS_ERROR_SIZE, "knot_count|8|9");
    REFUSE(arch, knot_count, 7, NURBS_ERROR_SIZE, "knot_count|7|8");
    REFUSE(arch, knot_count, 9, NURBS_ERROR_SIZE, "knot_count|9|8");
    REFUSE(arch, knot_count, INT64_MAX, NURBS_ERROR_SIZE, "knot_count");
    REFUSE(arch, knot_count, 0, NURBS_ERROR_SIZE, "knot_count|0|8");
    REFUSE(arch, knot_count, -8, NURBS_ERROR_SIZE, "knot_count|-8");
    REFUSE(arch, dim, 0, NURBS_ERROR_DIMENSION, "dim|0");
    REFUSE(arch, dim, -3, NURBS_ERROR_DIMENSION, "dim|-3");
    REFUSE(arch, dim, INT32_MIN, NURBS_ERROR_DIMENSION, "dim|-2147483648");
}

/* The total of the knots is stated rightly, so that only the product of the counts can be refused. */
static void products_overflow(void) {
    const int64_t big = INT64_C(1) << 31, cube_side = INT64_C(1) << 21;
    SplineArgs a = patch();
    a.counts = COUNTS(big, big);
    a.knot_count = 2 * big + 4;
    REFUSE_ARGS(a, NURBS_ERROR_OVERFLOW, "");
    a = cube();
    a.counts = COUNTS(cube_side, cube_side, cube_side);
    a.knot_count = 3 * cube_side + 6;
    REFUSE_ARGS(a, NURBS_ERROR_OVERFLOW, "");
    a = cube();
    a.counts = COUNTS(INT64_MAX / 2, INT64_MAX / 2, 4);
    REFUSE_ARGS(a, NURBS_ERROR_OVERFLOW, "");
}

static void bad_strides(void) {
    SplineArgs a = arch();
    REFUSE(arch, point_stride, -1, NURBS_ERROR_STRIDE, "point|-1");
    REFUSE(arch, point_stride, INT64_MIN, NURBS_ERROR_STRIDE, "point|-9223372036854775808");
    REFUSE(arch, point_stride, 1, NURBS_ERROR_STRIDE, "point|1");
    REFUSE(arch, component_stride, -1, NURBS_ERROR_STRIDE, "point|-1");
    REFUSE(arch, point_stride, INT64_MAX, NURBS_ERROR_OVERFLOW, "point");
    REFUSE(arch, component_stride, INT64_MAX, NURBS_ERROR_OVERFLOW, "point");
    a.point_stride = 1;
    a.component_stride = 3;
    REFUSE_ARGS(a, NURBS_ERROR_STRIDE, "point");
    a.point_stride = 2;
    a.component_stride = 2;
    REFUSE_ARGS(a, NURBS_ERROR_STRIDE, "point");
    REFUSE(circle, weight_stride, -1, NURBS_ERROR_STRIDE, "weight|-1");
    REFUSE(circle, weight_stride, INT64_MAX, NURBS_ERROR_OVERFLOW, "weight");
}

static void bad_flags(void) {
    REFUSE(arch, flags, 0x02u, NURBS_ERROR_FLAGS, "flags");
    REFUSE(arch, flags, 0x80u, NURBS_ERROR_FLAGS, "flags");
    REFUSE(arch, flags, 0x01000000u, NURBS_ERROR_FLAGS, "flags");
    REFUSE(arch, flags, 0x80000000u, NURBS_ERROR_FLAGS, "flags");
    REFUSE(arch, flags, 0xffffffffu, NURBS_ERROR_FLAGS, "flags");
    REFUSE(loop, flags, NURBS_ON_ALL_AXES(2, NURBS_PERIODIC), NURBS_ERROR_FLAGS, "flags");
    REFUSE(patch, flags, NURBS_ON_AXIS(2, NURBS_PERIODIC), NURBS_ERROR_FLAGS, "flags");
}

#define BAD_KNOT(shape, count, index, value, status, words)                                                  \
    REFUSE(shape, knots, edited(shape().knots, count, index, value), status, words)

static void bad_knots(void) {
    static const double five_at_start[] = {0, 0, 0, 0, 0, 1, 1, 1, 1},
                        five_at_end[] = {0, 0, 0, 0, 1, 1, 1, 1, 1};
    static const double five_inside[] = {0, 0, 0, 0, 1, 1, 1, 1, 1, 2, 2, 2, 2};
    static const double many_points[18] = {0};
    SplineArgs a = arch();
    BAD_KNOT(arch, 8, 5, NAN, NURBS_ERROR_KNOT_NOT_FINITE, "knots[5|nan");
    BAD_KNOT(arch, 8, 7, INFINITY, NURBS_ERROR_KNOT_NOT_FINITE, "knots[7|inf");
    BAD_KNOT(arch, 8, 0, -INFINITY, NURBS_ERROR_KNOT_NOT_FINITE, "knots[0|-inf");
    BAD_KNOT(arch, 8, 3, -0.5, NURBS_ERROR_KNOTS_DECREASING, "knots[3|-0.5");
    BAD_KNOT(trough, 12, 9, 0.25, NURBS_ERROR_KNOTS_DECREASING, "knots[9|0.25");
    BAD_KNOT(trough, 12, 9, NAN, NURBS_ERROR_KNOT_NOT_FINITE, "knots[9|nan");
    a.counts = COUNTS(5);
    a.points = many_points;
    a.knot_count = 9;
    a.knots = five_at_start;
    REFUSE_ARGS(a, NURBS_ERROR_END_MULTIPLICITY, "knots[4|knots[0|0|4");
    a.knots = five_at_end;
    REFUSE_ARGS(a, NURBS_ERROR_END_MULTIPLICITY, "knots[8|knots[4|1|4");
    a.counts = COUNTS(9);
    a.knots = five_inside;
    a.knot_count = 13;
    REFUSE_ARGS(a, NURBS_ERROR_MULTIPLICITY, "knots[8|knots[4|1|4");
}

static void empty_domain(void) {
    static const double inside[] = {0, 1, 1, 2}, constant[] = {3, 3, 3, 3};
    static const double huge[] = {-1.7e308, -1.7e308, 1.7e308, 1.7e308};
    static const double points[] = {1, 2};
    SplineArgs a = {1, INTS(1), COUNTS(2), inside, 4, 1, points, 0, 0, NULL, 0, 0};
    REFUSE_ARGS(a, NURBS_ERROR_EMPTY_DOMAIN, "1");
    a.knots = huge;
    REFUSE_ARGS(a, NURBS_ERROR_KNOT_NOT_FINITE, "knots");
    a.knots = constant;
    nurbs *g = check_poison();
    nurbs_status status = create(&a, &g);
    CHECK(status == NURBS_ERROR_EMPTY_DOMAIN || status == NURBS_ERROR_END_MULTIPLICITY);
    CHECK(g == NULL);
}

static void bad_values(void) {
    REFUSE(arch, points, edited(arch().points, 8, 5, NAN), NURBS_ERROR_POINT_NOT_FINITE, "points[2|nan");
    REFUSE(arch, points, edited(arch().points, 8, 0, INFINITY), NURBS_ERROR_POINT_NOT_FINITE, "points[0|inf");
    REFUSE(cube, points, edited(cube().points, 32, 31, -INFINITY), NURBS_ERROR_POINT_NOT_FINITE,
           "points[7|-inf");
    REFUSE(circle, weights, edited(circle().weights, 9, 4, NAN), NURBS_ERROR_WEIGHT_NOT_FINITE,
           "weights[4|nan");
    REFUSE(circle, weights, edited(circle().weights, 9, 8, INFINITY), NURBS_ERROR_WEIGHT_NOT_FINITE,
           "weights[8|inf");
    REFUSE(circle, weights, edited(circle().weights, 9, 1, -0.5), NURBS_ERROR_WEIGHT_NEGATIVE,
           "weights[1|-0.5");
}

/* w(t) > 0 has to hold at every place of the closed domain, on both sides of a knot. */
static void vanishing_weights(void) {
    static const double knots[] = {0, 0, 1, 2, 2}, points[] = {1, 2, 3, 4};
    static const double hole[] = {1, 0, 1}, first[] = {0, 1, 1}, last[] = {1, 1, 0};
    static const double none[] = {0, 0, 0}, jump_left[] = {1, 0, 1, 1}, jump_right[] = {1, 1, 0, 1};
    SplineArgs a = {1, INTS(1), COUNTS(3), knots, 5, 1, points, 0, 0, hole, 0, 0};
    REFUSE_ARGS(a, NURBS_ERROR_WEIGHTS_VANISH, "weights|(1)");
    a.weights = first;
    REFUSE_ARGS(a, NURBS_ERROR_WEIGHTS_VANISH, "weights|(0)");
    a.weights = last;
    REFUSE_ARGS(a, NURBS_ERROR_WEIGHTS_VANISH, "weights|(2)");
    a.weights = none;
    REFUSE_ARGS(a, NURBS_ERROR_WEIGHTS_VANISH, "weights");
    a = jump();
    a.weights = jump_left;
    REFUSE_ARGS(a, NURBS_ERROR_WEIGHTS_VANISH, "weights|(1)");
    a.weights = jump_right;
    REFUSE_ARGS(a, NURBS_ERROR_WEIGHTS_VANISH, "weights|(1)");
}

/* A zero weight that leaves w(t) > 0 is fine: the middle of a quadratic Bezier curve. */
static void zero_weight_accepted(void) {
    static const double knots[] = {0, 0, 0, 1, 1, 1}, points[] = {0, 0, 5, 7, 2, 0}, weights[] = {1, 0, 1};
    SplineArgs a = {1, INTS(2), COUNTS(3), knots, 6, 2, points, 0, 0, weights, 0, 0};
    stores(a);
}

int main(void) {
    good_inputs();
    highest_degree();
    layouts();
    values_survive();
    null_arguments();
    bad_sizes();
    products_overflow();
    bad_strides();
    bad_flags();
    bad_knots();
    empty_domain();
    bad_values();
    vanishing_weights();
    zero_weight_accepted();
    return check_summary("create");
}
