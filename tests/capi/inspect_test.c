/* SPDX-License-Identifier: MIT */
/* Getters of sizes, knots, forms, domains and Greville abscissae. */
#include "check.h"

#include "shapes.h"

#include <stdint.h>

static void sizes(SplineArgs a) {
    nurbs *g = make(a);
    int32_t axes = 0, dim = 0, degree = -1, rational = -1, homogeneous = -1;
    int64_t count = 0, total = 0, product = 1;
    CHECK_OK(nurbs_axes(g, &axes));
    CHECK_INT(axes, a.axes);
    CHECK_OK(nurbs_dimension(g, &dim));
    CHECK_INT(dim, a.dim);
    CHECK_OK(nurbs_is_rational(g, &rational));
    CHECK_INT(rational, a.weights != NULL);
    CHECK_OK(nurbs_is_homogeneous(g, &homogeneous));
    CHECK_INT(homogeneous, 0);
    for (int32_t k = 0; k < a.axes; ++k) {
        CHECK_OK(nurbs_degree(g, k, &degree));
        CHECK_INT(degree, a.degrees[k]);
        CHECK_OK(nurbs_count(g, k, &count));
        CHECK_INT(count, a.counts[k]);
        product *= count;
    }
    CHECK_OK(nurbs_point_count(g, &total));
    CHECK_INT(total, product);
    nurbs_destroy(g);
}

/* Weights that are all equal still are weights. */
static void equal_weights_are_rational(void) {
    static const double weights[] = {1, 1, 1, 1};
    int32_t rational = 0;
    SplineArgs a = arch();
    a.weights = weights;
    nurbs *g = make(a);
    CHECK_OK(nurbs_is_rational(g, &rational));
    CHECK_INT(rational, 1);
    nurbs_destroy(g);
}

static void forms(void) {
    const int32_t clamped = NURBS_FORM_CLAMPED_START | NURBS_FORM_CLAMPED_END;
    const SplineArgs shapes[] = {arch(), hill(), loop(), jump(), stairs()};
    const int32_t expected[] = {clamped, 0, NURBS_FORM_PERIODIC, clamped, clamped};
    static const double half_open[] = {2, 2, 2, 3, 4, 5, 6, 7}, half_closed[] = {0, 1, 2, 3, 4, 5, 5, 5};
    int32_t form = -1;
    for (int i = 0; i < 5; ++i) {
        nurbs *g = make(shapes[i]);
        CHECK_OK(nurbs_knot_form(g, 0, &form));
        CHECK_INT(form, expected[i]);
        nurbs_destroy(g);
    }
    SplineArgs a = hill();
    a.knots = half_open;
    nurbs *g = make(a);
    CHECK_OK(nurbs_knot_form(g, 0, &form));
    CHECK_INT(form, NURBS_FORM_CLAMPED_START);
    nurbs_destroy(g);
    a.knots = half_closed;
    g = make(a);
    CHECK_OK(nurbs_knot_form(g, 0, &form));
    CHECK_INT(form, NURBS_FORM_CLAMPED_END);
    nurbs_destroy(g);
}

static void domains(void) {
    static const double expected[] = {2, 5, 2, 6, 0, 3};
    const SplineArgs shapes[] = {hill(), loop(), stairs()};
    double domain[2];
    for (int i = 0; i < 3; ++i) {
        nurbs *g = make(shapes[i]);
        CHECK_OK(nurbs_domain(g, 0, domain));
        CHECK_DOUBLES(domain, expected + 2 * i, 2);
        nurbs_destroy(g);
    }
    nurbs *g = make(trough());
    CHECK_OK(nurbs_domain(g, 1, domain));
    CHECK_DOUBLES(domain, ((const double[]){0, 3}), 2);
    nurbs_destroy(g);
}

static void greville(void) {
    static const double arch_sites[] = {0, 1.0 / 3, 2.0 / 3, 1}, hill_sites[] = {1.5, 2.5, 3.5, 4.5, 5.5};
    static const double stairs_sites[] = {0.5, 1.5, 2.5}, jump_sites[] = {0, 1, 1, 2},
                        v_sites[] = {0, 1, 2, 3};
    double sites[5];
    nurbs *g = make(arch());
    CHECK_OK(nurbs_greville(g, 0, 4, sites));
    CHECK_NEAR(sites, arch_sites, 4, 0x1p-53);
    CHECK_DOUBLE(sites[0], 0);
    CHECK_DOUBLE(sites[3], 1);
    nurbs_destroy(g);
    g = make(hill());
    CHECK_OK(nurbs_greville(g, 0, 5, sites));
    CHECK_DOUBLES(sites, hill_sites, 5);
    nurbs_destroy(g);
    g = make(stairs());
    CHECK_OK(nurbs_greville(g, 0, 3, sites));
    CHECK_DOUBLES(sites, stairs_sites, 3);
    nurbs_destroy(g);
    g = make(jump());
    CHECK_OK(nurbs_greville(g, 0, 4, sites));
    CHECK_DOUBLES(sites, jump_sites, 4);
    nurbs_destroy(g);
    g = make(trough());
    CHECK_OK(nurbs_greville(g, 1, 4, sites));
    CHECK_DOUBLES(sites, v_sites, 4);
    nurbs_destroy(g);
}

static void distinct(void) {
    static const double expected[] = {0, 0.25, 0.5, 0.75, 1};
    static const int32_t times[] = {3, 2, 2, 2, 3};
    double knots[6];
    int32_t multiplicities[6];
    int64_t count = 0;
    nurbs *g = make(circle());
    CHECK_OK(nurbs_distinct_knots(g, 0, 0, NULL, NULL, &count));
    CHECK_INT(count, 5);
    FILL(knots);
    FILL(multiplicities);
    CHECK_OK(nurbs_distinct_knots(g, 0, 6, knots, multiplicities, &count));
    CHECK_BITS(knots, expected, sizeof expected);
    CHECK_BITS(multiplicities, times, sizeof times);
    check_untouched(__FILE__, __LINE__, knots + 5, sizeof *knots);
    check_untouched(__FILE__, __LINE__, multiplicities + 5, sizeof *multiplicities);
    FILL(knots);
    CHECK_OK(nurbs_distinct_knots(g, 0, 5, knots, NULL, &count));
    CHECK_BITS(knots, expected, sizeof expected);
    FILL(multiplicities);
    CHECK_OK(nurbs_distinct_knots(g, 0, 5, NULL, multiplicities, &count));
    CHECK_BITS(multiplicities, times, sizeof times);
    FILL(knots);
    FILL(multiplicities);
    count = -7;
    CHECK_FAILS(nurbs_distinct_knots(g, 0, 4, knots, multiplicities, &count), NURBS_ERROR_SIZE, "cap|4|5");
    CHECK_UNTOUCHED(knots);
    CHECK_UNTOUCHED(multiplicities);
    CHECK_INT(count, -7);
    CHECK_FAILS(nurbs_distinct_knots(g, 0, -1, knots, multiplicities, &count), NURBS_ERROR_COUNT, "cap|-1");
    CHECK_FAILS(nurbs_distinct_knots(g, 0, 5, knots, multiplicities, NULL), NURBS_ERROR_NULL, "count");
    CHECK_UNTOUCHED(knots);
    nurbs_destroy(g);
    g = make(hill());
    CHECK_OK(nurbs_distinct_knots(g, 0, 0, NULL, NULL, &count));
    CHECK_INT(count, 8);
    nurbs_destroy(g);
}

/* Every getter without a handle, and without a place for its result. */
static void null_arguments(void) {
    nurbs *g = make(arch());
    int32_t small = -7;
    int64_t large = -7;
    double values[8];
    FILL(values);
    CHECK_FAILS(nurbs_axes(NULL, &small), NURBS_ERROR_NULL, "g");
    CHECK_FAILS(nurbs_axes(g, NULL), NURBS_ERROR_NULL, "axes");
    CHECK_FAILS(nurbs_dimension(NULL, &small), NURBS_ERROR_NULL, "g");
    CHECK_FAILS(nurbs_dimension(g, NULL), NURBS_ERROR_NULL, "dim");
    CHECK_FAILS(nurbs_degree(NULL, 0, &small), NURBS_ERROR_NULL, "g");
    CHECK_FAILS(nurbs_degree(g, 0, NULL), NURBS_ERROR_NULL, "degree");
    CHECK_FAILS(nurbs_count(NULL, 0, &large), NURBS_ERROR_NULL, "g");
    CHECK_FAILS(nurbs_count(g, 0, NULL), NURBS_ERROR_NULL, "count");
    CHECK_FAILS(nurbs_point_count(NULL, &large), NURBS_ERROR_NULL, "g");
    CHECK_FAILS(nurbs_point_count(g, NULL), NURBS_ERROR_NULL, "count");
    CHECK_FAILS(nurbs_is_rational(NULL, &small), NURBS_ERROR_NULL, "g");
    CHECK_FAILS(nurbs_is_rational(g, NULL), NURBS_ERROR_NULL, "rational");
    CHECK_FAILS(nurbs_is_homogeneous(NULL, &small), NURBS_ERROR_NULL, "g");
    CHECK_FAILS(nurbs_is_homogeneous(g, NULL), NURBS_ERROR_NULL, "homogeneous");
    CHECK_FAILS(nurbs_knots(NULL, 0, 8, values), NURBS_ERROR_NULL, "g");
    CHECK_FAILS(nurbs_knots(g, 0, 8, NULL), NURBS_ERROR_NULL, "knots");
    CHECK_FAILS(nurbs_distinct_knots(NULL, 0, 0, NULL, NULL, &large), NURBS_ERROR_NULL, "g");
    CHECK_FAILS(nurbs_knot_form(NULL, 0, &small), NURBS_ERROR_NULL, "g");
    CHECK_FAILS(nurbs_knot_form(g, 0, NULL), NURBS_ERROR_NULL, "form");
    CHECK_FAILS(nurbs_domain(NULL, 0, values), NURBS_ERROR_NULL, "g");
    CHECK_FAILS(nurbs_domain(g, 0, NULL), NURBS_ERROR_NULL, "domain");
    CHECK_FAILS(nurbs_greville(NULL, 0, 4, values), NURBS_ERROR_NULL, "g");
    CHECK_FAILS(nurbs_greville(g, 0, 4, NULL), NURBS_ERROR_NULL, "abscissae");
    CHECK_INT(small, -7);
    CHECK_INT(large, -7);
    CHECK_UNTOUCHED(values);
    nurbs_destroy(g);
}

static void bad_axes(int32_t axis, const char *words) {
    nurbs *g = make(trough());
    int32_t small = -7;
    int64_t large = -7;
    double values[16];
    FILL(values);
    CHECK_FAILS(nurbs_degree(g, axis, &small), NURBS_ERROR_AXIS, words);
    CHECK_FAILS(nurbs_count(g, axis, &large), NURBS_ERROR_AXIS, words);
    CHECK_FAILS(nurbs_knots(g, axis, 6, values), NURBS_ERROR_AXIS, words);
    CHECK_FAILS(nurbs_distinct_knots(g, axis, 16, values, NULL, &large), NURBS_ERROR_AXIS, words);
    CHECK_FAILS(nurbs_knot_form(g, axis, &small), NURBS_ERROR_AXIS, words);
    CHECK_FAILS(nurbs_domain(g, axis, values), NURBS_ERROR_AXIS, words);
    CHECK_FAILS(nurbs_greville(g, axis, 4, values), NURBS_ERROR_AXIS, words);
    CHECK_INT(small, -7);
    CHECK_INT(large, -7);
    CHECK_UNTOUCHED(values);
    nurbs_destroy(g);
}

static void bad_lengths(void) {
    static const int64_t lengths[] = {5, 7, 0, -1, INT64_MAX, INT64_MIN};
    nurbs *g = make(trough());
    double values[16];
    FILL(values);
    for (int i = 0; i < 6; ++i) {
        CHECK_FAILS(nurbs_knots(g, 1, lengths[i], values), NURBS_ERROR_SIZE, "knot_count|6");
        CHECK_FAILS(nurbs_greville(g, 1, lengths[i], values), NURBS_ERROR_SIZE, "count|4");
    }
    CHECK_UNTOUCHED(values);
    nurbs_destroy(g);
}

int main(void) {
    const SplineArgs shapes[] = {arch(),   circle(), hill(),   loop(), jump(),
                                 stairs(), patch(),  trough(), cube()};
    for (int i = 0; i < 9; ++i) {
        sizes(shapes[i]);
    }
    equal_weights_are_rational();
    forms();
    domains();
    greville();
    distinct();
    null_arguments();
    bad_axes(2, "axis|2");
    bad_axes(-1, "axis|-1");
    bad_axes(INT32_MAX, "axis|2147483647");
    bad_axes(INT32_MIN, "axis|-2147483648");
    bad_lengths();
    return check_summary("inspect");
}
