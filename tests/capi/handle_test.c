/* SPDX-License-Identifier: MIT */
/* nurbs_with_points(), nurbs_clone() and nurbs_destroy(). */
#include "check.h"

#include "shapes.h"

#include <stdint.h>

typedef struct Args {
    const double *points;
    int64_t point_stride, component_stride;
    const double *weights;
    int64_t weight_stride;
} Args;

static nurbs_status with_points(const nurbs *g, const Args *a, nurbs **out) {
    return nurbs_with_points(g, a->points, a->point_stride, a->component_stride, a->weights, a->weight_stride,
                             out);
}

static const double moved[] = {2, 0, 2, 2, 0, 2, -2, 2, -2, 0, -2, -2, 0, -2, 2, -2, 2, 0};
static const double other_weights[] = {1, 2, 1, 2, 1, 2, 1, 2, 1};

static Args good(void) {
    Args a = {moved, 0, 0, other_weights, 0};
    return a;
}

#define REFUSE(g, field, value, status, words)                                                               \
    do {                                                                                                     \
        Args args_ = good();                                                                                 \
        nurbs *out_;                                                                                         \
        args_.field = (value);                                                                               \
        CHECK_NO_HANDLE(out_, with_points(g, &args_, &out_), status, words);                                 \
    } while (0)

static void new_points(void) {
    nurbs *g = make(circle()), *h = NULL, *k = NULL;
    CHECK_OK(nurbs_with_points(g, moved, 0, 0, NULL, 0, &h));
    CHECK_POINTS(h, moved);
    CHECK_WEIGHTS(h, circle().weights);
    CHECK_KNOTS(h, 0, circle().knots);
    CHECK_POINTS(g, circle().points);
    nurbs_destroy(g);
    CHECK_OK(nurbs_with_points(h, moved, 0, 0, other_weights, 0, &k));
    CHECK_WEIGHTS(k, other_weights);
    nurbs_destroy(h);
    CHECK_POINTS(k, moved);
    nurbs_destroy(k);
}

/* A polynomial spline stays polynomial without weights and becomes rational with them. */
static void polynomial(void) {
    static const double points[] = {0, 0, 1, 1, 2, 1, 3, 0}, weights[] = {1, 1, 1, 1};
    int32_t rational = -1;
    nurbs *g = make(arch()), *h = NULL;
    CHECK_OK(nurbs_with_points(g, points, 0, 0, NULL, 0, &h));
    CHECK_OK(nurbs_is_rational(h, &rational));
    CHECK_INT(rational, 0);
    nurbs_destroy(h);
    CHECK_OK(nurbs_with_points(g, points, 0, 0, weights, 0, &h));
    CHECK_OK(nurbs_is_rational(h, &rational));
    CHECK_INT(rational, 1);
    nurbs_destroy(h);
    nurbs_destroy(g);
}

static void layouts(void) {
    static const double fortran[] = {0, 1, 3, 4, 0, 2, 2, 0};
    static const double padded[] = {0, 0, 5, 1, 2, 5, 3, 2, 5, 4, 0, 5}, fives[] = {5, 5, 5, 5};
    nurbs *g = make(arch()), *h = NULL;
    CHECK_OK(nurbs_with_points(g, fortran, 1, 4, NULL, 0, &h));
    CHECK_POINTS(h, arch().points);
    nurbs_destroy(h);
    CHECK_OK(nurbs_with_points(g, padded, 3, 1, padded + 2, 3, &h));
    CHECK_POINTS(h, arch().points);
    CHECK_WEIGHTS(h, fives);
    nurbs_destroy(h);
    nurbs_destroy(g);
}

static void periodicity_is_kept(void) {
    static const double bigger[] = {3, 3, -3, 3, -3, -3, 3, -3, 3, 3, -3, 3};
    int32_t form = 0;
    nurbs *g = make(loop()), *h = NULL;
    CHECK_OK(nurbs_with_points(g, bigger, 0, 0, NULL, 0, &h));
    CHECK_OK(nurbs_knot_form(h, 0, &form));
    CHECK_INT(form, NURBS_FORM_PERIODIC);
    nurbs_destroy(h);
    CHECK_NO_HANDLE(h, nurbs_with_points(g, edited(bigger, 12, 9, 2.5), 0, 0, NULL, 0, &h),
                    NURBS_ERROR_PERIODIC_POINTS, "points[|2.5");
    CHECK_NO_HANDLE(
        h, nurbs_with_points(g, bigger, 0, 0, edited((const double[]){1, 1, 1, 1, 1, 1}, 6, 5, 2), 0, &h),
        NURBS_ERROR_PERIODIC_POINTS, "weights[|2");
    nurbs_destroy(g);
}

/* Weights of a homogeneous spline that Cartesian points cannot carry are refused when kept. */
static void kept_weights(void) {
    static const int32_t degree = 1;
    static const int64_t count = 2;
    static const double knots[] = {0, 0, 1, 1}, negative[] = {1, 1, 2, -1}, zero[] = {1, 1, 2, 0};
    static const double points[] = {4, 5}, weights[] = {1, 1};
    nurbs *g = NULL, *h = NULL;
    CHECK_OK(nurbs_create_homogeneous(1, &degree, &count, knots, 4, 1, negative, 0, 0, 0, &g));
    CHECK_NO_HANDLE(h, nurbs_with_points(g, points, 0, 0, NULL, 0, &h), NURBS_ERROR_WEIGHT_NEGATIVE, "1");
    CHECK_OK(nurbs_with_points(g, points, 0, 0, weights, 0, &h));
    CHECK_POINTS(h, points);
    nurbs_destroy(h);
    nurbs_destroy(g);
    CHECK_OK(nurbs_create_homogeneous(1, &degree, &count, knots, 4, 1, zero, 0, 0, 0, &g));
    CHECK_NO_HANDLE(h, nurbs_with_points(g, points, 0, 0, NULL, 0, &h), NURBS_ERROR_WEIGHTS_VANISH, "1");
    nurbs_destroy(g);
}

static void bad_arguments(void) {
    nurbs *g = make(circle());
    Args a = good();
    REFUSE(NULL, point_stride, 0, NURBS_ERROR_NULL, "g");
    REFUSE(g, points, NULL, NURBS_ERROR_NULL, "points");
    CHECK_FAILS(with_points(g, &a, NULL), NURBS_ERROR_NULL, "out");
    REFUSE(g, point_stride, -1, NURBS_ERROR_STRIDE, "point|-1");
    REFUSE(g, point_stride, 1, NURBS_ERROR_STRIDE, "point|1");
    REFUSE(g, component_stride, -1, NURBS_ERROR_STRIDE, "point|-1");
    REFUSE(g, weight_stride, -1, NURBS_ERROR_STRIDE, "weight|-1");
    REFUSE(g, points, edited(moved, 18, 17, NAN), NURBS_ERROR_POINT_NOT_FINITE, "points[8|nan");
    REFUSE(g, points, edited(moved, 18, 0, INFINITY), NURBS_ERROR_POINT_NOT_FINITE, "points[0|inf");
    REFUSE(g, weights, edited(other_weights, 9, 3, NAN), NURBS_ERROR_WEIGHT_NOT_FINITE, "weights[3|nan");
    REFUSE(g, weights, edited(other_weights, 9, 3, -1), NURBS_ERROR_WEIGHT_NEGATIVE, "weights[3|-1");
    REFUSE(g, weights, edited(other_weights, 9, 4, 0), NURBS_ERROR_WEIGHTS_VANISH, "weights|(0.5)");
    CHECK_POINTS(g, circle().points);
    CHECK_WEIGHTS(g, circle().weights);
    nurbs_destroy(g);
}

static void clones(void) {
    nurbs *g = make(circle()), *h = NULL, *many[100];
    CHECK_OK(nurbs_clone(g, &h));
    CHECK(h != NULL);
    nurbs_destroy(g);
    CHECK_POINTS(h, circle().points);
    CHECK_WEIGHTS(h, circle().weights);
    for (int i = 0; i < 100; ++i) {
        CHECK_OK(nurbs_clone(i == 0 ? h : many[i - 1], &many[i]));
    }
    nurbs_destroy(h);
    for (int i = 0; i < 99; ++i) {
        nurbs_destroy(many[i]);
    }
    CHECK_KNOTS(many[99], 0, circle().knots);
    CHECK_NO_HANDLE(h, nurbs_clone(NULL, &h), NURBS_ERROR_NULL, "g");
    CHECK_FAILS(nurbs_clone(many[99], NULL), NURBS_ERROR_NULL, "out");
    nurbs_destroy(many[99]);
}

int main(void) {
    new_points();
    polynomial();
    layouts();
    periodicity_is_kept();
    kept_weights();
    bad_arguments();
    clones();
    nurbs_destroy(NULL);
    return check_summary("handle");
}
