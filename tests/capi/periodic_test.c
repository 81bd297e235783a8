/* SPDX-License-Identifier: MIT */
/* Axes declared periodic: what is accepted, what is refused, and what closes. */
#include "check.h"
#include "shapes.h"

#define REFUSE_ARGS(args, status, words)                                                                     \
    do {                                                                                                     \
        nurbs *out_;                                                                                         \
        CHECK_NO_HANDLE(out_, create(&(args), &out_), status, words);                                        \
    } while (0)

static void accepted(SplineArgs a, int32_t axis) {
    int32_t form = 0;
    nurbs *g = make(a);
    CHECK_OK(nurbs_knot_form(g, axis, &form));
    CHECK((form & NURBS_FORM_PERIODIC) != 0);
    nurbs_destroy(g);
}

static void knots_that_do_not_repeat(void) {
    SplineArgs a = loop();
    for (int i = 0; i < 9; ++i) {
        if (i == 2 || i == 6) {
            continue; /* an end of the domain: another period, which other knots break */
        }
        a.knots = edited(loop().knots, 9, i, loop().knots[i] + 0.125);
        REFUSE_ARGS(a, NURBS_ERROR_PERIODIC_KNOTS, "knots[");
    }
    a.knots = edited(loop().knots, 9, 8, 8.125);
    REFUSE_ARGS(a, NURBS_ERROR_PERIODIC_KNOTS, "knots[8] = 8.125|expected knots[4] + period = 8 on");
    a = arch();
    a.flags = NURBS_PERIODIC;
    REFUSE_ARGS(a, NURBS_ERROR_PERIODIC_KNOTS, "knots[");
}

/* Equal to within the rounding of the largest knot is enough: knots i / 10 are not exact. */
static void rounded_knots(void) {
    double knots[9];
    SplineArgs a = loop();
    for (int i = 0; i < 9; ++i) {
        knots[i] = 0.1 * i;
    }
    a.knots = knots;
    accepted(a, 0);
}

static void points_that_do_not_wrap(void) {
    SplineArgs a = loop();
    a.points = edited(loop().points, 12, 8, 1 + 0x1p-52);
    REFUSE_ARGS(a, NURBS_ERROR_PERIODIC_POINTS, "points[4|1.0000000000000002");
    a.points = edited(loop().points, 12, 11, -1);
    REFUSE_ARGS(a, NURBS_ERROR_PERIODIC_POINTS, "points[5|-1");
    a.points = edited(loop().points, 12, 5, 3); /* point 2 has no copy */
    accepted(a, 0);
}

static void weights_that_do_not_wrap(void) {
    static const double weights[] = {1, 2, 3, 4, 1, 2};
    SplineArgs a = loop();
    a.weights = weights;
    accepted(a, 0);
    a.weights = edited(weights, 6, 5, 2.5);
    REFUSE_ARGS(a, NURBS_ERROR_PERIODIC_POINTS, "weights[5|2.5");
}

/* Homogeneous records wrap whole. */
static void homogeneous_records(void) {
    static const double records[] = {1, 1, 1, -1, 1, 2, -1, -1, 1, 1, -1, 2, 1, 1, 1, -1, 1, 2};
    const SplineArgs a = loop();
    nurbs *g = NULL;
    CHECK_OK(
        nurbs_create_homogeneous(1, a.degrees, a.counts, a.knots, 9, 2, records, 0, 0, NURBS_PERIODIC, &g));
    nurbs_destroy(g);
    CHECK_NO_HANDLE(g,
                    nurbs_create_homogeneous(1, a.degrees, a.counts, a.knots, 9, 2,
                                             edited(records, 18, 17, 3), 0, 0, NURBS_PERIODIC, &g),
                    NURBS_ERROR_PERIODIC_POINTS, "points[5|3");
}

/* Vectors of nurbs_knots_periodic() and nurbs_knots_uniform() are accepted for what they are. */
static void generated_knots(void) {
    static const int32_t degree = 3;
    static const int64_t count = 9;
    static const double breaks[] = {0, 0.1, 0.4, 0.5, 0.8, 0.9, 1}, points[] = {1, 2, 3, 4, 5, 6, 1, 2, 3};
    double knots[13];
    nurbs *g = NULL;
    CHECK_OK(nurbs_knots_periodic(3, 7, breaks, NULL, 13, knots));
    CHECK_OK(nurbs_create(1, &degree, &count, knots, 13, 1, points, 0, 0, NULL, 0, NURBS_PERIODIC, &g));
    nurbs_destroy(g);
    CHECK_OK(nurbs_knots_uniform(3, 9, 0.1, 0.7, 13, knots));
    CHECK_OK(nurbs_create(1, &degree, &count, knots, 13, 1, points, 0, 0, NULL, 0, NURBS_PERIODIC, &g));
    nurbs_destroy(g);
}

/* Both axes of a torus-like surface, and each alone. */
static void surfaces(void) {
    static const int32_t degrees[] = {1, 2};
    static const int64_t counts[] = {4, 5};
    static const double knots[] = {0, 1, 2, 3, 4, 5, 0, 1, 2, 3, 4, 5, 6, 7};
    static const double points[] = {1, 2, 3, 1, 2, 4, 5, 6, 4, 5, 7, 8, 9, 7, 8, 1, 2, 3, 1, 2};
    SplineArgs a = {2,      degrees, counts, knots, 14, 1,
                    points, 0,       0,      NULL,  0,  NURBS_ON_ALL_AXES(2, NURBS_PERIODIC)};
    accepted(a, 0);
    accepted(a, 1);
    a.flags = NURBS_ON_AXIS(1, NURBS_PERIODIC);
    accepted(a, 1);
    a.points = edited(points, 20, 17, 3.5);
    accepted(a, 1);
    a.flags = NURBS_PERIODIC;
    REFUSE_ARGS(a, NURBS_ERROR_PERIODIC_POINTS, "points[17|3.5");
    a.points = edited(points, 20, 8, 4.5);
    accepted(a, 0);
    a.flags = NURBS_ON_AXIS(1, NURBS_PERIODIC);
    REFUSE_ARGS(a, NURBS_ERROR_PERIODIC_POINTS, "points[8|4.5");
}

/* Start and end give the same point and the same derivatives below the degree. */
static void it_closes(void) {
    static const double ends[] = {2, 6};
    double derivs[8];
    nurbs *g = make(loop());
    CHECK_OK(nurbs_eval_derivs(g, 1, 2, ends, 0, 0, derivs, 0, 0, 0));
    CHECK_DOUBLES(derivs, derivs + 4, 4);
    CHECK_OK(nurbs_eval_derivs(g, 1, 2, ends, 0, 0, derivs, 0, 0, NURBS_WRAP));
    CHECK_BITS(derivs, derivs + 4, 4 * sizeof *derivs);
    nurbs_destroy(g);
}

/* Without the flag the same data are a plain unclamped spline. */
static void not_declared(void) {
    SplineArgs a = loop();
    int32_t form = -1;
    a.flags = 0;
    nurbs *g = make(a);
    CHECK_OK(nurbs_knot_form(g, 0, &form));
    CHECK_INT(form, 0);
    nurbs_destroy(g);
}

int main(void) {
    accepted(loop(), 0);
    knots_that_do_not_repeat();
    rounded_knots();
    points_that_do_not_wrap();
    weights_that_do_not_wrap();
    homogeneous_records();
    generated_knots();
    surfaces();
    it_closes();
    not_declared();
    return check_summary("periodic");
}
