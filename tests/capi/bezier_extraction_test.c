/* SPDX-License-Identifier: MIT */
/* nurbs_bezier_extraction(). */
#include "check.h"
#include "shapes.h"

#include <stdint.h>

static double operators[64], domains[16];
static int64_t firsts[8], count;

static void clear(void) {
    FILL(operators);
    FILL(domains);
    FILL(firsts);
    memset(&count, 0x5a, sizeof count);
}

#define REFUSE(call, status, words)                                                                          \
    do {                                                                                                     \
        clear();                                                                                             \
        CHECK_FAILS(call, status, words);                                                                    \
        CHECK_UNTOUCHED(operators);                                                                          \
        CHECK_UNTOUCHED(domains);                                                                            \
        CHECK_UNTOUCHED(firsts);                                                                             \
        check_untouched(__FILE__, __LINE__, &count, sizeof count);                                           \
    } while (0)

static nurbs_status extract(const nurbs *g, int32_t axis, int64_t cap) {
    return nurbs_bezier_extraction(g, axis, cap, operators, firsts, domains, &count);
}

/* Q_0 = (P_0 + P_1) / 2, Q_1 = P_1, Q_2 = (P_1 + P_2) / 2 on every span of uniform knots of degree 2. */
static void uniform(SplineArgs a, int64_t spans) {
    static const double matrix[] = {0.5, 0, 0, 0.5, 1, 0.5, 0, 0, 0.5};
    nurbs *g = make(a);
    clear();
    CHECK_OK(extract(g, 0, spans));
    CHECK_INT(count, spans);
    for (int64_t e = 0; e < spans; ++e) {
        CHECK_DOUBLES(operators + 9 * e, matrix, 9);
        CHECK_INT(firsts[e], e);
        CHECK_DOUBLES(domains + 2 * e, ((const double[]){2.0 + (double)e, 3.0 + (double)e}), 2);
    }
    check_untouched(__FILE__, __LINE__, operators + 9 * spans, sizeof(double) * (size_t)(64 - 9 * spans));
    nurbs_destroy(g);
}

/* Knots 0 0 0 1 2 2 2: the middle of the first piece's last leg is where the second begins. */
static void clamped(void) {
    static const int32_t degree = 2;
    static const int64_t points = 4;
    static const double knots[] = {0, 0, 0, 1, 2, 2, 2}, values[] = {0, 0, 0, 0};
    static const double first[] = {1, 0, 0, 0, 1, 0.5, 0, 0, 0.5}, second[] = {0.5, 0, 0, 0.5, 1, 0, 0, 0, 1};
    nurbs *g = NULL;
    CHECK_OK(nurbs_create(1, &degree, &points, knots, 7, 1, values, 0, 0, NULL, 0, 0, &g));
    CHECK_OK(extract(g, 0, 2));
    CHECK_DOUBLES(operators, first, 9);
    CHECK_DOUBLES(operators + 9, second, 9);
    nurbs_destroy(g);
}

/* Pieces that are Bezier already, a knot of multiplicity degree + 1, and degree 0. */
static void identities(SplineArgs a, int32_t axis, int64_t spans, int64_t step) {
    nurbs *g = make(a);
    const int32_t p = a.degrees[axis];
    CHECK_OK(extract(g, axis, 0));
    CHECK_INT(count, spans);
    CHECK_OK(extract(g, axis, spans));
    for (int64_t e = 0; e < spans; ++e) {
        CHECK_INT(firsts[e], e * step);
        for (int64_t i = 0; i < (p + 1) * (p + 1); ++i) {
            CHECK_DOUBLE(operators[e * (p + 1) * (p + 1) + i], i % (p + 2) == 0);
        }
    }
    nurbs_destroy(g);
}

static void parts(const nurbs *g) {
    clear();
    CHECK_OK(nurbs_bezier_extraction(g, 0, 0, operators, firsts, domains, &count));
    CHECK_UNTOUCHED(operators);
    CHECK_UNTOUCHED(firsts);
    CHECK_UNTOUCHED(domains);
    CHECK_OK(nurbs_bezier_extraction(g, 0, 7, NULL, firsts, NULL, &count));
    CHECK_INT(firsts[3], 6);
    check_untouched(__FILE__, __LINE__, firsts + 4, sizeof firsts - 4 * sizeof *firsts);
    CHECK_OK(nurbs_bezier_extraction(g, 0, 4, NULL, NULL, domains, &count));
    CHECK_DOUBLES(domains + 6, ((const double[]){0.75, 1}), 2);
    CHECK_OK(nurbs_bezier_extraction(g, 0, 4, operators, NULL, NULL, &count));
    CHECK_DOUBLE(operators[35], 1);
}

static void bad_arguments(const nurbs *g) {
    int64_t *inside = (int64_t *)(void *)(operators + 35);
    REFUSE(extract(NULL, 0, 4), NURBS_ERROR_NULL, "g");
    REFUSE(extract(g, -1, 4), NURBS_ERROR_AXIS, "axis|-1");
    REFUSE(extract(g, 1, 4), NURBS_ERROR_AXIS, "axis|1");
    REFUSE(extract(g, 0, -1), NURBS_ERROR_COUNT, "cap|-1");
    REFUSE(extract(g, 0, INT64_MIN), NURBS_ERROR_COUNT, "cap");
    REFUSE(extract(g, 0, 3), NURBS_ERROR_SIZE, "cap|3|4");
    REFUSE(nurbs_bezier_extraction(g, 0, 4, operators, firsts, domains, NULL), NURBS_ERROR_NULL, "count");
    REFUSE(nurbs_bezier_extraction(g, 0, 4, operators, inside, domains, &count), NURBS_ERROR_OVERLAP,
           "firsts|operators");
    REFUSE(nurbs_bezier_extraction(g, 0, 4, operators, firsts, operators + 30, &count), NURBS_ERROR_OVERLAP,
           "domains|operators");
    REFUSE(nurbs_bezier_extraction(g, 0, 4, operators, firsts, domains, inside), NURBS_ERROR_OVERLAP,
           "count|operators");
    CHECK_OK(
        nurbs_bezier_extraction(g, 0, 4, operators, (int64_t *)(void *)(operators + 36), domains, &count));
}

int main(void) {
    nurbs *g = make(circle());
    uniform(hill(), 3);
    uniform(loop(), 4);
    clamped();
    identities(circle(), 0, 4, 2);
    identities(jump(), 0, 2, 2);
    identities(stairs(), 0, 3, 1);
    identities(trough(), 1, 3, 1);
    identities(cube(), 2, 1, 1);
    parts(g);
    bad_arguments(g);
    nurbs_destroy(g);
    return check_summary("bezier_extraction");
}
