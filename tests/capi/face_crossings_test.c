/* SPDX-License-Identifier: MIT */
/* nurbs_face_create() with NURBS_CHECK_CROSSINGS: loops that cross are refused by name, those that touch are not. */
#include "faces.h"

typedef struct {
    const nurbs *surface;
    double tolerance;
    uint32_t flags;
} Rule;

/* Loops of one curve each, which are destroyed. */
static nurbs_status of_loops(Rule rule, int64_t loops, nurbs *const *curves, nurbs_face **out) {
    static const int64_t ones[] = {1, 1, 1, 1};
    const nurbs_status status =
        nurbs_face_create(rule.surface, loops, ones, (const nurbs *const *)curves, NULL, NULL, rule.tolerance,
                          rule.flags | NURBS_CHECK_CROSSINGS, NULL, out);
    for (int64_t i = 0; i < loops; ++i) {
        nurbs_destroy(curves[i]);
    }
    return status;
}

/* Of curves one after the other. */
static nurbs_status of_curves(Rule rule, int64_t count, nurbs *const *curves, nurbs_face **out) {
    const nurbs_status status =
        nurbs_face_create(rule.surface, 1, &count, (const nurbs *const *)curves, NULL, NULL, rule.tolerance,
                          rule.flags | NURBS_CHECK_CROSSINGS, NULL, out);
    for (int64_t i = 0; i < count; ++i) {
        nurbs_destroy(curves[i]);
    }
    return status;
}

#define LOOPS(...)                                                                                           \
    (int64_t)(sizeof((nurbs *[]){__VA_ARGS__}) / sizeof(nurbs *)), (nurbs *[]) {                             \
        __VA_ARGS__                                                                                          \
    }

static nurbs_face *out_;

#define CHECK_CROSSES(call, words) CHECK_NO_FACE(out_, call, NURBS_ERROR_CROSSING, words)
#define CHECK_FACE(call)                                                                                     \
    do {                                                                                                     \
        CHECK_OK(call);                                                                                      \
        nurbs_face_destroy(out_);                                                                            \
        out_ = NULL;                                                                                         \
    } while (0)

static nurbs *square_at(double u, double v, double size) {
    const double places[] = {u, v, u + size, v, u + size, v + size, u, v + size, u, v};
    return polyline(5, places);
}

#define POLYGON(...)                                                                                         \
    polyline((int64_t)(sizeof(VALUES(__VA_ARGS__)) / sizeof(double) / 2), VALUES(__VA_ARGS__))

static void loops_that_cross(Rule rule) {
    CHECK_CROSSES(of_loops(rule, LOOPS(square(0.125, 0.75), square(0.5, 0.875)), &out_),
                  "curve 0 of loop 0 at |crosses curve 0 of loop 1 at ");
    CHECK_CROSSES(
        of_loops(rule, LOOPS(circle_in_domain(0.5, 0.5, 0.25), circle_in_domain(0.75, 0.5, 0.125)), &out_),
        "loop 0|crosses|loop 1");
    /* A hole within, and one that crosses it. */
    CHECK_CROSSES(of_loops(rule, LOOPS(square(0.125, 0.875), square(0.25, 0.5), square(0.375, 0.75)), &out_),
                  "loop 1|crosses|loop 2");
    CHECK_FACE(of_loops(rule, LOOPS(square(0.125, 0.875), square(0.25, 0.5), square(0.625, 0.75)), &out_));
    CHECK_FACE(of_loops(rule, LOOPS(square(0.125, 0.875), square(0.25, 0.75), square(0.375, 0.5)), &out_));
    CHECK_FACE(
        of_loops(rule, LOOPS(circle_in_domain(0.5, 0.5, 0.25), circle_in_domain(0.5, 0.5, 0.125)), &out_));
    /* The whole boundary of the domain is outside of nothing. */
    CHECK_FACE(of_loops(rule, LOOPS(square(0, 1), square(0.25, 0.5)), &out_));
}

static void loops_that_cross_themselves(Rule rule) {
    /* Of equal lobes, so that it encloses nothing, and of others. */
    CHECK_CROSSES(
        of_loops(rule, LOOPS(POLYGON(0.25, 0.25, 0.75, 0.75, 0.75, 0.25, 0.25, 0.75, 0.25, 0.25)), &out_),
        "curve 0 of loop 0 at 0.5 crosses curve 0 of loop 0 at 2.5");
    CHECK_CROSSES(
        of_loops(rule, LOOPS(POLYGON(0.25, 0.25, 0.75, 0.75, 0.75, 0.5, 0.125, 0.75, 0.25, 0.25)), &out_),
        "curve 0 of loop 0 at |crosses curve 0 of loop 0 at ");
    CHECK_CROSSES(of_curves(rule,
                            LOOPS(segment(0.25, 0.25, 0.75, 0.75), segment(0.75, 0.75, 0.75, 0.25),
                                  segment(0.75, 0.25, 0.25, 0.75), segment(0.25, 0.75, 0.25, 0.25)),
                            &out_),
                  "curve 0 of loop 0 at 0.5 crosses curve 2 of loop 0 at 0.5");
    /* An inner curl is enclosed twice. */
    CHECK_CROSSES(of_loops(rule,
                           LOOPS(POLYGON(0.125, 0.125, 0.875, 0.125, 0.875, 0.75, 0.375, 0.75, 0.375, 0.25,
                                         0.625, 0.25, 0.625, 0.875, 0.125, 0.875, 0.125, 0.125)),
                           &out_),
                  "crosses");
}

/* Where no curve crosses another one between its ends. */
static void crossings_at_ends(Rule rule) {
    CHECK_CROSSES(of_curves(rule,
                            LOOPS(segment(0.25, 0.25, 0.5, 0.5), segment(0.5, 0.5, 0.75, 0.75),
                                  segment(0.75, 0.75, 0.75, 0.25), segment(0.75, 0.25, 0.5, 0.5),
                                  segment(0.5, 0.5, 0.125, 0.875), segment(0.125, 0.875, 0.25, 0.25)),
                            &out_),
                  "of loop 0 at |crosses");
    CHECK_FACE(of_curves(rule,
                         LOOPS(segment(0.25, 0.25, 0.5, 0.5), segment(0.5, 0.5, 0.75, 0.25),
                               segment(0.75, 0.25, 0.75, 0.75), segment(0.75, 0.75, 0.5, 0.5),
                               segment(0.5, 0.5, 0.25, 0.75), segment(0.25, 0.75, 0.25, 0.25)),
                         &out_));
    /* Two petals from one place, in one direction and in two. */
    CHECK_CROSSES(of_curves(rule,
                            LOOPS(POLYGON(0.5, 0.5, 0.75, 0.375, 0.75, 0.625, 0.5, 0.5),
                                  POLYGON(0.5, 0.5, 0.125, 0.375, 0.25, 0.625, 0.5, 0.5)),
                            &out_),
                  "crosses");
    CHECK_FACE(of_curves(rule,
                         LOOPS(POLYGON(0.5, 0.5, 0.75, 0.375, 0.75, 0.625, 0.5, 0.5),
                               POLYGON(0.5, 0.5, 0.25, 0.625, 0.25, 0.375, 0.5, 0.5)),
                         &out_));
    /* Through a corner, and from a corner to a side. */
    CHECK_CROSSES(
        of_loops(rule, LOOPS(square(0.25, 0.75), POLYGON(0.5, 0.5, 0.75, 0.25, 0.875, 0.5, 0.5, 0.5)), &out_),
        "crosses");
    CHECK_FACE(of_loops(rule, LOOPS(square(0.25, 0.75), POLYGON(0.5, 0.5, 0.75, 0.25, 0.625, 0.5, 0.5, 0.5)),
                        &out_));
}

static void loops_that_touch(Rule rule) {
    /* A corner on a side, a corner on a corner, circles from within and from outside. */
    CHECK_FACE(of_loops(
        rule, LOOPS(square(0.25, 0.75), POLYGON(0.5, 0.25, 0.625, 0.5, 0.375, 0.5, 0.5, 0.25)), &out_));
    CHECK_FACE(of_loops(
        rule, LOOPS(square(0.25, 0.75), POLYGON(0.25, 0.25, 0.625, 0.5, 0.5, 0.625, 0.25, 0.25)), &out_));
    CHECK_FACE(of_loops(rule, LOOPS(square(0.25, 0.5), square(0.5, 0.75)), &out_));
    CHECK_FACE(
        of_loops(rule, LOOPS(circle_in_domain(0.5, 0.5, 0.25), circle_in_domain(0.625, 0.5, 0.125)), &out_));
    CHECK_FACE(
        of_loops(rule, LOOPS(circle_in_domain(0.25, 0.5, 0.125), circle_in_domain(0.5, 0.5, 0.125)), &out_));
}

static void loops_that_run_along_each_other(Rule rule) {
    CHECK_CROSSES(of_loops(rule, LOOPS(square(0.25, 0.75), square_at(0.25, 0.375, 0.25)), &out_),
                  "curve 0 of loop 0 from |runs along curve 0 of loop 1 from ");
    CHECK_CROSSES(of_loops(rule, LOOPS(square_at(0.25, 0.25, 0.25), square_at(0.5, 0.25, 0.25)), &out_),
                  "runs along");
    CHECK_CROSSES(
        of_loops(rule, LOOPS(circle_in_domain(0.5, 0.5, 0.25), circle_in_domain(0.5, 0.5, 0.25)), &out_),
        "runs along");
    CHECK_CROSSES(of_loops(rule,
                           LOOPS(POLYGON(0.25, 0.25, 0.75, 0.25, 0.75, 0.75, 0.25, 0.75, 0.25, 0.25, 0.75,
                                         0.25, 0.75, 0.75, 0.25, 0.75, 0.25, 0.25)),
                           &out_),
                  "runs along");
    /* A cut from the outline to a hole, from the end of the curve, and within it. */
    CHECK_FACE(of_loops(rule,
                        LOOPS(POLYGON(0.125, 0.125, 0.875, 0.125, 0.875, 0.875, 0.125, 0.875, 0.125, 0.125,
                                      0.25, 0.25, 0.25, 0.5, 0.5, 0.5, 0.5, 0.25, 0.25, 0.25, 0.125, 0.125)),
                        &out_));
    CHECK_FACE(
        of_loops(rule,
                 LOOPS(POLYGON(0.875, 0.125, 0.875, 0.875, 0.125, 0.875, 0.125, 0.25, 0.25, 0.25, 0.25, 0.5,
                               0.5, 0.5, 0.5, 0.25, 0.25, 0.25, 0.125, 0.25, 0.125, 0.125, 0.875, 0.125)),
                 &out_));
}

/* What overlaps is 0.001 wide in the domain, 0.002 in space. */
static void the_tolerance(Rule rule) {
    for (int wide = 0; wide < 2; ++wide) {
        rule.tolerance = wide ? 0.003 : 0.0005;
        nurbs *const two[] = {circle_in_domain(0.25, 0.5, 0.125), square_at(0.374, 0.25, 0.5)};
        if (wide) {
            CHECK_FACE(of_loops(rule, 2, two, &out_));
        } else {
            CHECK_CROSSES(of_loops(rule, 2, two, &out_), "loop 0|loop 1");
        }
    }
}

static void segments_that_close_gaps(Rule rule) {
    rule.flags = NURBS_KEEP_GAPS;
    CHECK_CROSSES(
        of_loops(rule, LOOPS(POLYGON(0.125, 0.125, 0.875, 0.125, 0.875, 0.875), square(0.375, 0.625)), &out_),
        "a segment that closes a gap of loop 0 at |crosses|curve 0 of loop 1 at ");
    CHECK_FACE(of_loops(
        rule, LOOPS(POLYGON(0.125, 0.125, 0.875, 0.125, 0.875, 0.875), square_at(0.5, 0.25, 0.125)), &out_));
}

/* With holes that run as the outline does. */
static void loops_as_oriented(Rule rule) {
    rule.flags = NURBS_AS_ORIENTED;
    CHECK_NO_FACE(out_, of_loops(rule, LOOPS(square(0.125, 0.875), square_at(0.25, 0.25, 0.015625)), &out_),
                  NURBS_ERROR_ORIENTATION, "loop 1|left side");
    nurbs *hole = POLYGON(0.25, 0.25, 0.25, 0.5, 0.5, 0.5, 0.5, 0.25, 0.25, 0.25);
    CHECK_FACE(of_loops(rule, LOOPS(square(0.125, 0.875), hole), &out_));
}

static nurbs *made_cylinder(void) {
    nurbs *g = NULL;
    CHECK_OK(nurbs_surface_cylinder(NULL, NULL, NULL, 1, 2, 0, 2 * acos(-1.0), NURBS_ARC_QUARTERS, &g));
    return g;
}
static nurbs *made_sphere(void) {
    nurbs *g = NULL;
    CHECK_OK(nurbs_surface_sphere(NULL, NULL, NULL, 1, NURBS_ARC_QUARTERS, &g));
    return g;
}
static nurbs *made_torus(void) {
    nurbs *g = NULL;
    const double turn = 2 * acos(-1.0);
    CHECK_OK(nurbs_surface_torus(NULL, NULL, NULL, 3, 1, 0, turn, 0, turn, NURBS_ARC_QUARTERS, &g));
    return g;
}

/* The rectangle of two parts of the domain, as four segments. */
static nurbs_status create_rectangle(Rule rule, const double *u, const double *v) {
    return of_curves(rule,
                     LOOPS(segment(u[0], v[0], u[1], v[0]), segment(u[1], v[0], u[1], v[1]),
                           segment(u[1], v[1], u[0], v[1]), segment(u[0], v[1], u[0], v[0])),
                     &out_);
}

/* The loops of whole surfaces run along their seams twice, and through their poles. */
static void seams_and_poles(void) {
    nurbs *(*const makers[])(void) = {made_cylinder, made_sphere, made_torus};
    for (int i = 0; i < 3; ++i) {
        nurbs *surface = makers[i]();
        double u[2], v[2];
        CHECK_OK(nurbs_domain(surface, 0, u));
        CHECK_OK(nurbs_domain(surface, 1, v));
        const Rule rule = {surface, 1e-9, 0};
        CHECK_FACE(create_rectangle(rule, u, v));
        nurbs_destroy(surface);
    }
}

/* A hole across both sides of a seam, and one beside it. */
static void holes_in_whole_surfaces(void) {
    nurbs *surface = made_cylinder();
    double u[2], v[2];
    CHECK_OK(nurbs_domain(surface, 0, u));
    CHECK_OK(nurbs_domain(surface, 1, v));
    const double middle = v[0] / 2 + v[1] / 2, radius = 0.0625 * (u[1] - u[0]);
    for (int beside = 0; beside < 2; ++beside) {
        nurbs *curves[] = {segment(u[0], v[0], u[1], v[0]), segment(u[1], v[0], u[1], v[1]),
                           segment(u[1], v[1], u[0], v[1]), segment(u[0], v[1], u[0], v[0]),
                           circle_in_domain(u[0] + 2 * beside * radius, middle, radius)};
        const nurbs_status status = nurbs_face_create(surface, 2, SIZES(4, 1), (const nurbs *const *)curves,
                                                      NULL, NULL, 1e-9, NURBS_CHECK_CROSSINGS, NULL, &out_);
        CHECK_INT(status, beside ? NURBS_OK : NURBS_ERROR_CROSSING);
        nurbs_face_destroy(out_);
        for (int i = 0; i < 5; ++i) {
            nurbs_destroy(curves[i]);
        }
    }
    nurbs_destroy(surface);
}

/* Holes on both sides of the seam of a cylinder, which cross in another copy of the domain. */
static void copies_of_a_closed_axis(void) {
    nurbs *surface = made_cylinder();
    double u[2], v[2];
    CHECK_OK(nurbs_domain(surface, 0, u));
    CHECK_OK(nurbs_domain(surface, 1, v));
    const Rule rule = {surface, 1e-9, 0};
    const double radius = 0.0625 * (u[1] - u[0]), middle = v[0] / 2 + v[1] / 2;
    CHECK_CROSSES(of_loops(rule,
                           LOOPS(circle_in_domain(u[0] + radius / 2, middle, radius),
                                 circle_in_domain(u[1] - radius, middle, radius)),
                           &out_),
                  "loop 0|crosses|loop 1");
    CHECK_FACE(of_loops(rule,
                        LOOPS(circle_in_domain(u[0] + radius / 2, middle, radius),
                              circle_in_domain(u[1] - 2 * radius, middle, radius)),
                        &out_));
    /* One loop that is so long that it crosses itself. */
    const double most = u[1] + radius;
    CHECK_CROSSES(create_rectangle(rule, VALUES(u[0], most), VALUES(v[0] + radius, middle)), "loop 0");
    /* Around it, twice; once to and fro, so that it crosses the other one. */
    nurbs *lower = segment(u[0], v[0], u[1], v[0]), *upper = segment(u[1], middle, u[0], middle);
    CHECK_FACE(of_loops(rule, LOOPS(lower, upper), &out_));
    lower = segment(u[0], middle, u[1], middle);
    upper = POLYGON(u[1], v[1], (u[0] + u[1]) / 2, v[0], u[0], v[1]);
    CHECK_CROSSES(of_loops(rule, LOOPS(lower, upper), &out_), "loop 0|crosses|loop 1");
    nurbs_destroy(surface);
}

int main(void) {
    nurbs *surface = plane();
    const Rule rule = {surface, 1e-9, 0}, exact = {surface, 0, 0};
    loops_that_cross(rule);
    loops_that_cross(exact);
    loops_that_cross_themselves(rule);
    loops_that_cross_themselves(exact);
    crossings_at_ends(rule);
    crossings_at_ends(exact);
    loops_that_touch(rule);
    loops_that_touch(exact);
    loops_that_run_along_each_other(rule);
    loops_that_run_along_each_other(exact);
    the_tolerance(rule);
    segments_that_close_gaps(rule);
    loops_as_oriented(rule);
    seams_and_poles();
    holes_in_whole_surfaces();
    copies_of_a_closed_axis();
    nurbs_destroy(surface);
    return check_summary("face_crossings");
}
