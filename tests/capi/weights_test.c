/* SPDX-License-Identifier: MIT */
/* nurbs_normalize_weights(), nurbs_reparametrize_moebius() and nurbs_equalize_end_weights(). */
#include "check.h"
#include "shapes.h"

#include <stdint.h>

#define VALUES(...) ((const double[]){__VA_ARGS__})

/* A quadratic Bezier curve with these weights. */
static nurbs *weighted(double a, double b, double c) {
    const double points[] = {0, 1, 4}, weights[] = {a, b, c};
    const int32_t degree = 2;
    nurbs *g = NULL;
    CHECK_OK(nurbs_create_bezier(1, &degree, 1, points, 0, 0, weights, 0, &g));
    return g;
}

static void normalized(void) {
    nurbs *g = weighted(2, 4, 1), *h = NULL;
    CHECK_OK(nurbs_normalize_weights(g, &h));
    CHECK_POINTS(h, VALUES(0, 1, 4));
    CHECK_WEIGHTS(h, VALUES(0.5, 1, 0.25));
    nurbs_destroy(h);
    nurbs_destroy(g);
    g = weighted(3, 3, 3);
    CHECK_OK(nurbs_normalize_weights(g, &h));
    int32_t rational = -1;
    CHECK_OK(nurbs_is_rational(h, &rational));
    CHECK(rational == 0);
    CHECK_POINTS(h, VALUES(0, 1, 4));
    nurbs_destroy(g);
    CHECK_OK(nurbs_normalize_weights(h, &g));
    CHECK_POINTS(g, VALUES(0, 1, 4));
    nurbs_destroy(g);
    nurbs_destroy(h);
    static const int32_t degree = 1; /* homogeneous: the weight of largest magnitude becomes 1 */
    static const int64_t count = 2;
    CHECK_OK(nurbs_create_homogeneous(1, &degree, &count, VALUES(0, 0, 1, 1), 4, 1, VALUES(2, -4, 3, 1), 0, 0,
                                      0, &g));
    CHECK_OK(nurbs_normalize_weights(g, &h));
    double records[4];
    CHECK_OK(nurbs_homogeneous_points(h, 2, records, 0, 0));
    CHECK(records[0] == -0.5 && records[1] == 1 && records[2] == -0.75 && records[3] == -0.25);
    nurbs_destroy(h);
    CHECK_NO_HANDLE(h, nurbs_normalize_weights(NULL, &h), NURBS_ERROR_NULL, "g is NULL");
    CHECK_FAILS(nurbs_normalize_weights(g, NULL), NURBS_ERROR_NULL, "out is NULL");
    nurbs_destroy(g);
}

static void mapped(void) {
    nurbs *g = make(arch()), *h = NULL;
    CHECK_OK(nurbs_reparametrize_moebius(g, 0, 8, &h)); /* rho = 2: weights 1, 2, 4, 8 */
    CHECK_POINTS(h, VALUES(0, 0, 1, 2, 3, 2, 4, 0));
    double w[4], at[2], before[2];
    CHECK_OK(nurbs_weights(h, 4, w, 0));
    for (int i = 0; i < 4; ++i) {
        CHECK(fabs(w[i] - (1 << i)) < 1e-14);
    }
    CHECK_OK(nurbs_eval(h, 1, VALUES(1.0 / 3), 0, 0, at, 0, 0, 0)); /* t = 1/2 */
    CHECK_OK(nurbs_eval(g, 1, VALUES(0.5), 0, 0, before, 0, 0, 0));
    CHECK(fabs(at[0] - before[0]) < 1e-14 && fabs(at[1] - before[1]) < 1e-14);
    nurbs_destroy(h);
    CHECK_OK(nurbs_reparametrize_moebius(g, 0, 1, &h));
    int32_t rational = -1;
    CHECK_OK(nurbs_is_rational(h, &rational));
    CHECK(rational == 0);
    nurbs_destroy(h);
    CHECK_NO_HANDLE(h, nurbs_reparametrize_moebius(g, 0, 0, &h), NURBS_ERROR_FACTOR, "ratio = 0");
    CHECK_NO_HANDLE(h, nurbs_reparametrize_moebius(g, 0, -2, &h), NURBS_ERROR_FACTOR, "ratio = -2");
    CHECK_NO_HANDLE(h, nurbs_reparametrize_moebius(g, 0, NAN, &h), NURBS_ERROR_FACTOR, "ratio = nan");
    CHECK_NO_HANDLE(h, nurbs_reparametrize_moebius(g, 0, INFINITY, &h), NURBS_ERROR_FACTOR, "ratio = inf");
    CHECK_NO_HANDLE(h, nurbs_reparametrize_moebius(g, 1, 2, &h), NURBS_ERROR_AXIS, "axis = 1");
    CHECK_NO_HANDLE(h, nurbs_reparametrize_moebius(NULL, 0, 2, &h), NURBS_ERROR_NULL, "g is NULL");
    CHECK_FAILS(nurbs_reparametrize_moebius(g, 0, 2, NULL), NURBS_ERROR_NULL, "out is NULL");
    nurbs_destroy(g);
    g = make(loop());
    CHECK_NO_HANDLE(h, nurbs_reparametrize_moebius(g, 0, 2, &h), NURBS_ERROR_PERIODIC, "axis 0 is periodic");
    nurbs_destroy(g);
    g = make(stairs());
    CHECK_NO_HANDLE(h, nurbs_reparametrize_moebius(g, 0, 2, &h), NURBS_ERROR_DEGREE, "degree 0");
    nurbs_destroy(g);
    g = make(hill()); /* outer knots reach behind the pole */
    CHECK_NO_HANDLE(h, nurbs_reparametrize_moebius(g, 0, 1e4, &h), NURBS_ERROR_KNOTS_MERGE,
                    "knots[6] = 6|axis 0|pole");
    CHECK_OK(nurbs_reparametrize_moebius(g, 0, 1.21, &h));
    nurbs_destroy(h);
    nurbs_destroy(g);
}

/* Ratios at which rho times the length of the domain leaves double precision. */
static void extreme_ratios(void) {
    static const int32_t degree = 1;
    static const int64_t count = 2;
    nurbs *g = NULL, *h = NULL;
    double records[4];
    CHECK_OK(nurbs_create_homogeneous(1, &degree, &count, VALUES(0, 0, 1e10, 1e10), 4, 1, VALUES(0, 1, 1, 1),
                                      0, 0, 0, &g));
    CHECK_OK(nurbs_reparametrize_moebius(g, 0, 1e300, &h));
    CHECK_KNOTS(h, 0, VALUES(0, 0, 1e10, 1e10));
    CHECK_OK(nurbs_homogeneous_points(h, 2, records, 0, 0));
    CHECK_DOUBLES(records, VALUES(0, 1, 1e300, 1e300), 4);
    nurbs_destroy(h);
    nurbs_destroy(g);
    static const double lengths[] = {1e-300, 0.7, 1e300}, ratios[] = {1e-300, 3, 1e300};
    for (int i = 0; i < 9; ++i) {
        const double b = lengths[i / 3], r = ratios[i % 3];
        CHECK_OK(
            nurbs_create(1, &degree, &count, VALUES(0, 0, b, b), 4, 1, VALUES(0, 1), 0, 0, NULL, 0, 0, &g));
        CHECK_OK(nurbs_reparametrize_moebius(g, 0, r, &h));
        CHECK_KNOTS(h, 0, VALUES(0, 0, b, b));
        CHECK_WEIGHTS(h, VALUES(1, r));
        nurbs_destroy(h);
        nurbs_destroy(g);
    }
}

/* Equal weights stay as they are, also where the basis functions at unclamped ends sum to 1 but for rounding.
 */
static void already_equal(void) {
    static const int32_t degree = 3;
    static const int64_t count = 5;
    for (int i = 1; i < 50; ++i) {
        double knots[9];
        for (int k = 0; k < 9; ++k) {
            knots[k] = k + 0.4 * sin(k * i);
        }
        nurbs *g = NULL, *h = NULL;
        int32_t rational = -1;
        CHECK_OK(nurbs_create(1, &degree, &count, knots, 9, 1, VALUES(0, 1, 3, 2, 5), 0, 0, NULL, 0, 0, &g));
        CHECK_OK(nurbs_equalize_end_weights(g, 0, &h));
        CHECK_OK(nurbs_is_rational(h, &rational));
        CHECK(rational == 0);
        CHECK_KNOTS(h, 0, knots);
        nurbs_destroy(h);
        nurbs_destroy(g);
    }
}

static void equalized(void) {
    nurbs *g = weighted(2, 3, 8), *h = NULL;
    CHECK_OK(nurbs_equalize_end_weights(g, 0, &h)); /* rho = 1/2: 2, 3/2, 8/4 */
    CHECK_WEIGHTS(h, VALUES(2, 1.5, 2));
    nurbs_destroy(h);
    CHECK_NO_HANDLE(h, nurbs_equalize_end_weights(g, 1, &h), NURBS_ERROR_AXIS, "axis = 1");
    CHECK_NO_HANDLE(h, nurbs_equalize_end_weights(NULL, 0, &h), NURBS_ERROR_NULL, "g is NULL");
    CHECK_FAILS(nurbs_equalize_end_weights(g, 0, NULL), NURBS_ERROR_NULL, "out is NULL");
    nurbs_destroy(g);
    static const int32_t degree = 1;
    static const int64_t count = 2;
    CHECK_OK(nurbs_create_homogeneous(1, &degree, &count, VALUES(0, 0, 1, 1), 4, 1, VALUES(2, -4, 3, 1), 0, 0,
                                      0, &g));
    CHECK_NO_HANDLE(h, nurbs_equalize_end_weights(g, 0, &h), NURBS_ERROR_END_WEIGHTS, "axis 0|-4 and 1");
    nurbs_destroy(g);
}

int main(void) {
    normalized();
    mapped();
    extreme_ratios();
    already_equal();
    equalized();
    return check_summary("weights");
}
