/* SPDX-License-Identifier: MIT */
/* nurbs_distance(), nurbs_hausdorff_distance(). */
#include "shapes.h"

#include <math.h>
#include <time.h>

static nurbs *segment(int32_t dim, const double *ends) {
    static const int32_t degree = 1;
    nurbs *g = NULL;
    CHECK_OK(nurbs_create_bezier(1, &degree, dim, ends, 0, 0, NULL, 0, &g));
    return g;
}

static void pairs(void) {
    static const double ends[] = {2, 0.5, 4, 1};
    double at_least, at_most, a, b;
    int32_t status;
    nurbs *round = make(circle()), *line = segment(2, ends), *square = make(loop());
    CHECK_OK(nurbs_distance(round, line, 1e-10, 0, &at_least, &at_most, &a, &b, &status));
    CHECK_INT(status, NURBS_CLOSEST_CERTIFIED);
    const double exact = sqrt(4.25) - 1;
    CHECK(at_least <= exact + 1e-15 && at_most >= exact - 1e-15 && at_most - at_least <= 1e-10 + 1e-12);
    CHECK_DOUBLE(b, 0);
    CHECK_OK(nurbs_distance(round, square, 1e-10, 0, &at_least, &at_most, NULL, NULL, NULL));
    CHECK(at_least == 0 && at_most <= 1e-10);
    CHECK_OK(nurbs_distance(round, line, 1e-10, 0, NULL, NULL, NULL, NULL, NULL));
    CHECK_OK(nurbs_distance(round, line, 0, 1, &at_least, &at_most, &a, &b, &status));
    CHECK_INT(status, NURBS_CLOSEST_BUDGET);
    CHECK(at_least <= exact && at_most >= exact - 1e-15);
    nurbs_destroy(round);
    nurbs_destroy(line);
    nurbs_destroy(square);
}

static void sets(void) {
    static const double ends[] = {0, 0, 1, 0}, longer[] = {0, 0, 3, 0};
    double at_least[2], at_most[2], a, b;
    int32_t status;
    nurbs *part = segment(2, ends), *whole = segment(2, longer);
    CHECK_OK(nurbs_hausdorff_distance(part, whole, 1e-9, 0, at_least, at_most, &a, &b, &status));
    CHECK_INT(status, NURBS_CLOSEST_CERTIFIED);
    CHECK(at_most[0] <= 1e-9 && at_least[1] >= 2 - 2e-9 && at_most[1] <= 2 + 2e-9);
    CHECK_OK(nurbs_hausdorff_distance(part, whole, 1e-9, 0, NULL, NULL, NULL, NULL, NULL));
    nurbs_destroy(part);
    nurbs_destroy(whole);
}

/* A surface that goes to infinity where its weights change their sign: each point of it, and each point asked
   of it, costs a whole search, which counts. Else a budget of 2000 takes 20 seconds, not some
   milliseconds. */
static void poles(void) {
    static const int32_t degrees[] = {2, 2};
    static const int64_t counts[] = {3, 3};
    static const double knots[] = {0, 0, 0, 1, 1, 1, 0, 0, 0, 1, 1, 1};
    double at_least[2], at_most[2], records[36], points[27];
    int32_t status;
    nurbs *g = NULL, *h = NULL;
    for (int i = 0; i < 9; ++i) {
        const double w = i == 1 ? -1 : 1, net[] = {i / 3, i % 3, (i * 7) % 5},
                     other[] = {i / 3, i % 3, (i * 3) % 4};
        for (int c = 0; c < 3; ++c) {
            records[4 * i + c] = w * net[c];
            points[3 * i + c] = other[c];
        }
        records[4 * i + 3] = w;
    }
    CHECK_OK(nurbs_create_homogeneous(2, degrees, counts, knots, 12, 3, records, 0, 0, 0, &g));
    CHECK_OK(nurbs_create(2, degrees, counts, knots, 12, 3, points, 0, 0, NULL, 0, 0, &h));
    const clock_t start = clock();
    CHECK_OK(nurbs_hausdorff_distance(g, h, 1e-3, 2000, at_least, at_most, NULL, NULL, &status));
    CHECK((double)(clock() - start) / CLOCKS_PER_SEC < 5);
    CHECK_INT(status, NURBS_CLOSEST_BUDGET);
    CHECK(at_least[0] > 0 && isinf(at_most[0]) && at_least[1] <= at_most[1]);
    nurbs_destroy(g);
    nurbs_destroy(h);
}

/* A limit of work is for both directions: the first one leaves some of it. */
static void both_directions(void) {
    nurbs *g = make(trough()), *h = NULL;
    static const double far[] = {0, 0, 2, 0, 3, 2.5, 1, 0, 2, 1, 3, 4};
    static const int32_t degrees[] = {1, 1};
    double at_least[2], at_most[2];
    int32_t status;
    nurbs_call_options call;
    CHECK_OK(nurbs_create_bezier(2, degrees, 3, far, 0, 0, NULL, 0, &h));
    CHECK_OK(nurbs_call_options_init(&call, sizeof call));
    call.work = 2000000;
    CHECK_OK(nurbs_hausdorff_distance_with(g, h, 0, 0, at_least, at_most, NULL, NULL, &status, &call));
    CHECK_INT(status, NURBS_CLOSEST_BUDGET);
    CHECK(at_most[0] < 10 && at_most[1] < 10);
    nurbs_destroy(g);
    nurbs_destroy(h);
}

/* Degree 0, jumps, one dimension. */
static void steps(void) {
    static const double ends[] = {13, 17};
    double at_least, at_most, a, b;
    nurbs *g = make(stairs()), *h = segment(1, ends), *j = make(jump());
    CHECK_OK(nurbs_distance(g, h, 0, 0, &at_least, &at_most, &a, &b, NULL));
    CHECK_NEAR(&at_most, &(double){3}, 1, 1e-14);
    CHECK(at_least <= 3 && at_least > 3 - 1e-10);
    CHECK_OK(nurbs_distance(j, h, 1e-9, 0, &at_least, &at_most, &a, &b, NULL));
    CHECK_NEAR(&at_most, &(double){7}, 1, 1e-9);
    nurbs_destroy(g);
    nurbs_destroy(h);
    nurbs_destroy(j);
}

static void bad_input(void) {
    double out[4];
    int32_t status = 77;
    FILL(out);
    nurbs *g = make(circle()), *h = make(twist());
    CHECK_FAILS(nurbs_distance(NULL, g, 0, 0, out, out + 1, NULL, NULL, NULL), NURBS_ERROR_NULL, "a");
    CHECK_FAILS(nurbs_distance(g, NULL, 0, 0, out, out + 1, NULL, NULL, NULL), NURBS_ERROR_NULL, "b");
    CHECK_FAILS(nurbs_distance(g, h, 0, 0, out, out + 1, NULL, NULL, &status), NURBS_ERROR_INCOMPATIBLE,
                "3|2");
    CHECK_FAILS(nurbs_distance(g, g, -1, 0, out, out + 1, NULL, NULL, &status), NURBS_ERROR_TOLERANCE,
                "tolerance = -1");
    CHECK_FAILS(nurbs_distance(g, g, NAN, 0, out, out + 1, NULL, NULL, &status), NURBS_ERROR_TOLERANCE,
                "nan");
    CHECK_FAILS(nurbs_distance(g, g, 0, -1, out, out + 1, NULL, NULL, &status), NURBS_ERROR_COUNT,
                "budget = -1");
    CHECK_FAILS(nurbs_distance(g, g, 0, 0, out, out, NULL, NULL, &status), NURBS_ERROR_OVERLAP,
                "at_least|at_most");
    CHECK_FAILS(nurbs_hausdorff_distance(NULL, g, 0, 0, out, out + 2, NULL, NULL, NULL), NURBS_ERROR_NULL,
                "a");
    CHECK_FAILS(nurbs_hausdorff_distance(g, h, 0, 0, out, out + 2, NULL, NULL, &status),
                NURBS_ERROR_INCOMPATIBLE, "3|2");
    CHECK_FAILS(nurbs_hausdorff_distance(g, g, 0, 0, out, out + 1, NULL, NULL, &status), NURBS_ERROR_OVERLAP,
                "at_least|at_most");
    CHECK_INT(status, 77);
    CHECK_UNTOUCHED(out);
    nurbs_destroy(g);
    nurbs_destroy(h);
}

int main(void) {
    pairs();
    sets();
    both_directions();
    poles();
    steps();
    bad_input();
    return check_summary("distance");
}
