/* SPDX-License-Identifier: MIT */
/* nurbs_create_homogeneous(): signed and zero weights, points at infinity, and every argument bad in turn. */
#include "check.h"

#include "shapes.h"

#include <stdint.h>

static nurbs_status create_homogeneous(const SplineArgs *a, nurbs **out) {
    return nurbs_create_homogeneous(a->axes, a->degrees, a->counts, a->knots, a->knot_count, a->dim,
                                    a->points, a->point_stride, a->component_stride, a->flags, out);
}

/* A half circle: the middle point is at infinity in direction y. C(t) = (1 - 2 t, 2 t (1 - t)) / (1 - 2 t + 2
 * t^2). */
static SplineArgs half_circle(void) {
    static const int32_t degrees[] = {2};
    static const int64_t counts[] = {3};
    static const double knots[] = {0, 0, 0, 1, 1, 1};
    static const double points[] = {1, 0, 1, 0, 1, 0, -1, 0, 1};
    SplineArgs a = {1, degrees, counts, knots, 6, 2, points, 0, 0, NULL, 0, 0};
    return a;
}

#define REFUSE_ARGS(args, status, words)                                                                     \
    do {                                                                                                     \
        nurbs *out_;                                                                                         \
        CHECK_NO_HANDLE(out_, create_homogeneous(&(args), &out_), status, words);                            \
    } while (0)
#define REFUSE(field, value, status, words)                                                                  \
    do {                                                                                                     \
        SplineArgs args_ = half_circle();                                                                    \
        args_.field = (value);                                                                               \
        REFUSE_ARGS(args_, status, words);                                                                   \
    } while (0)
#define INTS(...) ((const int32_t[]){__VA_ARGS__})
#define COUNTS(...) ((const int64_t[]){__VA_ARGS__})

static void stored_records(void) {
    static const double weights[] = {1, 0, 1};
    double records[9], points[6];
    int32_t rational = 0, homogeneous = 0;
    SplineArgs a = half_circle();
    nurbs *g = NULL;
    CHECK_OK(create_homogeneous(&a, &g));
    CHECK_OK(nurbs_is_rational(g, &rational));
    CHECK_INT(rational, 1);
    CHECK_OK(nurbs_is_homogeneous(g, &homogeneous));
    CHECK_INT(homogeneous, 1);
    CHECK_WEIGHTS(g, weights);
    CHECK_OK(nurbs_homogeneous_points(g, 3, records, 0, 0));
    CHECK_BITS(records, a.points, sizeof records);
    CHECK_OK(nurbs_points(g, 3, points, 0, 0));
    CHECK_DOUBLE(points[0], 1);
    CHECK(isnan(points[2]));
    CHECK_DOUBLE(points[3], INFINITY);
    CHECK_DOUBLE(points[4], -1);
    nurbs_destroy(g);
}

/* What is stored stays homogeneous through an operation, and ends where the weights do. */
static void stored_form_is_kept(void) {
    int32_t homogeneous = 0;
    SplineArgs a = half_circle();
    nurbs *g = NULL, *finer = NULL, *plain = NULL;
    CHECK_OK(create_homogeneous(&a, &g));
    CHECK_OK(nurbs_insert_knot(g, 0, 0.5, 1, &finer));
    CHECK_OK(nurbs_is_homogeneous(finer, &homogeneous));
    CHECK_INT(homogeneous, 1);
    CHECK_OK(nurbs_to_homogeneous(g, &plain));
    CHECK_OK(nurbs_is_homogeneous(plain, &homogeneous));
    CHECK_INT(homogeneous, 0);
    nurbs_destroy(plain);
    nurbs_destroy(finer);
    nurbs_destroy(g);
}

static void point_at_infinity_evaluates(void) {
    static const double params[] = {0, 0.25, 0.5, 1}, expected[] = {1, 0, 0.8, 0.6, 0, 1, -1, 0};
    double points[8];
    SplineArgs a = half_circle();
    nurbs *g = NULL;
    CHECK_OK(create_homogeneous(&a, &g));
    CHECK_OK(nurbs_eval(g, 4, params, 0, 0, points, 0, 0, 0));
    /* c eps max|w_i P_i| / w(t) with c = 4, max = 1, w >= 1/2 */
    CHECK_NEAR(points, expected, 8, 8 * 0x1p-52);
    CHECK_DOUBLE(points[0], 1);
    CHECK_DOUBLE(points[6], -1);
    nurbs_destroy(g);
}

/* w(t) = 1 - 2 t vanishes at 1/2: the line through infinity, (t, 1 - 2 t). */
static void pole(void) {
    static const double knots[] = {0, 0, 1, 1}, records[] = {0, 1, 1, -1}, params[] = {0, 0.25, 0.5, 0.75, 1};
    static const double expected[] = {0, 0.5, INFINITY, -1.5, -1};
    double points[5];
    nurbs *g = NULL;
    CHECK_OK(nurbs_create_homogeneous(1, INTS(1), COUNTS(2), knots, 4, 1, records, 0, 0, 0, &g));
    CHECK_OK(nurbs_eval(g, 5, params, 0, 0, points, 0, 0, 0));
    CHECK(isinf(points[2]));
    points[2] = INFINITY;
    CHECK_DOUBLES(points, expected, 5);
    nurbs_destroy(g);
}

static void layouts(void) {
    static const double fortran[] = {1, 0, -1, 0, 1, 0, 1, 0, 1};
    static const double padded[] = {1, 0, 1, 9, 0, 1, 0, 9, -1, 0, 1, 9};
    double records[9];
    SplineArgs a = half_circle();
    nurbs *g = NULL;
    a.points = fortran;
    a.point_stride = 1;
    a.component_stride = 3;
    CHECK_OK(create_homogeneous(&a, &g));
    CHECK_OK(nurbs_homogeneous_points(g, 3, records, 0, 0));
    CHECK_BITS(records, half_circle().points, sizeof records);
    nurbs_destroy(g);
    a.points = padded;
    a.point_stride = 4;
    a.component_stride = 1;
    CHECK_OK(create_homogeneous(&a, &g));
    CHECK_OK(nurbs_homogeneous_points(g, 3, records, 0, 0));
    CHECK_BITS(records, half_circle().points, sizeof records);
    nurbs_destroy(g);
}

static void null_arguments(void) {
    SplineArgs a = half_circle();
    REFUSE(degrees, NULL, NURBS_ERROR_NULL, "degrees");
    REFUSE(counts, NULL, NURBS_ERROR_NULL, "counts");
    REFUSE(knots, NULL, NURBS_ERROR_NULL, "knots");
    REFUSE(points, NULL, NURBS_ERROR_NULL, "points");
    CHECK_FAILS(create_homogeneous(&a, NULL), NURBS_ERROR_NULL, "out");
}

static void bad_sizes(void) {
    REFUSE(axes, 0, NURBS_ERROR_AXES, "axes|0");
    REFUSE(axes, 4, NURBS_ERROR_AXES, "axes|4");
    REFUSE(degrees, INTS(-1), NURBS_ERROR_DEGREE, "degrees[0|-1");
    REFUSE(degrees, INTS(32), NURBS_ERROR_DEGREE, "degrees[0|32");
    REFUSE(counts, COUNTS(0), NURBS_ERROR_COUNT, "counts[0|0");
    REFUSE(counts, COUNTS(-3), NURBS_ERROR_COUNT, "counts[0|-3");
    REFUSE(counts, COUNTS(2), NURBS_ERROR_TOO_FEW_POINTS, "counts[0|2|3");
    REFUSE(counts, COUNTS(INT64_MAX), NURBS_ERROR_OVERFLOW, "");
    REFUSE(knot_count, 5, NURBS_ERROR_SIZE, "knot_count|5|6");
    REFUSE(knot_count, -1, NURBS_ERROR_SIZE, "knot_count|-1");
    REFUSE(dim, 0, NURBS_ERROR_DIMENSION, "dim|0");
    REFUSE(dim, -1, NURBS_ERROR_DIMENSION, "dim|-1");
    REFUSE(point_stride, -1, NURBS_ERROR_STRIDE, "point|-1");
    REFUSE(point_stride, 2, NURBS_ERROR_STRIDE, "point|2");
    REFUSE(component_stride, -1, NURBS_ERROR_STRIDE, "point|-1");
    REFUSE(point_stride, INT64_MAX, NURBS_ERROR_OVERFLOW, "point");
    REFUSE(flags, 0x02u, NURBS_ERROR_FLAGS, "flags");
    REFUSE(flags, NURBS_ON_AXIS(1, NURBS_PERIODIC), NURBS_ERROR_FLAGS, "flags");
}

#define BAD_KNOT(index, value, status, words)                                                                \
    REFUSE(knots, edited(half_circle().knots, 6, index, value), status, words)
#define BAD_POINT(index, value, status, words)                                                               \
    REFUSE(points, edited(half_circle().points, 9, index, value), status, words)

static void bad_values(void) {
    BAD_KNOT(3, NAN, NURBS_ERROR_KNOT_NOT_FINITE, "knots[3|nan");
    BAD_KNOT(2, -0.5, NURBS_ERROR_KNOTS_DECREASING, "knots[2|-0.5");
    BAD_KNOT(3, 0, NURBS_ERROR_EMPTY_DOMAIN, "knots[2|knots[3|0");
    BAD_POINT(3, NAN, NURBS_ERROR_POINT_NOT_FINITE, "points[1|nan");
    BAD_POINT(7, -INFINITY, NURBS_ERROR_POINT_NOT_FINITE, "points[2|-inf");
    BAD_POINT(5, NAN, NURBS_ERROR_WEIGHT_NOT_FINITE, "points[1|nan");
    BAD_POINT(8, INFINITY, NURBS_ERROR_WEIGHT_NOT_FINITE, "points[2|inf");
}

static void all_weights_zero(void) {
    static const double records[] = {1, 0, 0, 0, 1, 0, -1, 0, 0};
    SplineArgs a = half_circle();
    a.points = records;
    REFUSE_ARGS(a, NURBS_ERROR_WEIGHTS_VANISH, "");
}

static void negative_weights_accepted(void) {
    static const double records[] = {1, 0, -1, 0, 1, 0, -1, 0, -2};
    double read[9];
    SplineArgs a = half_circle();
    nurbs *g = NULL;
    a.points = records;
    CHECK_OK(create_homogeneous(&a, &g));
    CHECK_OK(nurbs_homogeneous_points(g, 3, read, 0, 0));
    CHECK_BITS(read, records, sizeof read);
    nurbs_destroy(g);
}

int main(void) {
    stored_records();
    stored_form_is_kept();
    point_at_infinity_evaluates();
    pole();
    layouts();
    null_arguments();
    bad_sizes();
    bad_values();
    all_weights_zero();
    negative_weights_accepted();
    return check_summary("create_homogeneous");
}
