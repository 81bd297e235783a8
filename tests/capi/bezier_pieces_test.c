/* SPDX-License-Identifier: MIT */
/* nurbs_bezier_pieces(). */
#include "check.h"
#include "shapes.h"

#include <stdint.h>

#define VALUES(...) ((const double[]){__VA_ARGS__})

static double points[64], weights[32], domains[32];
static int64_t along[3], count;

static void clear(void) {
    FILL(points);
    FILL(weights);
    FILL(domains);
    FILL(along);
    memset(&count, 0x5a, sizeof count);
}

#define REFUSE(call, status, words)                                                                          \
    do {                                                                                                     \
        clear();                                                                                             \
        CHECK_FAILS(call, status, words);                                                                    \
        CHECK_UNTOUCHED(points);                                                                             \
        CHECK_UNTOUCHED(weights);                                                                            \
        CHECK_UNTOUCHED(domains);                                                                            \
        CHECK_UNTOUCHED(along);                                                                              \
        check_untouched(__FILE__, __LINE__, &count, sizeof count);                                           \
    } while (0)

static nurbs_status pieces(const nurbs *g, int64_t cap) {
    return nurbs_bezier_pieces(g, cap, points, weights, domains, along, &count);
}

/* Q_0 = (P_0 + P_1) / 2, Q_1 = P_1, Q_2 = (P_1 + P_2) / 2 on every span of uniform knots of degree 2. */
static void uniform(void) {
    nurbs *g = make(hill());
    clear();
    CHECK_OK(pieces(g, 3));
    CHECK_INT(count, 3);
    CHECK_INT(along[0], 3);
    CHECK_DOUBLES(points, VALUES(1, 2, 3, 3, 4, 3, 3, 2, 1), 9);
    CHECK_DOUBLES(weights, VALUES(1, 1, 1, 1, 1, 1, 1, 1, 1), 9);
    CHECK_DOUBLES(domains, VALUES(2, 3, 3, 4, 4, 5), 6);
    check_untouched(__FILE__, __LINE__, points + 9, sizeof points - 9 * sizeof *points);
    check_untouched(__FILE__, __LINE__, along + 1, sizeof along - sizeof *along);
    nurbs_destroy(g);
}

/* Around the square, the last piece ends where the first begins. */
static void periodic(void) {
    nurbs *g = make(loop());
    CHECK_OK(pieces(g, 4));
    CHECK_INT(count, 4);
    CHECK_DOUBLES(points, VALUES(0, 1, -1, 1, -1, 0, -1, 0, -1, -1, 0, -1), 12);
    CHECK_DOUBLES(points + 18, VALUES(1, 0, 1, 1, 0, 1), 6);
    nurbs_destroy(g);
}

static void rational(void) {
    nurbs *g = make(circle());
    CHECK_OK(pieces(g, 4));
    CHECK_DOUBLES(points + 6, VALUES(0, 1, -1, 1, -1, 0), 6);
    CHECK_DOUBLES(weights + 9, VALUES(1, HALF_ROOT, 1), 3);
    CHECK_DOUBLES(domains + 6, VALUES(0.75, 1), 2);
    nurbs_destroy(g);
}

/* Homogeneous points are divided; one at infinity stays there. */
static void homogeneous(void) {
    static const int32_t degree = 2;
    static const int64_t layers = 3;
    nurbs *g = NULL;
    CHECK_OK(nurbs_create_homogeneous(1, &degree, &layers, VALUES(0, 0, 0, 1, 1, 1), 6, 1,
                                      VALUES(2, 2, 3, 0, -4, 2), 0, 0, 0, &g));
    CHECK_OK(pieces(g, 1));
    CHECK_DOUBLES(points, VALUES(1, INFINITY, -2), 3);
    CHECK_DOUBLES(weights, VALUES(2, 0, 2), 3);
    nurbs_destroy(g);
}

/* The two sides of a jump, and degree 0. */
static void jumps(void) {
    nurbs *g = make(jump());
    CHECK_OK(pieces(g, 2));
    CHECK_DOUBLES(points, VALUES(0, 1, 5, 6), 4);
    nurbs_destroy(g);
    g = make(stairs());
    CHECK_OK(pieces(g, 3));
    CHECK_DOUBLES(points, VALUES(10, 20, 30), 3);
    CHECK_DOUBLES(domains, VALUES(0, 1, 1, 2, 2, 3), 6);
    nurbs_destroy(g);
}

/* Three pieces along v: the six points of each come together. */
static void surface(void) {
    nurbs *g = make(trough());
    CHECK_OK(pieces(g, 3));
    CHECK_INT(count, 3);
    CHECK_INT(along[0], 1);
    CHECK_INT(along[1], 3);
    CHECK_DOUBLES(points + 18, VALUES(0, 1, 1, 0, 2, 2, 0.5, 1, 1, 0.5, 2, 2, 1, 1, 2, 1, 2, 3), 18);
    CHECK_DOUBLES(domains + 4, VALUES(0, 1, 1, 2), 4);
    nurbs_destroy(g);
}

static void volume(void) {
    nurbs *g = make(cube()), *cut = NULL;
    CHECK_OK(nurbs_insert_knot(g, 2, 0.5, 1, &cut));
    CHECK_OK(pieces(cut, 2));
    CHECK_INT(count, 2);
    CHECK_INT(along[2], 2);
    CHECK_DOUBLES(points + 4 * 8, VALUES(0, 0, 0.5, 0, 0, 0, 1, 0, 0, 1, 0.5, 0), 12);
    CHECK_DOUBLES(domains + 6, VALUES(0, 1, 0, 1, 0.5, 1), 6);
    nurbs_destroy(g);
    nurbs_destroy(cut);
}

static void parts(const nurbs *g) {
    clear();
    CHECK_OK(nurbs_bezier_pieces(g, 0, points, weights, domains, along, &count));
    CHECK_INT(count, 4);
    CHECK_INT(along[0], 4);
    CHECK_UNTOUCHED(points);
    CHECK_UNTOUCHED(weights);
    CHECK_UNTOUCHED(domains);
    CHECK_OK(nurbs_bezier_pieces(g, 9, NULL, weights, NULL, NULL, &count));
    CHECK_DOUBLE(weights[10], HALF_ROOT);
    CHECK_OK(nurbs_bezier_pieces(g, 4, NULL, NULL, domains, NULL, &count));
    CHECK_DOUBLE(domains[7], 1);
    CHECK_OK(nurbs_bezier_pieces(g, 4, points, NULL, NULL, NULL, &count));
    CHECK_DOUBLE(points[23], 0);
}

static void bad_arguments(const nurbs *g) {
    int64_t *inside = (int64_t *)(void *)(points + 23);
    REFUSE(pieces(NULL, 4), NURBS_ERROR_NULL, "g");
    REFUSE(pieces(g, -1), NURBS_ERROR_COUNT, "cap|-1");
    REFUSE(pieces(g, INT64_MIN), NURBS_ERROR_COUNT, "cap");
    REFUSE(pieces(g, 3), NURBS_ERROR_SIZE, "cap|3|4");
    REFUSE(nurbs_bezier_pieces(g, 4, points, weights, domains, along, NULL), NURBS_ERROR_NULL, "count");
    REFUSE(nurbs_bezier_pieces(g, 4, points, points + 23, domains, along, &count), NURBS_ERROR_OVERLAP,
           "weights|points");
    REFUSE(nurbs_bezier_pieces(g, 4, points, weights, weights + 11, along, &count), NURBS_ERROR_OVERLAP,
           "domains|weights");
    REFUSE(nurbs_bezier_pieces(g, 4, points, weights, domains, inside, &count), NURBS_ERROR_OVERLAP,
           "piece_counts|points");
    REFUSE(nurbs_bezier_pieces(g, 4, points, weights, domains, along, inside), NURBS_ERROR_OVERLAP,
           "count|points");
    CHECK_OK(nurbs_bezier_pieces(g, 4, points, points + 24, domains, along, &count));
}

int main(void) {
    nurbs *g = make(circle());
    uniform();
    periodic();
    rational();
    homogeneous();
    jumps();
    surface();
    volume();
    parts(g);
    bad_arguments(g);
    nurbs_destroy(g);
    return check_summary("bezier_pieces");
}
