/* SPDX-License-Identifier: MIT */
/* nurbs_split(), nurbs_extract(), nurbs_decompose(), nurbs_split_at_knots(), nurbs_clamp_ends() and
 * nurbs_move_seam(). */
#include "check.h"
#include "shapes.h"

#include <stdint.h>

#define VALUES(...) ((const double[]){__VA_ARGS__})

static void split(void) {
    nurbs *g = make(arch()), *a = NULL, *b = NULL;
    CHECK_OK(nurbs_split(g, 0, 0.5, &a, &b));
    CHECK_KNOTS(a, 0, VALUES(0, 0, 0, 0, 0.5, 0.5, 0.5, 0.5));
    CHECK_POINTS(a, VALUES(0, 0, 0.5, 1, 1.25, 1.5, 2, 1.5));
    CHECK_KNOTS(b, 0, VALUES(0.5, 0.5, 0.5, 0.5, 1, 1, 1, 1));
    CHECK_POINTS(b, VALUES(2, 1.5, 2.75, 1.5, 3.5, 1, 4, 0));
    nurbs_destroy(a);
    nurbs_destroy(b);
    CHECK_NO_HANDLE(b, nurbs_split(g, 0, 0.5, NULL, &b), NURBS_ERROR_NULL, "lower");
    CHECK_NO_HANDLE(a, nurbs_split(g, 0, 0.5, &a, NULL), NURBS_ERROR_NULL, "upper");
    CHECK_NO_HANDLE(a, nurbs_split(g, 0, 0.5, &a, &a), NURBS_ERROR_OVERLAP, "upper|lower");
    b = check_poison();
    CHECK_NO_HANDLE(a, nurbs_split(g, 0, 0, &a, &b), NURBS_ERROR_EMPTY_DOMAIN, "param = 0|end|[0, 1]");
    CHECK(b == NULL);
    CHECK_NO_HANDLE(a, nurbs_split(g, 0, 1, &a, &b), NURBS_ERROR_EMPTY_DOMAIN, "param = 1|end|[0, 1]");
    CHECK_NO_HANDLE(a, nurbs_split(g, 0, 1.5, &a, &b), NURBS_ERROR_OUTSIDE_DOMAIN, "param = 1.5|[0, 1]");
    CHECK_NO_HANDLE(a, nurbs_split(g, 0, NAN, &a, &b), NURBS_ERROR_PARAMETER_NOT_FINITE, "param = nan");
    CHECK_NO_HANDLE(a, nurbs_split(g, 1, 0.5, &a, &b), NURBS_ERROR_AXIS, "axis = 1");
    CHECK_NO_HANDLE(a, nurbs_split(NULL, 0, 0.5, &a, &b), NURBS_ERROR_NULL, "g");
    nurbs_destroy(g);
    g = make(jump()); /* each part has its own side of a jump */
    CHECK_OK(nurbs_split(g, 0, 1, &a, &b));
    CHECK_POINTS(a, VALUES(0, 1));
    CHECK_POINTS(b, VALUES(5, 6));
    nurbs_destroy(a);
    nurbs_destroy(b);
    nurbs_destroy(g);
}

static void extract(void) {
    nurbs *g = make(patch()), *h = NULL;
    CHECK_OK(nurbs_extract(g, VALUES(0.25, 0), VALUES(0.75, 0.5), &h));
    CHECK_POINTS(h, VALUES(0.25, 0, 0, 0.25, 0.5, 0.125, 0.75, 0, 0, 0.75, 0.5, 0.375));
    nurbs_destroy(h);
    CHECK_OK(nurbs_extract(g, VALUES(0, 0), VALUES(1, 1), &h));
    CHECK_POINTS(h, patch().points);
    nurbs_destroy(h);
    CHECK_NO_HANDLE(h, nurbs_extract(g, VALUES(0, 0.5), VALUES(1, 0.5), &h), NURBS_ERROR_EMPTY_DOMAIN,
                    "lower = 0.5|axis 1|upper = 0.5");
    CHECK_NO_HANDLE(h, nurbs_extract(g, VALUES(0.5, 0), VALUES(0.25, 1), &h), NURBS_ERROR_EMPTY_DOMAIN,
                    "axis 0");
    CHECK_NO_HANDLE(h, nurbs_extract(g, VALUES(0, -1), VALUES(1, 1), &h), NURBS_ERROR_OUTSIDE_DOMAIN,
                    "lower = -1|axis 1");
    CHECK_NO_HANDLE(h, nurbs_extract(g, VALUES(0, 0), VALUES(NAN, 1), &h), NURBS_ERROR_PARAMETER_NOT_FINITE,
                    "upper = nan|axis 0");
    CHECK_NO_HANDLE(h, nurbs_extract(g, NULL, VALUES(1, 1), &h), NURBS_ERROR_NULL, "lower");
    CHECK_NO_HANDLE(h, nurbs_extract(g, VALUES(0, 0), NULL, &h), NURBS_ERROR_NULL, "upper");
    CHECK_NO_HANDLE(h, nurbs_extract(NULL, VALUES(0, 0), VALUES(1, 1), &h), NURBS_ERROR_NULL, "g");
    CHECK_FAILS(nurbs_extract(g, VALUES(0, 0), VALUES(1, 1), NULL), NURBS_ERROR_NULL, "out");
    nurbs_destroy(g);
}

static void piece(const nurbs_list *list, int64_t index, const char *name, const double *knots,
                  const double *points) {
    char text[16];
    nurbs *h = NULL;
    CHECK_OK(nurbs_list_name(list, index, text, sizeof text, NULL));
    CHECK(strcmp(text, name) == 0);
    CHECK_OK(nurbs_list_get(list, index, &h));
    CHECK_KNOTS(h, 0, knots);
    CHECK_POINTS(h, points);
    nurbs_destroy(h);
}

static void lists(void) {
    nurbs *g = make(hill());
    nurbs_list *list = NULL;
    int64_t count = 0;
    CHECK_OK(nurbs_decompose(g, &list));
    CHECK_OK(nurbs_list_count(list, &count));
    CHECK_INT(count, 3);
    piece(list, 0, "0", VALUES(2, 2, 2, 3, 3, 3), VALUES(1, 2, 3));
    piece(list, 1, "1", VALUES(3, 3, 3, 4, 4, 4), VALUES(3, 4, 3));
    nurbs_list_destroy(list);
    CHECK_OK(nurbs_split_at_knots(g, 0, 1, &list)); /* smooth throughout: itself, unclamped as it is */
    CHECK_OK(nurbs_list_count(list, &count));
    CHECK_INT(count, 1);
    piece(list, 0, "0", hill().knots, hill().points);
    nurbs_list_destroy(list);
    list = (nurbs_list *)(void *)check_poison();
    CHECK_FAILS(nurbs_split_at_knots(g, 0, -1, &list), NURBS_ERROR_ORDER, "order = -1");
    CHECK(list == NULL);
    CHECK_FAILS(nurbs_split_at_knots(g, 1, 0, &list), NURBS_ERROR_AXIS, "axis = 1");
    CHECK_FAILS(nurbs_split_at_knots(NULL, 0, 0, &list), NURBS_ERROR_NULL, "g");
    CHECK_FAILS(nurbs_split_at_knots(g, 0, 0, NULL), NURBS_ERROR_NULL, "out");
    CHECK_FAILS(nurbs_decompose(NULL, &list), NURBS_ERROR_NULL, "g");
    CHECK_FAILS(nurbs_decompose(g, NULL), NURBS_ERROR_NULL, "out");
    nurbs_destroy(g);
    g = make(trough()); /* degree 1 along axis 1: a kink at every knot */
    CHECK_OK(nurbs_split_at_knots(g, 1, 1, &list));
    CHECK_OK(nurbs_list_count(list, &count));
    CHECK_INT(count, 3);
    nurbs_list_destroy(list);
    CHECK_OK(nurbs_decompose(g, &list));
    piece(list, 2, "0,2", VALUES(0, 0, 0, 1, 1, 1),
          VALUES(0, 2, 2, 0, 3, 3, 0.5, 2, 2, 0.5, 3, 3, 1, 2, 3, 1, 3, 4));
    nurbs_list_destroy(list);
    nurbs_destroy(g);
}

static void clamp(void) {
    nurbs *g = make(hill()), *h = NULL;
    CHECK_OK(nurbs_clamp_ends(g, 0, NURBS_FORM_CLAMPED_START | NURBS_FORM_CLAMPED_END, &h));
    CHECK_KNOTS(h, 0, VALUES(2, 2, 2, 3, 4, 5, 5, 5));
    CHECK_POINTS(h, VALUES(1, 2, 4, 2, 1));
    nurbs_destroy(h);
    CHECK_OK(nurbs_clamp_ends(g, 0, NURBS_FORM_CLAMPED_END, &h));
    CHECK_KNOTS(h, 0, VALUES(0, 1, 2, 3, 4, 5, 5, 5));
    nurbs_destroy(h);
    CHECK_NO_HANDLE(h, nurbs_clamp_ends(g, 0, 4, &h), NURBS_ERROR_FLAGS, "flags = 0x4");
    CHECK_NO_HANDLE(h, nurbs_clamp_ends(g, -1, 0, &h), NURBS_ERROR_AXIS, "axis = -1");
    CHECK_NO_HANDLE(h, nurbs_clamp_ends(NULL, 0, 0, &h), NURBS_ERROR_NULL, "g");
    CHECK_FAILS(nurbs_clamp_ends(g, 0, 0, NULL), NURBS_ERROR_NULL, "out");
    nurbs_destroy(g);
    g = make(loop());
    int32_t form = -1;
    CHECK_OK(nurbs_clamp_ends(g, 0, 0, &h));
    CHECK_OK(nurbs_knot_form(h, 0, &form));
    CHECK_INT(form, 0);
    CHECK_KNOTS(h, 0, loop().knots);
    CHECK_POINTS(h, loop().points);
    nurbs_destroy(h);
    nurbs_destroy(g);
}

static void seams(void) {
    nurbs *g = make(loop()), *h = NULL;
    CHECK_OK(nurbs_move_seam(g, 0, 3, &h));
    CHECK_KNOTS(h, 0, VALUES(1, 2, 3, 4, 5, 6, 7, 8, 9));
    CHECK_POINTS(h, VALUES(-1, 1, -1, -1, 1, -1, 1, 1, -1, 1, -1, -1));
    nurbs_destroy(h);
    CHECK_OK(nurbs_move_seam(g, 0, 4.5, &h));
    CHECK_KNOTS(h, 0, VALUES(3, 4, 4.5, 5, 6, 7, 8, 8.5, 9, 10));
    nurbs_destroy(h);
    CHECK_NO_HANDLE(h, nurbs_move_seam(g, 0, 7, &h), NURBS_ERROR_OUTSIDE_DOMAIN, "param = 7|[2, 6]");
    CHECK_NO_HANDLE(h, nurbs_move_seam(g, 0, NAN, &h), NURBS_ERROR_PARAMETER_NOT_FINITE, "param = nan");
    CHECK_NO_HANDLE(h, nurbs_move_seam(g, 1, 3, &h), NURBS_ERROR_AXIS, "axis = 1");
    CHECK_NO_HANDLE(h, nurbs_move_seam(NULL, 0, 3, &h), NURBS_ERROR_NULL, "g");
    CHECK_FAILS(nurbs_move_seam(g, 0, 3, NULL), NURBS_ERROR_NULL, "out");
    nurbs_destroy(g);
    g = make(hill());
    CHECK_NO_HANDLE(h, nurbs_move_seam(g, 0, 3, &h), NURBS_ERROR_NOT_PERIODIC, "axis 0");
    nurbs_destroy(g);
}

int main(void) {
    split();
    extract();
    lists();
    clamp();
    seams();
    return check_summary("parts");
}
