/* SPDX-License-Identifier: MIT */
/* nurbs_reverse(), nurbs_transpose(), nurbs_reparametrize(), nurbs_make_rational() and the homogeneous
 * form. */
#include "check.h"
#include "shapes.h"

#include <stdint.h>

#define VALUES(...) ((const double[]){__VA_ARGS__})

static void reversal(void) {
    int32_t form = 0;
    nurbs *g = make(jump()), *h = NULL, *k = NULL;
    CHECK_OK(nurbs_reverse(g, 0, 0, &h));
    CHECK_KNOTS(h, 0, VALUES(-2, -2, -1, -1, -0.0, -0.0));
    CHECK_POINTS(h, VALUES(6, 5, 1, 0));
    CHECK_OK(nurbs_reverse(g, 0, NURBS_KEEP_DOMAIN, &k));
    CHECK_KNOTS(k, 0, VALUES(0, 0, 1, 1, 2, 2));
    CHECK_POINTS(k, VALUES(6, 5, 1, 0));
    nurbs_destroy(g);
    nurbs_destroy(h);
    nurbs_destroy(k);
    g = make(loop());
    CHECK_OK(nurbs_reverse(g, 0, NURBS_KEEP_DOMAIN, &h));
    CHECK_OK(nurbs_knot_form(h, 0, &form));
    CHECK_INT(form, NURBS_FORM_PERIODIC);
    CHECK_KNOTS(h, 0, loop().knots);
    nurbs_destroy(g);
    nurbs_destroy(h);
    g = make(trough());
    CHECK_OK(nurbs_reverse(g, 1, 0, &h));
    CHECK_KNOTS(h, 0, VALUES(0, 0, 0, 1, 1, 1));
    CHECK_KNOTS(h, 1, VALUES(-3, -3, -2, -1, -0.0, -0.0));
    nurbs_destroy(g);
    nurbs_destroy(h);
}

static void transposition(void) {
    static const int32_t swap[] = {1, 0}, turn[] = {2, 0, 1}, twice[] = {1, 1}, beyond[] = {0, 2};
    nurbs *g = make(patch()), *h = NULL;
    CHECK_OK(nurbs_transpose(g, swap, &h));
    CHECK_POINTS(h, VALUES(0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 1));
    nurbs_destroy(h);
    CHECK_NO_HANDLE(h, nurbs_transpose(g, twice, &h), NURBS_ERROR_AXIS, "permutation[1] = 1|permutation[0]");
    CHECK_NO_HANDLE(h, nurbs_transpose(g, beyond, &h), NURBS_ERROR_AXIS, "permutation[1] = 2|0 to 1");
    CHECK_NO_HANDLE(h, nurbs_transpose(g, NULL, &h), NURBS_ERROR_NULL, "permutation");
    CHECK_NO_HANDLE(h, nurbs_transpose(NULL, swap, &h), NURBS_ERROR_NULL, "g");
    CHECK_FAILS(nurbs_transpose(g, swap, NULL), NURBS_ERROR_NULL, "out");
    nurbs_destroy(g);
    g = make(cube());
    CHECK_OK(nurbs_transpose(g, turn, &h));
    const double at[] = {0.25, 0.5, 0.75}; /* of axes 2, 0, 1 */
    double point[4];
    CHECK_OK(nurbs_eval(h, 1, at, 0, 0, point, 0, 0, 0));
    CHECK_NEAR(point, VALUES(0.5, 0.75, 0.25, 0.09375), 4, 9 * 0x1p-52);
    nurbs_destroy(g);
    nurbs_destroy(h);
}

/* The ratio of the lengths of the domains leaves double precision. */
static void extreme_domains(void) {
    static const int32_t degree = 1;
    static const int64_t count = 3;
    static const double from[] = {1e-10, 1e15, 1e15, 4}, to[] = {1e300, 1e-305, 4e-320, 1e308};
    for (int i = 0; i < 4; ++i) {
        const double a = from[i], b = to[i];
        nurbs *g = NULL, *h = NULL;
        CHECK_OK(nurbs_create(1, &degree, &count, VALUES(0, 0, 0.25 * a, a, a), 5, 1, VALUES(0, 1, 3), 0, 0,
                              NULL, 0, 0, &g));
        CHECK_OK(nurbs_reparametrize(g, 0, 0, b, &h));
        CHECK_KNOTS(h, 0, VALUES(0, 0, 0.25 * b, b, b));
        nurbs_destroy(h);
        nurbs_destroy(g);
    }
}

static void other_domains(void) {
    nurbs *g = make(hill()), *h = NULL;
    CHECK_OK(nurbs_reparametrize(g, 0, 0, 6, &h));
    CHECK_KNOTS(h, 0, VALUES(-4, -2, 0, 2, 4, 6, 8, 10));
    CHECK_POINTS(h, hill().points);
    nurbs_destroy(h);
    CHECK_OK(nurbs_reparametrize(g, 0, 2, 5, &h));
    CHECK_KNOTS(h, 0, hill().knots);
    nurbs_destroy(h);
    CHECK_NO_HANDLE(h, nurbs_reparametrize(g, 0, 1, 1, &h), NURBS_ERROR_EMPTY_DOMAIN, "lower = 1|upper = 1");
    CHECK_NO_HANDLE(h, nurbs_reparametrize(g, 0, 2, 1, &h), NURBS_ERROR_EMPTY_DOMAIN, "lower = 2|upper = 1");
    CHECK_NO_HANDLE(h, nurbs_reparametrize(g, 0, NAN, 1, &h), NURBS_ERROR_PARAMETER_NOT_FINITE, "lower|nan");
    CHECK_NO_HANDLE(h, nurbs_reparametrize(g, 0, 0, INFINITY, &h), NURBS_ERROR_PARAMETER_NOT_FINITE,
                    "upper|inf");
    CHECK_NO_HANDLE(h, nurbs_reparametrize(g, 0, 1, 1 + 0x1p-52, &h), NURBS_ERROR_KNOTS_MERGE,
                    "knots[0] = 0|knots[1] = 1|axis 0|mapped to 0.99");
    CHECK_NO_HANDLE(h, nurbs_reparametrize(g, 0, -1.7e308, 1.7e308, &h), NURBS_ERROR_NOT_REPRESENTABLE,
                    "axis 0");
    CHECK_NO_HANDLE(h, nurbs_reparametrize(g, 1, 0, 1, &h), NURBS_ERROR_AXIS, "axis = 1");
    CHECK_NO_HANDLE(h, nurbs_reparametrize(NULL, 0, 0, 1, &h), NURBS_ERROR_NULL, "g");
    CHECK_FAILS(nurbs_reparametrize(g, 0, 0, 1, NULL), NURBS_ERROR_NULL, "out");
    CHECK_NO_HANDLE(h, nurbs_reverse(g, 0, 1, &h), NURBS_ERROR_FLAGS, "flags");
    CHECK_NO_HANDLE(h, nurbs_reverse(g, -1, 0, &h), NURBS_ERROR_AXIS, "axis = -1");
    CHECK_NO_HANDLE(h, nurbs_reverse(NULL, 0, 0, &h), NURBS_ERROR_NULL, "g");
    CHECK_FAILS(nurbs_reverse(g, 0, 0, NULL), NURBS_ERROR_NULL, "out");
    CHECK_POINTS(g, hill().points);
    nurbs_destroy(g);
}

static void rational_forms(void) {
    int32_t dim = 0, rational = 0;
    nurbs *g = make(jump()), *h = NULL, *k = NULL;
    CHECK_OK(nurbs_make_rational(g, &h));
    CHECK_WEIGHTS(h, VALUES(1, 1, 1, 1));
    CHECK_OK(nurbs_is_rational(h, &rational));
    CHECK_INT(rational, 1);
    nurbs_destroy(h);
    CHECK_NO_HANDLE(h, nurbs_from_homogeneous(g, &h), NURBS_ERROR_DIMENSION, "dimension 1|at least 2");
    CHECK_NO_HANDLE(h, nurbs_make_rational(NULL, &h), NURBS_ERROR_NULL, "g");
    CHECK_FAILS(nurbs_make_rational(g, NULL), NURBS_ERROR_NULL, "out");
    CHECK_NO_HANDLE(h, nurbs_to_homogeneous(NULL, &h), NURBS_ERROR_NULL, "g");
    CHECK_FAILS(nurbs_to_homogeneous(g, NULL), NURBS_ERROR_NULL, "out");
    CHECK_NO_HANDLE(h, nurbs_from_homogeneous(NULL, &h), NURBS_ERROR_NULL, "g");
    CHECK_FAILS(nurbs_from_homogeneous(g, NULL), NURBS_ERROR_NULL, "out");
    nurbs_destroy(g);
    g = make(circle());
    CHECK_NO_HANDLE(h, nurbs_from_homogeneous(g, &h), NURBS_ERROR_RATIONAL, "rational");
    CHECK_OK(nurbs_to_homogeneous(g, &h));
    CHECK_OK(nurbs_dimension(h, &dim));
    CHECK_INT(dim, 3);
    CHECK_OK(nurbs_from_homogeneous(h, &k));
    CHECK_WEIGHTS(k, circle().weights);
    nurbs_destroy(g);
    nurbs_destroy(h);
    nurbs_destroy(k);
    g = make(arch());
    CHECK_OK(nurbs_from_homogeneous(g, &h)); /* weights 0, 2, 2, 0 */
    nurbs_destroy(h);
    nurbs_destroy(g);
    SplineArgs flat = arch();
    flat.points = VALUES(0, 0, 1, 0, 3, 0, 4, 0);
    g = make(flat);
    CHECK_NO_HANDLE(h, nurbs_from_homogeneous(g, &h), NURBS_ERROR_WEIGHTS_VANISH, "weight");
    nurbs_destroy(g);
}

int main(void) {
    reversal();
    transposition();
    other_domains();
    extreme_domains();
    rational_forms();
    return check_summary("forms");
}
