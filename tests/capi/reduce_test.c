/* SPDX-License-Identifier: MIT */
/* nurbs_deviation(), nurbs_remove_knot(), nurbs_reduce_knots(), nurbs_reduce_degree() and
 * nurbs_simplify(). */
#include "check.h"
#include "shapes.h"

#include <stdint.h>

#define VALUES(...) ((const double[]){__VA_ARGS__})

/* |actual - expected| <= 1e-12, and on the safe side. */
static void check_bound(int line, double actual, double expected) {
    if (!(actual >= expected && actual <= expected + 1e-12)) {
        check_report(__FILE__, line, "");
        fprintf(stderr, "bound %.17g, expected %.17g and no less\n", actual, expected);
    }
}
#define CHECK_BOUND(actual, expected) check_bound(__LINE__, actual, expected)

static nurbs *shifted(nurbs *g, double x, double y) {
    static const double one[] = {1, 0, 0, 1};
    const double by[] = {x, y};
    nurbs *h = NULL;
    CHECK_OK(nurbs_transform(g, 2, one, by, &h));
    return h;
}

static void deviations(void) {
    nurbs *g = make(circle()), *h = shifted(g, 3, 4), *line = make(jump()), *loops = make(loop());
    double lower = -1, upper = -1;
    CHECK_OK(nurbs_deviation(g, h, &lower, &upper));
    CHECK_BOUND(upper, 5);
    CHECK_BOUND(5, lower);
    CHECK_OK(nurbs_deviation(g, h, NULL, NULL));
    CHECK_OK(nurbs_deviation(loops, loops, &lower, &upper));
    CHECK_BOUND(upper, 0);
    CHECK_DOUBLE(lower, 0);
    upper = -7;
    CHECK_FAILS(nurbs_deviation(g, line, &lower, &upper), NURBS_ERROR_INCOMPATIBLE, "dimension 1|2");
    CHECK_FAILS(nurbs_deviation(g, loops, &lower, &upper), NURBS_ERROR_INCOMPATIBLE, "[2, 6]|[0, 1]|axis 0");
    CHECK_FAILS(nurbs_deviation(NULL, g, &lower, &upper), NURBS_ERROR_NULL, "f");
    CHECK_FAILS(nurbs_deviation(g, NULL, &lower, &upper), NURBS_ERROR_NULL, "g");
    CHECK_DOUBLE(upper, -7);
    nurbs_destroy(g);
    nurbs_destroy(h);
    nurbs_destroy(line);
    nurbs_destroy(loops);
}

/* The sides of the jump become their mean, 3; without the other copy nothing moves any more. */
static void a_jump_removed(void) {
    nurbs *g = make(jump()), *h = NULL;
    int32_t removed = -1;
    double bound = -1;
    CHECK_OK(nurbs_remove_knot(g, 0, 1, 1, 2.5, &removed, &bound, &h));
    CHECK_POINTS(h, VALUES(0, 3, 6));
    CHECK_KNOTS(h, 0, VALUES(0, 0, 1, 2, 2));
    CHECK_BOUND(bound, 2);
    nurbs_destroy(h);
    CHECK_OK(nurbs_remove_knot(g, 0, 1, 5, INFINITY, &removed, NULL, &h));
    CHECK_POINTS(h, VALUES(0, 6));
    if (removed != 2) {
        check_report(__FILE__, __LINE__, "not removed twice\n");
    }
    nurbs_destroy(h);
    CHECK_OK(nurbs_remove_knot(g, 0, 1, 5, 1.99, &removed, &bound, &h));
    CHECK_POINTS(h, VALUES(0, 1, 5, 6));
    if (removed != 0) {
        check_report(__FILE__, __LINE__, "removed beyond the tolerance\n");
    }
    CHECK_DOUBLE(bound, 0);
    nurbs_destroy(h);
    nurbs_destroy(g);
}

static void refused_removals(void) {
    nurbs *g = make(jump()), *ring = make(loop()), *h = NULL;
    CHECK_NO_HANDLE(h, nurbs_remove_knot(g, 0, 0, 1, 1, NULL, NULL, &h), NURBS_ERROR_END_KNOT,
                    "knot = 0|[0, 2]");
    CHECK_NO_HANDLE(h, nurbs_remove_knot(g, 0, 2, 1, 1, NULL, NULL, &h), NURBS_ERROR_END_KNOT, "knot = 2");
    CHECK_NO_HANDLE(h, nurbs_remove_knot(ring, 0, 6, 1, 1, NULL, NULL, &h), NURBS_ERROR_END_KNOT, "seam");
    CHECK_NO_HANDLE(h, nurbs_remove_knot(g, 0, 1.5, 1, 1, NULL, NULL, &h), NURBS_ERROR_NOT_A_KNOT,
                    "knot = 1.5|axis 0");
    CHECK_NO_HANDLE(h, nurbs_remove_knot(g, 0, 3, 1, 1, NULL, NULL, &h), NURBS_ERROR_OUTSIDE_DOMAIN,
                    "knot = 3|[0, 2]");
    CHECK_NO_HANDLE(h, nurbs_remove_knot(g, 0, NAN, 1, 1, NULL, NULL, &h), NURBS_ERROR_PARAMETER_NOT_FINITE,
                    "knot = nan");
    CHECK_NO_HANDLE(h, nurbs_remove_knot(g, 0, 1, -1, 1, NULL, NULL, &h), NURBS_ERROR_TIMES, "times = -1");
    CHECK_NO_HANDLE(h, nurbs_remove_knot(g, 0, 1, 1, -1, NULL, NULL, &h), NURBS_ERROR_TOLERANCE,
                    "tolerance = -1");
    CHECK_NO_HANDLE(h, nurbs_remove_knot(g, 0, 1, 1, NAN, NULL, NULL, &h), NURBS_ERROR_TOLERANCE, "nan");
    CHECK_NO_HANDLE(h, nurbs_remove_knot(g, 1, 1, 1, 1, NULL, NULL, &h), NURBS_ERROR_AXIS, "axis = 1");
    CHECK_NO_HANDLE(h, nurbs_remove_knot(NULL, 0, 1, 1, 1, NULL, NULL, &h), NURBS_ERROR_NULL, "g");
    CHECK_FAILS(nurbs_remove_knot(g, 0, 1, 1, 1, NULL, NULL, NULL), NURBS_ERROR_NULL, "out");
    nurbs_destroy(g);
    nurbs_destroy(ring);
}

static void data_reduction(void) {
    nurbs *g = make(arch()), *fine = NULL, *h = NULL;
    double bound = -1;
    CHECK_OK(nurbs_refine_uniform(g, 0, 8, &fine));
    CHECK_OK(nurbs_reduce_knots(fine, 0, 1e-12, &bound, &h));
    CHECK_KNOTS(h, 0, VALUES(0, 0, 0, 0, 1, 1, 1, 1));
    CHECK_BOUND(bound, 0);
    nurbs_destroy(h);
    CHECK_OK(nurbs_reduce_knots(fine, -1, 0, &bound, &h));
    CHECK_DOUBLE(bound, 0);
    nurbs_destroy(h);
    CHECK_OK(nurbs_reduce_knots(fine, -1, INFINITY, NULL, &h));
    nurbs_destroy(h);
    CHECK_NO_HANDLE(h, nurbs_reduce_knots(g, 0, -1, &bound, &h), NURBS_ERROR_TOLERANCE, "tolerance = -1");
    CHECK_NO_HANDLE(h, nurbs_reduce_knots(g, 0, NAN, &bound, &h), NURBS_ERROR_TOLERANCE, "nan");
    CHECK_NO_HANDLE(h, nurbs_reduce_knots(g, 1, 1, &bound, &h), NURBS_ERROR_AXIS, "axis = 1");
    CHECK_NO_HANDLE(h, nurbs_reduce_knots(g, -2, 1, &bound, &h), NURBS_ERROR_AXIS, "axis = -2|-1 to 0");
    CHECK_NO_HANDLE(h, nurbs_reduce_knots(NULL, 0, 1, &bound, &h), NURBS_ERROR_NULL, "g");
    CHECK_FAILS(nurbs_reduce_knots(g, 0, 1, &bound, NULL), NURBS_ERROR_NULL, "out");
    nurbs_destroy(g);
    nurbs_destroy(fine);
}

/* t^2 - t = -1/4 in the middle: the line between its ends is 1/4 away. */
static void degree_reduction(void) {
    static const int32_t degree = 2;
    static const int64_t count = 3;
    static const double knots[] = {0, 0, 0, 1, 1, 1}, points[] = {0, -0.5, 0};
    nurbs *g = NULL, *h = NULL;
    double bound = -1;
    CHECK_OK(nurbs_create(1, &degree, &count, knots, 6, 1, points, 0, 0, NULL, 0, 0, &g));
    CHECK_OK(nurbs_reduce_degree(g, 0, 1, &bound, &h));
    CHECK_POINTS(h, VALUES(0, 0));
    CHECK_BOUND(bound, 0.25);
    nurbs_destroy(h);
    CHECK_OK(nurbs_reduce_degree(g, 0, 0, &bound, &h));
    CHECK_DOUBLE(bound, 0);
    nurbs_destroy(h);
    CHECK_NO_HANDLE(h, nurbs_reduce_degree(g, 0, 3, &bound, &h), NURBS_ERROR_DEGREE, "degree 2|times = 3");
    CHECK_NO_HANDLE(h, nurbs_reduce_degree(g, 0, -1, &bound, &h), NURBS_ERROR_TIMES, "times = -1");
    CHECK_NO_HANDLE(h, nurbs_reduce_degree(g, 1, 1, &bound, &h), NURBS_ERROR_AXIS, "axis = 1");
    CHECK_NO_HANDLE(h, nurbs_reduce_degree(NULL, 0, 1, &bound, &h), NURBS_ERROR_NULL, "g");
    CHECK_FAILS(nurbs_reduce_degree(g, 0, 1, &bound, NULL), NURBS_ERROR_NULL, "out");
    nurbs_destroy(g);
}

static void weights_of_no_sign(void) {
    static const int32_t degree = 3;
    static const int64_t count = 4;
    static const double knots[] = {0, 0, 0, 0, 1, 1, 1, 1}, points[] = {0, 1, 2, 3};
    static const double weights[] = {1, 0.01, 0.01, 1};
    nurbs *g = NULL, *h = NULL;
    CHECK_OK(nurbs_create(1, &degree, &count, knots, 8, 1, points, 0, 0, weights, 0, 0, &g));
    CHECK_NO_HANDLE(h, nurbs_reduce_degree(g, 0, 1, NULL, &h), NURBS_ERROR_WEIGHT_SIGN, "weight -|>= 0");
    nurbs_destroy(g);
}

/* A control point without effect. */
static void weights_of_zero(void) {
    static const int32_t degree = 2;
    static const double points[] = {1, 0, 1, 1, 0, 1}, weights[] = {1, 0, 1};
    nurbs *g = NULL, *other = NULL, *h = NULL;
    double bound = -1, found[3];
    int32_t removed = 0;
    CHECK_OK(nurbs_create_bezier(1, &degree, 2, points, 0, 0, weights, 0, &g));
    CHECK_OK(nurbs_elevate(g, 0, 1, &other));
    CHECK_OK(nurbs_reduce_degree(other, 0, 1, &bound, &h));
    CHECK(bound >= 0 && bound <= 1e-13);
    CHECK_OK(nurbs_weights(h, 3, found, 0));
    CHECK_DOUBLES(found, weights, 3);
    nurbs_destroy(h);
    nurbs_destroy(other);
    CHECK_OK(nurbs_insert_knot(g, 0, 0.3, 1, &other));
    CHECK_OK(nurbs_deviation(g, other, NULL, &bound));
    CHECK(bound <= 1e-13);
    CHECK_OK(nurbs_reduce_knots(other, 0, 1e-12, &bound, &h));
    CHECK_KNOTS(h, 0, ((const double[]){0, 0, 0, 1, 1, 1}));
    nurbs_destroy(h);
    CHECK_OK(nurbs_remove_knot(other, 0, 0.3, 1, 1e-12, &removed, &bound, &h));
    CHECK_INT(removed, 1);
    nurbs_destroy(h);
    nurbs_destroy(other);
    nurbs_destroy(g);
}

/* Half a circle, of degree 2 with the point at infinity where its end tangents meet: (1 - s^2, 2 s) / (1 +
 * s^2). */
static void points_at_infinity(void) {
    static const int32_t degree = 3;
    static const double points[] = {0, -1, 2, -1, 2, 1, 0, 1}, weights[] = {3, 1, 1, 3};
    static const double middle = 0.5, top[] = {1, 0};
    nurbs *g = NULL, *h = NULL;
    double bound = -1, found[3];
    CHECK_OK(nurbs_create_bezier(1, &degree, 2, points, 0, 0, weights, 0, &g));
    CHECK_OK(nurbs_reduce_degree(g, 0, 1, &bound, &h));
    CHECK(bound >= 0 && bound <= 1e-12);
    CHECK_OK(nurbs_weights(h, 3, found, 0));
    CHECK_DOUBLES(found, ((const double[]){3, 0, 3}), 3);
    CHECK_OK(nurbs_eval(h, 1, &middle, 0, 0, found, 0, 0, 0));
    CHECK_NEAR(found, top, 2, 1e-15);
    nurbs_destroy(h);
    nurbs_destroy(g);
}

static void simplification(void) {
    nurbs *g = make(arch()), *high = NULL, *fine = NULL, *rational = NULL, *h = NULL;
    double bound = -1;
    int32_t is_rational = 1;
    CHECK_OK(nurbs_elevate(g, 0, 2, &high));
    CHECK_OK(nurbs_refine_uniform(high, 0, 4, &fine));
    CHECK_OK(nurbs_make_rational(fine, &rational));
    CHECK_OK(nurbs_simplify(rational, 1e-12, &bound, &h));
    CHECK_KNOTS(h, 0, VALUES(0, 0, 0, 0, 1, 1, 1, 1));
    CHECK_OK(nurbs_is_rational(h, &is_rational));
    if (is_rational != 0) {
        check_report(__FILE__, __LINE__, "weights of 1 were kept\n");
    }
    CHECK_BOUND(bound, 0);
    nurbs_destroy(h);
    CHECK_OK(nurbs_simplify(g, 0, &bound, &h));
    CHECK_DOUBLE(bound, 0);
    nurbs_destroy(h);
    CHECK_NO_HANDLE(h, nurbs_simplify(g, -1, &bound, &h), NURBS_ERROR_TOLERANCE, "tolerance = -1");
    CHECK_NO_HANDLE(h, nurbs_simplify(g, NAN, &bound, &h), NURBS_ERROR_TOLERANCE, "nan");
    CHECK_NO_HANDLE(h, nurbs_simplify(NULL, 1, &bound, &h), NURBS_ERROR_NULL, "g");
    CHECK_FAILS(nurbs_simplify(g, 1, &bound, NULL), NURBS_ERROR_NULL, "out");
    nurbs_destroy(g);
    nurbs_destroy(high);
    nurbs_destroy(fine);
    nurbs_destroy(rational);
}

int main(void) {
    deviations();
    a_jump_removed();
    refused_removals();
    data_reduction();
    degree_reduction();
    weights_of_no_sign();
    weights_of_zero();
    points_at_infinity();
    simplification();
    return check_summary("reduce");
}
