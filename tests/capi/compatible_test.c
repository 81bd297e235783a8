/* SPDX-License-Identifier: MIT */
/* nurbs_snap_knots() and nurbs_make_compatible(). */
#include "check.h"
#include "shapes.h"

#include <stdint.h>

#define VALUES(...) ((const double[]){__VA_ARGS__})

/* Degree 1 over [0, 1] with one knot inside. */
static nurbs *tent(double knot, double x0, double x1, double x2) {
    static const int32_t degree = 1;
    static const int64_t count = 3;
    const double knots[] = {0, 0, knot, 1, 1}, points[] = {x0, x1, x2};
    nurbs *g = NULL;
    CHECK_OK(nurbs_create(1, &degree, &count, knots, 5, 1, points, 0, 0, NULL, 0, 0, &g));
    return g;
}

static nurbs *entry(const nurbs_list *list, int64_t i) {
    nurbs *g = NULL;
    CHECK_OK(nurbs_list_get(list, i, &g));
    return g;
}

static void snapped(void) {
    static const int32_t degree = 1;
    static const int64_t count = 6;
    static const double knots[] = {0, 0, 0.25, 0.25, 0.5, 0.53125, 1, 1}, points[] = {0, 1, 1, 2, 3, 4};
    nurbs *g = NULL, *h = NULL;
    double deviation = -1;
    CHECK_OK(nurbs_create(1, &degree, &count, knots, 8, 1, points, 0, 0, NULL, 0, 0, &g));
    CHECK_OK(nurbs_snap_knots(g, 0, 0.03125, &deviation, &h));
    CHECK_KNOTS(h, 0, VALUES(0, 0, 0.25, 0.25, 0.5, 0.5, 1, 1));
    CHECK_POINTS(h, points);
    CHECK(deviation >= 1 && deviation < 1 + 1e-12); /* at 0.5 the limit from the right is 3 and was 2 */
    nurbs_destroy(h);
    CHECK_OK(nurbs_snap_knots(g, 0, 0.03, &deviation, &h));
    CHECK_KNOTS(h, 0, knots);
    CHECK_DOUBLE(deviation, 0);
    nurbs_destroy(h);
    CHECK_NO_HANDLE(h, nurbs_snap_knots(g, 0, -1, NULL, &h), NURBS_ERROR_TOLERANCE, "tolerance = -1");
    CHECK_NO_HANDLE(h, nurbs_snap_knots(g, 0, 1, NULL, &h), NURBS_ERROR_TOLERANCE, "tolerance = 1");
    CHECK_NO_HANDLE(h, nurbs_snap_knots(g, 0, NAN, NULL, &h), NURBS_ERROR_TOLERANCE, "tolerance = nan");
    CHECK_NO_HANDLE(h, nurbs_snap_knots(g, 1, 0, NULL, &h), NURBS_ERROR_AXIS, "axis = 1");
    CHECK_NO_HANDLE(h, nurbs_snap_knots(NULL, 0, 0, NULL, &h), NURBS_ERROR_NULL, "g");
    CHECK_FAILS(nurbs_snap_knots(g, 0, 0, NULL, NULL), NURBS_ERROR_NULL, "out");
    nurbs_destroy(g);
}

/* An end that is reached within the tolerance: knots outside the domain move too, those inside keep out. */
static void ends(void) {
    static const int32_t degree = 1;
    static const int64_t count = 2;
    static const double knots[] = {-0.0625, 0, 1, 1.5}, points[] = {1, 2};
    nurbs *g = NULL, *h = NULL;
    CHECK_OK(nurbs_create(1, &degree, &count, knots, 4, 1, points, 0, 0, NULL, 0, 0, &g));
    CHECK_OK(nurbs_snap_knots(g, 0, 0.125, NULL, &h));
    CHECK_KNOTS(h, 0, VALUES(0, 0, 1, 1.5));
    nurbs_destroy(h);
    nurbs_destroy(g);
}

/* Knots close to clamped ends are merged into them; the ends keep their points. */
static void slivers(void) {
    static const int32_t degree = 2;
    static const int64_t count = 6;
    static const double knots[] = {0, 0, 0, 0.0625, 0.5, 0.9375, 1, 1, 1}, points[] = {0, 1, 2, 3, 4, 5};
    nurbs *g = NULL, *plain = NULL, *h = NULL;
    nurbs_list *list = NULL;
    double deviation = -1, at_least = -1;
    CHECK_OK(nurbs_create(1, &degree, &count, knots, 9, 1, points, 0, 0, NULL, 0, 0, &g));
    CHECK_OK(nurbs_snap_knots(g, 0, 0.0625, &deviation, &h));
    CHECK_KNOTS(h, 0, VALUES(0, 0, 0, 0.5, 1, 1, 1));
    CHECK_POINTS(h, VALUES(0, 2, 3, 5));
    CHECK_OK(nurbs_deviation(g, h, &at_least, NULL));
    CHECK(at_least > 0.5 && deviation >= at_least && deviation <= 1 + 1e-12);
    const nurbs *splines[] = {h, g};
    CHECK_OK(nurbs_make_compatible(2, splines, 0.0625, 0, NULL, &list));
    plain = entry(list, 1);
    CHECK_KNOTS(plain, 0, VALUES(0, 0, 0, 0.5, 1, 1, 1));
    CHECK_POINTS(plain, VALUES(0, 2, 3, 5));
    nurbs_destroy(plain);
    nurbs_list_destroy(list);
    nurbs_destroy(h);
    nurbs_destroy(g);
}

/* Parts of lengths that are a few units of the smallest number round to the whole. */
static void smallest_domains(void) {
    static const double u = 0x1p-1074, points[] = {0, 1, 2, 3, 4, 5};
    const double knots[] = {0, 0, u, u, 2 * u, 2 * u, 3 * u, 3 * u, 3 * u, 3 * u};
    for (int32_t degree = 0; degree <= 3; ++degree) {
        const int64_t count = 9 - degree;
        const int64_t fewer = degree == 3 ? count : 6 - degree;
        nurbs *g = NULL, *finer = NULL, *h = NULL;
        nurbs_list *list = NULL;
        const double *own = degree == 3 ? knots : VALUES(0, u, 2 * u, 3 * u, 4 * u, 5 * u, 6 * u);
        CHECK_OK(nurbs_create(1, &degree, &fewer, own, fewer + degree + 1, 1, points, 0, 0, NULL, 0, 0, &g));
        CHECK_OK(nurbs_snap_knots(g, 0, 0.99, NULL, &h));
        double before[2], after[2];
        CHECK_OK(nurbs_domain(g, 0, before));
        CHECK_OK(nurbs_domain(h, 0, after));
        CHECK_DOUBLES(after, before, 2);
        CHECK_OK(nurbs_elevate(g, 0, 1, &finer));
        const nurbs *splines[] = {g, finer};
        CHECK_OK(nurbs_make_compatible(2, splines, 0.99, 0, NULL, &list));
        nurbs_list_destroy(list);
        nurbs_destroy(h);
        nurbs_destroy(finer);
        nurbs_destroy(g);
    }
}

/* Domains that agree but for rounding. */
static void near_domains(void) {
    static const int32_t degree = 1;
    static const int64_t count = 3;
    const double end = 1 + 0x1p-40, knots[] = {0, 0, end / 2, end, end}, points[] = {0, 1, 4};
    nurbs *a = tent(0.5, 0, 1, 0), *b = NULL, *h = NULL;
    nurbs_list *list = NULL;
    double deviation = -1;
    CHECK_OK(nurbs_create(1, &degree, &count, knots, 5, 1, points, 0, 0, NULL, 0, 0, &b));
    const nurbs *splines[] = {a, b};
    CHECK_FAILS(nurbs_make_compatible(2, splines, 0x1p-41, 0, NULL, &list), NURBS_ERROR_INCOMPATIBLE,
                "splines[1]|[0, 1]");
    CHECK_OK(nurbs_make_compatible(2, splines, 0x1p-39, 0, &deviation, &list));
    CHECK(deviation >= 6 * 0x1p-40 / end && deviation < 7 * 0x1p-40); /* a speed of 6 */
    h = entry(list, 1);
    CHECK_KNOTS(h, 0, VALUES(0, 0, 0.5, 1, 1));
    CHECK_POINTS(h, points);
    nurbs_destroy(h);
    nurbs_list_destroy(list);
    nurbs_destroy(a);
    nurbs_destroy(b);
}

static void compatible(void) {
    nurbs *a = tent(0.5, 0, 1, 0), *b = tent(0.25, 0, 1, 4), *c = make(arch()), *h = NULL;
    const nurbs *splines[] = {a, b, c};
    nurbs_list *list = NULL;
    double deviation = -1;
    CHECK_OK(nurbs_make_compatible(2, splines, 0, 0, &deviation, &list));
    CHECK_DOUBLE(deviation, 0);
    h = entry(list, 0);
    CHECK_KNOTS(h, 0, VALUES(0, 0, 0.25, 0.5, 1, 1));
    CHECK_POINTS(h, VALUES(0, 0.5, 1, 0));
    nurbs_destroy(h);
    h = entry(list, 1);
    CHECK_KNOTS(h, 0, VALUES(0, 0, 0.25, 0.5, 1, 1));
    CHECK_POINTS(h, VALUES(0, 1, 2, 4));
    nurbs_destroy(h);
    nurbs_list_destroy(list);
    CHECK_OK(nurbs_make_compatible(3, splines, 0, 0, NULL, &list)); /* degree 3, double knots */
    h = entry(list, 2);
    CHECK_KNOTS(h, 0, VALUES(0, 0, 0, 0, 0.25, 0.25, 0.25, 0.5, 0.5, 0.5, 1, 1, 1, 1));
    nurbs_destroy(h);
    nurbs_list_destroy(list);
    nurbs_destroy(b);
    splines[1] = b = tent(0.4375, 0, 1, 4); /* as often as 0.5, and the lower one */
    CHECK_OK(nurbs_make_compatible(2, splines, 0.0625, 0, &deviation, &list));
    CHECK(deviation > 0.1 && deviation < 0.25);
    h = entry(list, 0);
    CHECK_KNOTS(h, 0, VALUES(0, 0, 0.4375, 1, 1));
    CHECK_POINTS(h, VALUES(0, 1, 0));
    nurbs_destroy(h);
    nurbs_list_destroy(list);
    nurbs_destroy(a);
    nurbs_destroy(b);
    nurbs_destroy(c);
}

/* Domains within the tolerance are mapped, and the deviation says how far points may have moved. */
static void mapped_domains(void) {
    static const int32_t degree = 1;
    static const int64_t count = 2;
    nurbs *a = NULL, *b = NULL, *h = NULL;
    CHECK_OK(nurbs_create(1, &degree, &count, VALUES(0, 0, 1, 1), 4, 1, VALUES(0, 2), 0, 0, NULL, 0, 0, &a));
    CHECK_OK(nurbs_create(1, &degree, &count, VALUES(0, 0, 1.0625, 1.0625), 4, 1, VALUES(0, 2), 0, 0, NULL, 0,
                          0, &b));
    const nurbs *splines[] = {a, b};
    nurbs_list *list = NULL;
    double deviation = -1, before = 0, after = 0;
    CHECK_OK(nurbs_make_compatible(2, splines, 0.125, 0, &deviation, &list));
    h = entry(list, 1);
    CHECK_KNOTS(h, 0, VALUES(0, 0, 1, 1));
    CHECK_OK(nurbs_eval(b, 1, VALUES(1), 0, 0, &before, 0, 0, 0));
    CHECK_OK(nurbs_eval(h, 1, VALUES(1), 0, 0, &after, 0, 0, 0));
    CHECK(deviation >= after - before && deviation < 0.13); /* 2 / 1.0625 for each unit of the parameter */
    nurbs_destroy(h);
    nurbs_list_destroy(list);
    CHECK_FAILS(nurbs_make_compatible(2, splines, 0.03125, 0, NULL, &list), NURBS_ERROR_INCOMPATIBLE,
                "splines[1]|1.0625");
    nurbs_destroy(a);
    nurbs_destroy(b);
}

static void forms(void) {
    nurbs *a = make(loop()), *b = make(hill()), *c = make(circle()), *h = NULL;
    const nurbs *splines[] = {a, b, c};
    nurbs_list *list = NULL;
    int32_t form = -1, rational = 0;
    CHECK_OK(nurbs_make_compatible(3, splines, 0, NURBS_MAP_DOMAINS, NULL, &list));
    h = entry(list, 0); /* opened, and clamped as the ends of the others differ */
    CHECK_OK(nurbs_knot_form(h, 0, &form));
    CHECK_INT(form, NURBS_FORM_CLAMPED_START | NURBS_FORM_CLAMPED_END);
    CHECK_OK(nurbs_is_rational(h, &rational));
    CHECK_INT(rational, 1);
    nurbs_destroy(h);
    nurbs_list_destroy(list);
    splines[1] = a;
    CHECK_OK(nurbs_make_compatible(2, splines, 0, 0, NULL, &list));
    h = entry(list, 1);
    CHECK_KNOTS(h, 0, loop().knots);
    CHECK_OK(nurbs_knot_form(h, 0, &form));
    CHECK_INT(form, NURBS_FORM_PERIODIC);
    nurbs_destroy(h);
    nurbs_list_destroy(list);
    nurbs_destroy(a);
    nurbs_destroy(b);
    nurbs_destroy(c);
}

static void refusals(void) {
    nurbs *a = tent(0.5, 0, 1, 0), *b = make(hill()), *p = make(patch());
    const nurbs *splines[] = {a, b, NULL};
    nurbs_list *list = (nurbs_list *)(void *)check_poison();
    CHECK_FAILS(nurbs_make_compatible(2, splines, 0, 0, NULL, &list), NURBS_ERROR_INCOMPATIBLE,
                "splines[1]|[2, 5]|[0, 1]");
    CHECK(list == NULL);
    CHECK_FAILS(nurbs_make_compatible(3, splines, 0, 0, NULL, &list), NURBS_ERROR_NULL, "splines[2]");
    splines[1] = p;
    CHECK_FAILS(nurbs_make_compatible(2, splines, 0, 0, NULL, &list), NURBS_ERROR_INCOMPATIBLE,
                "splines[1]|2 axes");
    CHECK_FAILS(nurbs_make_compatible(0, splines, 0, 0, NULL, &list), NURBS_ERROR_COUNT, "count = 0");
    CHECK_FAILS(nurbs_make_compatible(1, NULL, 0, 0, NULL, &list), NURBS_ERROR_NULL, "splines");
    CHECK_FAILS(nurbs_make_compatible(1, splines, 2, 0, NULL, &list), NURBS_ERROR_TOLERANCE, "tolerance = 2");
    CHECK_FAILS(nurbs_make_compatible(1, splines, 0, 1, NULL, &list), NURBS_ERROR_FLAGS, "flags = 0x1");
    CHECK_FAILS(nurbs_make_compatible(1, splines, 0, 0, NULL, NULL), NURBS_ERROR_NULL, "out");
    nurbs_destroy(b);
    static const int32_t degree = 1;
    static const int64_t count = 5;
    static const double crowd[] = {0, 0, 0.375, 0.4375, 0.4375, 1, 1}, points[] = {0, 1, 2, 3, 4};
    CHECK_OK(nurbs_create(1, &degree, &count, crowd, 7, 1, points, 0, 0, NULL, 0, 0, &b));
    nurbs *h = NULL;
    CHECK_NO_HANDLE(h, nurbs_snap_knots(b, 0, 0.125, NULL, &h), NURBS_ERROR_MULTIPLICITY,
                    "0.4375|axis 0|2 times");
    splines[1] = b; /* its knots would be one that occurs three times */
    CHECK_FAILS(nurbs_make_compatible(2, splines, 0.125, 0, NULL, &list), NURBS_ERROR_MULTIPLICITY,
                "splines[1]|0.4375|axis 0");
    nurbs_destroy(a);
    nurbs_destroy(b);
    nurbs_destroy(p);
}

int main(void) {
    snapped();
    ends();
    slivers();
    smallest_domains();
    near_domains();
    compatible();
    mapped_domains();
    forms();
    refusals();
    return check_summary("compatible");
}
