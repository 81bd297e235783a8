/* SPDX-License-Identifier: MIT */
/* nurbs_approximate(). */
#include "check.h"
#include "shapes.h"

#include <float.h>
#include <math.h>

#define VALUES(...) ((const double[]){__VA_ARGS__})
#define DEGREES(...) ((const int32_t[]){__VA_ARGS__})

/* The largest distance of a polynomial plane curve from the unit circle at 1000 places, as radii. */
static double from_circle(const nurbs *g) {
    double most = 0;
    for (int i = 0; i <= 1000; ++i) {
        double at[2];
        CHECK_OK(nurbs_eval(g, 1, VALUES(i / 1000.0), 0, 0, at, 0, 0, 0));
        most = fmax(most, fabs(hypot(at[0], at[1]) - 1));
    }
    return most;
}

/* Plane curves, of few control points. */
static void check_same(int line, const nurbs *g, const nurbs *h) {
    int64_t counts[2] = {0, -1};
    double points[2][200];
    CHECK_OK(nurbs_count(g, 0, counts));
    CHECK_OK(nurbs_count(h, 0, counts + 1));
    check_integers(__FILE__, line, "control points", counts[1], counts[0]);
    CHECK_OK(nurbs_points(g, counts[0], points[0], 0, 0));
    CHECK_OK(nurbs_points(h, counts[1], points[1], 0, 0));
    check_bits(__FILE__, line, points[1], points[0], (size_t)(2 * counts[0]) * sizeof(double));
}
#define CHECK_SAME_CURVE(g, h) check_same(__LINE__, g, h)

static void a_circle(void) {
    nurbs *g = make(circle()), *h = NULL, *same = NULL;
    int64_t before = 6;
    int32_t rational = 1, degree = 0;
    for (double tolerance = 1e-1; tolerance > 1e-7; tolerance /= 10) {
        double bound = -1, deviation = -1;
        int64_t count = 0;
        CHECK_OK(nurbs_approximate(g, DEGREES(5), tolerance, 0, &bound, &h));
        CHECK_OK(nurbs_deviation(h, g, NULL, &deviation));
        CHECK_DOUBLE(bound, deviation);
        CHECK(bound <= tolerance && from_circle(h) <= bound);
        CHECK_OK(nurbs_is_rational(h, &rational));
        CHECK_OK(nurbs_degree(h, 0, &degree));
        CHECK_OK(nurbs_count(h, 0, &count));
        CHECK(rational == 0 && degree == 5 && count >= before && count < 60);
        CHECK_OK(nurbs_approximate_with(g, DEGREES(5), tolerance, 0, NULL, NULL, &same));
        CHECK_SAME_CURVE(h, same);
        before = count;
        nurbs_destroy(h);
        nurbs_destroy(same);
    }
    nurbs_destroy(g);
}

/* A polynomial with no more knots than it needs is its own approximation, and so is anything at tolerance 0. */
static void what_is_simple(void) {
    nurbs *g = make(loop()), *h = NULL;
    double bound = -1;
    CHECK_OK(nurbs_approximate(g, NULL, 0, 0, &bound, &h));
    CHECK_DOUBLE(bound, 0);
    CHECK_SAME_CURVE(g, h);
    nurbs_destroy(h);
    double upper = -1; /* raised degrees round, which the bound tells */
    CHECK_OK(nurbs_approximate(g, DEGREES(5), 0, 0, &bound, &h));
    CHECK_OK(nurbs_deviation(h, g, NULL, &upper));
    CHECK_DOUBLE(bound, upper);
    CHECK(bound > 0 && bound < 128 * DBL_EPSILON);
    nurbs_destroy(g);
    nurbs_destroy(h);
}

/* A volume with weights that are all the same, and a half circle whose middle is at infinity. */
static void volumes_and_no_weights(void) {
    static const double corners[] = {0, 0, 0, 0, 0, 1, 0, 1, 0, 0, 1, 1, 1, 0, 0, 1, 0, 1, 1, 1, 0, 1, 1, 1};
    static const double homogeneous[] = {1, 0, 1, 0, 1, 0, -1, 0, 1};
    nurbs *g = NULL, *h = NULL, *rational = NULL;
    int64_t count = 0;
    double bound = -1;
    CHECK_OK(nurbs_volume_trilinear(3, corners, 0, 0, &g));
    CHECK_OK(nurbs_make_rational(g, &rational));
    CHECK_OK(nurbs_approximate(rational, NULL, 1e-6, 0, &bound, &h));
    CHECK_OK(nurbs_point_count(h, &count));
    CHECK(count == 8 && bound <= 1e-6);
    nurbs_destroy(g);
    nurbs_destroy(h);
    nurbs_destroy(rational);
    CHECK_OK(nurbs_create_homogeneous(1, DEGREES(2), (const int64_t[]){3}, VALUES(0, 0, 0, 1, 1, 1), 6, 2,
                                      homogeneous, 0, 0, 0, &g));
    CHECK_OK(nurbs_approximate(g, DEGREES(5), 1e-6, 0, &bound, &h));
    CHECK(bound <= 1e-6 && from_circle(h) <= bound);
    nurbs_destroy(g);
    nurbs_destroy(h);
}

/* The closest one that was met, where few control points are allowed. */
static void too_few(void) {
    nurbs *g = make(circle()), *h = NULL;
    int64_t count = 0;
    double bound = -1;
    CHECK_OK(nurbs_approximate(g, DEGREES(3), 1e-12, 7, &bound, &h));
    CHECK_OK(nurbs_count(h, 0, &count));
    CHECK(count <= 7 && bound > 1e-12 && from_circle(h) <= bound);
    nurbs_destroy(g);
    nurbs_destroy(h);
}

static void refusals(void) {
    nurbs *g = make(circle()), *h = NULL;
    double bound = -7;
    CHECK_NO_HANDLE(h, nurbs_approximate(NULL, NULL, 1, 0, &bound, &h), NURBS_ERROR_NULL, "g");
    CHECK_FAILS(nurbs_approximate(g, NULL, 1, 0, &bound, NULL), NURBS_ERROR_NULL, "out");
    CHECK_NO_HANDLE(h, nurbs_approximate(g, DEGREES(32), 1, 0, &bound, &h), NURBS_ERROR_DEGREE,
                    "degrees[0] = 32");
    CHECK_NO_HANDLE(h, nurbs_approximate(g, DEGREES(-1), 1, 0, &bound, &h), NURBS_ERROR_DEGREE,
                    "degrees[0] = -1");
    CHECK_NO_HANDLE(h, nurbs_approximate(g, NULL, -1e-3, 0, &bound, &h), NURBS_ERROR_TOLERANCE, "-0.001");
    CHECK_NO_HANDLE(h, nurbs_approximate(g, NULL, NAN, 0, &bound, &h), NURBS_ERROR_TOLERANCE, "nan");
    CHECK_NO_HANDLE(h, nurbs_approximate(g, NULL, 1, -1, &bound, &h), NURBS_ERROR_COUNT, "max_count = -1");
    CHECK_NO_HANDLE(h, nurbs_approximate(g, NULL, 1, 2, &bound, &h), NURBS_ERROR_TOO_FEW_POINTS,
                    "max_count = 2|3");
    CHECK_DOUBLE(bound, -7);
    nurbs_destroy(g);
}

int main(void) {
    a_circle();
    what_is_simple();
    volumes_and_no_weights();
    too_few();
    refusals();
    return check_summary("approximate");
}
