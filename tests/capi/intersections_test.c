/* SPDX-License-Identifier: MIT */
/* Roots of scalar curves, and where curves meet lines, conics and quadrics: known ones, and what is refused. */
#include "shapes.h"

enum { most = 16 };

struct hits {
    double params[most], ranges[2 * most];
    int32_t kinds[most], complete;
    int64_t count;
};

static struct hits roots_of(const nurbs *g, double value, double tolerance) {
    struct hits h;
    CHECK_OK(nurbs_roots(g, value, tolerance, most, h.params, h.kinds, h.ranges, &h.count, &h.complete));
    return h;
}

static struct hits level_of(const nurbs *g, int32_t degree, const double *coefficients, double tolerance) {
    struct hits h;
    CHECK_OK(nurbs_curve_level(g, degree, coefficients, tolerance, most, h.params, h.kinds, h.ranges,
                               &h.count, &h.complete));
    return h;
}

static nurbs *scalar(int32_t degree, int64_t count, const double *knots, const double *values,
                     uint32_t flags) {
    nurbs *g = NULL;
    CHECK_OK(
        nurbs_create(1, &degree, &count, knots, count + degree + 1, 1, values, 0, 0, NULL, 0, flags, &g));
    return g;
}

static void expect(const struct hits *h, int64_t i, double at, int32_t kind) {
    CHECK(i < h->count);
    CHECK(fabs(h->params[i] - at) <= 1e-15);
    CHECK_INT(h->kinds[i], kind);
    CHECK(h->ranges[2 * i] <= h->params[i] && h->params[i] <= h->ranges[2 * i + 1]);
}

/* 4 (t - 1/4) (t - 3/4), over [0, 1]. */
static void a_parabola(void) {
    const double knots[] = {0, 0, 0, 1, 1, 1}, values[] = {0.75, -1.25, 0.75};
    nurbs *g = scalar(2, 3, knots, values, 0);
    struct hits h = roots_of(g, 0, 0);
    CHECK_INT(h.count, 2);
    CHECK_INT(h.complete, 1);
    expect(&h, 0, 0.25, NURBS_HIT_CROSSING);
    expect(&h, 1, 0.75, NURBS_HIT_CROSSING);
    CHECK(h.ranges[1] - h.ranges[0] < 1e-13);
    h = roots_of(g, -1, 0);
    CHECK_INT(h.count, 0);
    CHECK_INT(h.complete, 1);
    h = roots_of(g, -1, 0.26); /* the lowest value is -1/4 */
    CHECK_INT(h.count, 0);
    h = roots_of(g, -0.5, 0.3);
    CHECK_INT(h.count, 1);
    expect(&h, 0, 0.5, NURBS_HIT_CONTACT);
    h = roots_of(g, 0.75, 0); /* both ends, whose control points say so without rounding */
    CHECK_INT(h.count, 2);
    CHECK_INT(h.complete, 1);
    expect(&h, 0, 0, NURBS_HIT_CROSSING);
    expect(&h, 1, 1, NURBS_HIT_CROSSING);
    nurbs_destroy(g);
}

/* A touch is left open unless a tolerance is given; a third is no double. */
static void touches(void) {
    const double knots[] = {0, 0, 0, 3, 3, 3}, values[] = {1, -2, 4}; /* (t - 1)^2 over [0, 3] */
    nurbs *g = scalar(2, 3, knots, values, 0);
    struct hits h = roots_of(g, 0, 0);
    CHECK_INT(h.count, 1);
    CHECK_INT(h.complete, 0);
    CHECK_INT(h.kinds[0], NURBS_HIT_UNDECIDED);
    CHECK(h.ranges[0] <= 1 && 1 <= h.ranges[1]);
    h = roots_of(g, 0, 1e-12);
    CHECK_INT(h.count, 1);
    CHECK_INT(h.complete, 1);
    CHECK_INT(h.kinds[0], NURBS_HIT_TANGENT);
    CHECK(fabs(h.params[0] - 1) < 1e-7);
    h = roots_of(g, -1e-9, 1e-8);
    CHECK_INT(h.count, 1);
    CHECK_INT(h.kinds[0], NURBS_HIT_CONTACT);
    CHECK(fabs(h.params[0] - 1) < 1e-7);
    nurbs_destroy(g);
}

/* A polygon with values 1, 0, 1, -1, -1, 0 at 0 to 5: it touches at 1, crosses at 2.5 and ends at 0; it jumps where a knot is
 * doubled, and stays at 0 between others. */
static void knots(void) {
    const double line[] = {0, 0, 1, 2, 3, 4, 5, 5}, values[] = {1, 0, 1, -1, -1, 0};
    nurbs *g = scalar(1, 6, line, values, 0);
    struct hits h = roots_of(g, 0, 0);
    CHECK_INT(h.count, 3);
    CHECK_INT(h.complete, 1);
    expect(&h, 0, 1, NURBS_HIT_TANGENT);
    expect(&h, 1, 2.5, NURBS_HIT_CROSSING);
    expect(&h, 2, 5, NURBS_HIT_CROSSING);
    nurbs_destroy(g);
    const double broken[] = {0, 0, 1, 1, 2, 3, 4, 4}, steps[] = {1, 1, -1, 0, 0, 1};
    g = scalar(1, 6, broken, steps, 0);
    h = roots_of(g, 0, 0);
    CHECK_INT(h.count, 2);
    CHECK_INT(h.complete, 1);
    expect(&h, 0, 1, NURBS_HIT_JUMP);
    expect(&h, 1, 2.5, NURBS_HIT_OVERLAP);
    CHECK(h.ranges[2] == 2 && h.ranges[3] == 3);
    nurbs_destroy(g);
}

/* What lies behind a jump is found, with a tolerance too. */
static void jumps(void) {
    const double broken[] = {0, 0, 1, 1, 2, 3, 3}, values[] = {1, 1, -1, -0.05, -1};
    const double steps[] = {0, 1, 2, 3, 4}, low[] = {1, -1, -0.05, -1}, zero[] = {1, -1, 0, 1};
    nurbs *g = scalar(1, 5, broken, values, 0);
    struct hits h = roots_of(g, 0, 0.1);
    CHECK_INT(h.count, 2);
    expect(&h, 0, 1, NURBS_HIT_JUMP);
    expect(&h, 1, 2, NURBS_HIT_CONTACT);
    nurbs_destroy(g);
    g = scalar(0, 4, steps, low, 0);
    h = roots_of(g, 0, 0.1);
    CHECK_INT(h.count, 2);
    expect(&h, 0, 1, NURBS_HIT_JUMP);
    expect(&h, 1, 2.5, NURBS_HIT_OVERLAP);
    nurbs_destroy(g);
    g = scalar(0, 4, steps, zero, 0);
    h = roots_of(g, 0, 0.1);
    CHECK_INT(h.count, 2);
    expect(&h, 0, 1, NURBS_HIT_JUMP);
    expect(&h, 1, 2.5, NURBS_HIT_OVERLAP);
    nurbs_destroy(g);
}

/* Roots at the seam are given once. */
static void periods(void) {
    const double knots[] = {-1, 0, 1, 2, 3, 4, 5}, values[] = {0, 1, 0, -1, 0}; /* corners at 0 to 4 */
    nurbs *g = scalar(1, 5, knots, values, NURBS_PERIODIC);
    struct hits h = roots_of(g, 0, 0);
    CHECK_INT(h.count, 2);
    CHECK_INT(h.complete, 1);
    expect(&h, 0, 0, NURBS_HIT_CROSSING);
    expect(&h, 1, 2, NURBS_HIT_CROSSING);
    h = roots_of(g, 0, 0.125);
    CHECK_INT(h.count, 2);
    CHECK_INT(h.kinds[0], NURBS_HIT_CROSSING);
    nurbs_destroy(g);
    const double more[] = {-1, 0, 1, 2, 3, 4, 5, 6, 7},
                 round[] = {-0.0078125, 1, 0.0625, 1, 1, 1, -0.0078125};
    g = scalar(1, 7, more, round, NURBS_PERIODIC); /* near 0 around the seam, and at 2 */
    h = roots_of(g, 0, 0.125);
    CHECK_INT(h.count, 3);
    CHECK(h.params[0] < 0.01 && h.params[2] > 5.99);
    CHECK_INT(h.kinds[1], NURBS_HIT_CONTACT);
    CHECK(h.params[1] == 2);
    nurbs_destroy(g);
}

/* A roof whose ridge touches, and one whose end does: coordinates alone are compared without rounding. */
static void a_plane_at_control_points(void) {
    const double knots[] = {0, 0, 1, 2, 2}, roof[] = {-1, -1, 0, 0, 1, -1}, high[] = {0, 1, 0};
    const int32_t degree = 1;
    const int64_t count = 3;
    nurbs *g = NULL;
    CHECK_OK(nurbs_create(1, &degree, &count, knots, 5, 2, roof, 0, 0, NULL, 0, 0, &g));
    struct hits h = level_of(g, 1, high, 0);
    CHECK_INT(h.count, 1);
    expect(&h, 0, 1, NURBS_HIT_TANGENT);
    nurbs_destroy(g);
}

/* Steps of homogeneous points: 0.2 and 2, each with the weight 3; a distance is that of the points. */
static void weighted_steps(void) {
    const double knots[] = {0, 1, 2}, records[] = {0.6, 3, 6, 3}, axis[] = {1, 0};
    const int32_t degree = 0;
    const int64_t count = 2;
    nurbs *g = NULL;
    CHECK_OK(nurbs_create_homogeneous(1, &degree, &count, knots, 3, 1, records, 0, 0, 0, &g));
    struct hits h = level_of(g, 1, axis, 0.25);
    CHECK_INT(h.count, 1);
    expect(&h, 0, 0.5, NURBS_HIT_OVERLAP);
    h = level_of(g, 1, axis, 0.15);
    CHECK_INT(h.count, 0);
    nurbs_destroy(g);
}

/* A unit circle of four arcs, and what it meets. */
static void circles(void) {
    nurbs *g = NULL;
    const double center[] = {0, 0}, axis[] = {0.6, 0.8, 0}, high[] = {0, 1, -1}, away[] = {0, 1, -1.25};
    const double ellipse[] = {0.25, 0, 0, 4, 0, -1}, own[] = {1, 0, 0, 1, 0, -1};
    struct hits h;
    CHECK_OK(nurbs_curve_circle(2, center, NULL, NULL, 1, NURBS_ARC_QUARTERS, &g));
    h = level_of(g, 1, axis, 0);
    CHECK_INT(h.count, 2);
    CHECK_INT(h.complete, 1);
    CHECK_INT(h.kinds[0], NURBS_HIT_CROSSING);
    h = level_of(g, 1, high, 1e-9);
    CHECK_INT(h.count, 1);
    CHECK_INT(h.kinds[0], NURBS_HIT_TANGENT);
    h = level_of(g, 1, away, 0.25 + 1e-12);
    CHECK_INT(h.count, 1);
    h = level_of(g, 1, away, 0.2);
    CHECK_INT(h.count, 0);
    h = level_of(g, 2, ellipse, 0);
    CHECK_INT(h.count, 4);
    CHECK_INT(h.complete, 1);
    h = level_of(g, 2, own, 1e-12);
    CHECK_INT(h.count, 1);
    CHECK_INT(h.kinds[0], NURBS_HIT_OVERLAP);
    nurbs_destroy(g);
}

struct pair_hits {
    double a[most], b[most], ranges_a[2 * most], ranges_b[2 * most];
    int32_t kinds[most], complete;
    int64_t count;
};

static struct pair_hits meets(const nurbs *a, const nurbs *b, double tolerance) {
    struct pair_hits h;
    CHECK_OK(nurbs_curve_intersections(a, b, tolerance, most, h.a, h.b, h.kinds, h.ranges_a, h.ranges_b,
                                       &h.count, &h.complete));
    return h;
}

static nurbs *plane_curve(int32_t degree, const double *points, const double *weights) {
    const double knots[] = {0, 0, 1, 1}, more[] = {0, 0, 0, 1, 1, 1};
    const int64_t count = degree + 1;
    nurbs *g = NULL;
    CHECK_OK(nurbs_create(1, &degree, &count, degree == 1 ? knots : more, 2 * degree + 2, 2, points, 0, 0,
                          weights, 0, 0, &g));
    return g;
}

static void two_lines(void) {
    const double up[] = {0, 0, 1, 1}, down[] = {0, 1, 1, 0}, from_end[] = {1, 1, 2, 0},
                 from_middle[] = {0.5, 0.5, 1, 0};
    const double on[] = {0.5, 0.5, 2, 2}, back[] = {2, 2, 0.5, 0.5}, beside[] = {0, 1, 1, 2};
    nurbs *g = plane_curve(1, up, NULL), *b = plane_curve(1, down, NULL);
    struct pair_hits h = meets(g, b, 0);
    CHECK(h.count == 1 && h.complete == 1 && h.kinds[0] == NURBS_HIT_CROSSING);
    CHECK(h.a[0] == 0.5 && h.b[0] == 0.5);
    nurbs_destroy(b);
    b = plane_curve(1, from_end, NULL); /* at a control point of both */
    h = meets(g, b, 0);
    CHECK(h.count == 1 && h.complete == 1 && h.kinds[0] == NURBS_HIT_CROSSING);
    CHECK(h.a[0] == 1 && h.b[0] == 0);
    nurbs_destroy(b);
    b = plane_curve(1, from_middle, NULL); /* from a point that double precision cannot prove */
    h = meets(g, b, 0);
    CHECK(h.count == 1 && h.complete == 0 && h.kinds[0] == NURBS_HIT_UNDECIDED);
    h = meets(g, b, 1e-9);
    CHECK(h.count == 1 && h.complete == 1 && h.kinds[0] == NURBS_HIT_CROSSING);
    nurbs_destroy(b);
    b = plane_curve(1, on, NULL);
    h = meets(g, b, 1e-9);
    CHECK(h.count == 1 && h.complete == 1 && h.kinds[0] == NURBS_HIT_OVERLAP);
    CHECK(fabs(h.ranges_a[0] - 0.5) < 1e-8 && h.ranges_a[1] == 1 && h.ranges_b[0] == 0 &&
          fabs(h.ranges_b[1] - 1 / 3.0) < 1e-8);
    nurbs_destroy(b);
    b = plane_curve(1, back, NULL);
    h = meets(g, b, 1e-9);
    CHECK(h.count == 1 && h.kinds[0] == NURBS_HIT_OVERLAP && h.ranges_b[0] == 1 &&
          fabs(h.ranges_b[1] - 2 / 3.0) < 1e-8);
    nurbs_destroy(b);
    b = plane_curve(1, beside, NULL);
    h = meets(g, b, 0.1);
    CHECK(h.count == 0 && h.complete == 1);
    nurbs_destroy(b);
    nurbs_destroy(g);
}

/* y = x^2 over [-1, 1] and lines at heights 0, -1e-10, 1e-6. */
static void a_parabola_and_lines(void) {
    const double parabola[] = {-1, 1, 0, -1, 1, 1};
    double line[] = {-1, 0, 1, 0};
    nurbs *g = plane_curve(2, parabola, NULL), *b = plane_curve(1, line, NULL);
    struct pair_hits h = meets(g, b, 0);
    CHECK(h.count == 1 && h.complete == 0 && h.kinds[0] == NURBS_HIT_UNDECIDED);
    h = meets(g, b, 1e-9);
    CHECK(h.count == 1 && h.complete == 1 && h.kinds[0] == NURBS_HIT_TANGENT);
    CHECK(fabs(h.a[0] - 0.5) < 1e-7 && fabs(h.b[0] - 0.5) < 1e-7);
    nurbs_destroy(b);
    line[1] = line[3] = -1e-10;
    b = plane_curve(1, line, NULL);
    h = meets(g, b, 1e-9);
    CHECK(h.count == 1 && h.complete == 1 && h.kinds[0] == NURBS_HIT_CONTACT);
    h = meets(g, b, 0);
    CHECK(h.count == 0 && h.complete == 1);
    nurbs_destroy(b);
    line[1] = line[3] = 1e-6;
    b = plane_curve(1, line, NULL);
    h = meets(g, b, 1e-9);
    CHECK(h.count == 2 && h.complete == 1 && h.kinds[0] == NURBS_HIT_CROSSING &&
          h.kinds[1] == NURBS_HIT_CROSSING);
    CHECK(fabs(h.a[0] - 0.4995) < 1e-12 && fabs(h.a[1] - 0.5005) < 1e-12);
    nurbs_destroy(b);
    nurbs_destroy(g);
}

/* Circles that cross, touch from outside and inside at a knot, are apart, and are one. */
static void two_circles(void) {
    const double at[] = {0, 0}, over[] = {1.2, 0}, beside[] = {2, 0}, inner[] = {0.5, 0};
    nurbs *g = NULL, *b = NULL;
    struct pair_hits h;
    CHECK_OK(nurbs_curve_circle(2, at, NULL, NULL, 1, NURBS_ARC_QUARTERS, &g));
    CHECK_OK(nurbs_curve_circle(2, over, NULL, NULL, 1, NURBS_ARC_QUARTERS, &b));
    h = meets(g, b, 0);
    CHECK(h.count == 2 && h.complete == 1);
    nurbs_destroy(b);
    CHECK_OK(nurbs_curve_circle(2, beside, NULL, NULL, 1, NURBS_ARC_QUARTERS, &b));
    h = meets(g, b, 1e-9); /* at both ends of the first circle */
    CHECK(h.complete == 1 && h.count == 2 && h.kinds[0] == NURBS_HIT_TANGENT && h.a[0] == 0);
    nurbs_destroy(b);
    CHECK_OK(nurbs_curve_circle(2, inner, NULL, NULL, 0.25, NURBS_ARC_QUARTERS, &b));
    h = meets(g, b, 0.2);
    CHECK(h.count == 0 && h.complete == 1);
    h = meets(g, b, 0.25 + 1e-12);
    CHECK(h.complete == 1 && h.count >= 1);
    nurbs_destroy(b);
    CHECK_OK(nurbs_elevate(g, 0, 1, &b));
    h = meets(g, b, 1e-9);
    CHECK(h.complete == 1 && h.count == 3 &&
          h.kinds[1] == NURBS_HIT_OVERLAP); /* and each end on the other one */
    nurbs_destroy(b);
    nurbs_destroy(g);
}

/* From far above a place to far below it. */
static nurbs *line_in_space(double x, double y) {
    const double above[] = {x, y, 8}, below[] = {x, y, -8};
    nurbs *g = NULL;
    CHECK_OK(nurbs_curve_line(3, above, below, &g));
    return g;
}

/* The trough is (u, v, v + u^2): a line across it, one past it, one in it, and one that ends on it. */
static void a_line_and_a_surface(void) {
    const double on[] = {1, 0, 1}, off[] = {1, 3, 4}, up[] = {0.25, 1.5, 8}, end[] = {0.25, 1.5, 1.5625};
    nurbs *s = make(trough()), *across = line_in_space(0.25, 1.5), *past = line_in_space(1.25, 1.5),
          *in = NULL, *to = NULL;
    double t[2], uv[4], ranges_curve[4], ranges_surface[8];
    int32_t kinds[2], complete = -1;
    int64_t count = -1;
    CHECK_OK(nurbs_curve_line(3, on, off, &in));
    CHECK_OK(nurbs_curve_line(3, up, end, &to));
    CHECK_OK(nurbs_curve_surface_intersections(across, s, 0, 2, t, uv, kinds, ranges_curve, ranges_surface,
                                               &count, &complete));
    CHECK(count == 1 && complete == 1 && kinds[0] == NURBS_HIT_CROSSING);
    CHECK(fabs(t[0] - (8 - 1.5625) / 16) < 1e-14);
    CHECK(fabs(uv[0] - 0.25) < 1e-14 && fabs(uv[1] - 1.5) < 1e-14);
    CHECK(ranges_curve[0] <= t[0] && t[0] <= ranges_curve[1] && ranges_curve[1] - ranges_curve[0] < 1e-11);
    CHECK(ranges_surface[0] <= 0.25 && 0.25 <= ranges_surface[1]);
    CHECK(ranges_surface[2] <= 1.5 && 1.5 <= ranges_surface[3]);
    CHECK_OK(
        nurbs_curve_surface_intersections(past, s, 1e-3, 0, NULL, NULL, NULL, NULL, NULL, &count, &complete));
    CHECK(count == 0 && complete == 1);
    CHECK_OK(nurbs_curve_surface_intersections(in, s, 1e-9, 2, t, NULL, kinds, ranges_curve, ranges_surface,
                                               &count, NULL));
    CHECK(count == 1 && kinds[0] == NURBS_HIT_OVERLAP && ranges_curve[0] == 0 && ranges_curve[1] == 1);
    CHECK_OK(nurbs_curve_surface_intersections(to, s, 1e-9, 2, t, NULL, kinds, NULL, NULL, NULL, &complete));
    CHECK(t[0] == 1 && complete == 1 && kinds[0] == NURBS_HIT_CROSSING);
    CHECK_OK(nurbs_curve_surface_intersections(to, s, 0, 2, NULL, NULL, kinds, NULL, NULL, NULL, &complete));
    CHECK(complete == 0 && kinds[0] == NURBS_HIT_UNDECIDED);
    nurbs_destroy(to);
    nurbs_destroy(in);
    nurbs_destroy(past);
    nurbs_destroy(across);
    nurbs_destroy(s);
}

static void refused_surfaces(void) {
    nurbs *c = line_in_space(0.25, 1.5), *s = make(trough()), *flat = make(arch()), *plain = NULL;
    const double origin[] = {0, 0}, u[] = {1, 0}, v[] = {0, 1};
    double a[2], b[4], d[4], e[8];
    int32_t i[2], complete = 0;
    int64_t count = 0;
    FILL(a);
    FILL(b);
    FILL(d);
    FILL(e);
    FILL(i);
    CHECK_OK(nurbs_surface_plane(2, origin, u, v, &plain));
    CHECK_FAILS(nurbs_curve_surface_intersections(NULL, s, 0, 2, a, b, i, d, e, &count, &complete),
                NURBS_ERROR_NULL, "curve is NULL");
    CHECK_FAILS(nurbs_curve_surface_intersections(c, NULL, 0, 2, a, b, i, d, e, &count, &complete),
                NURBS_ERROR_NULL, "surface is NULL");
    CHECK_FAILS(nurbs_curve_surface_intersections(s, s, 0, 2, a, b, i, d, e, &count, &complete),
                NURBS_ERROR_AXES, "curve");
    CHECK_FAILS(nurbs_curve_surface_intersections(c, c, 0, 2, a, b, i, d, e, &count, &complete),
                NURBS_ERROR_AXES, "surface");
    CHECK_FAILS(nurbs_curve_surface_intersections(flat, s, 0, 2, a, b, i, d, e, &count, &complete),
                NURBS_ERROR_DIMENSION, "curve|dimension 2");
    CHECK_FAILS(nurbs_curve_surface_intersections(c, plain, 0, 2, a, b, i, d, e, &count, &complete),
                NURBS_ERROR_INCOMPATIBLE, "dimension");
    CHECK_FAILS(nurbs_curve_surface_intersections(c, s, -1, 2, a, b, i, d, e, &count, &complete),
                NURBS_ERROR_TOLERANCE, "tolerance = -1");
    CHECK_FAILS(nurbs_curve_surface_intersections(c, s, NAN, 2, a, b, i, d, e, &count, &complete),
                NURBS_ERROR_TOLERANCE, "tolerance");
    CHECK_FAILS(nurbs_curve_surface_intersections(c, s, 0, -1, a, b, i, d, e, &count, &complete),
                NURBS_ERROR_COUNT, "cap = -1");
    CHECK_FAILS(nurbs_curve_surface_intersections(c, s, 0, 2, a, b, i, d, b, &count, &complete),
                NURBS_ERROR_OVERLAP, "ranges_surface|params_surface");
    CHECK_FAILS(nurbs_curve_surface_intersections(c, s, 0, 2, a, a, i, d, e, &count, &complete),
                NURBS_ERROR_OVERLAP, "params_surface|params_curve");
    CHECK_UNTOUCHED(a);
    CHECK_UNTOUCHED(b);
    CHECK_UNTOUCHED(d);
    CHECK_UNTOUCHED(e);
    CHECK_UNTOUCHED(i);
    nurbs_destroy(plain);
    nurbs_destroy(flat);
    nurbs_destroy(s);
    nurbs_destroy(c);
}

/* The long forms answer alike, and at a limit of work with what is left open. */
static void watched(void) {
    const double knots[] = {0, 0, 0, 1, 1, 1}, values[] = {0.75, -1.25, 0.75}, plane[] = {0, 1, -0.5};
    nurbs *g = scalar(2, 3, knots, values, 0), *c = make(arch()), *other = NULL, *s = make(trough()),
          *space = line_in_space(0.25, 1.5);
    nurbs_call_options call;
    int64_t count = -1;
    int32_t complete = -1;
    CHECK_OK(nurbs_call_options_init(&call, sizeof call));
    CHECK_OK(nurbs_reverse(c, 0, 0, &other));
    CHECK_OK(nurbs_roots_with(g, 0, 0, 0, NULL, NULL, NULL, &count, &complete, &call));
    CHECK(count == 2 && complete == 1);
    CHECK_OK(nurbs_curve_level_with(c, 1, plane, 0, 0, NULL, NULL, NULL, &count, &complete, &call));
    CHECK(count == level_of(c, 1, plane, 0).count && complete == 1);
    CHECK_OK(nurbs_curve_intersections_with(c, other, 1e-9, 0, NULL, NULL, NULL, NULL, NULL, &count,
                                            &complete, &call));
    CHECK(count == meets(c, other, 1e-9).count && complete == 1);
    CHECK_OK(nurbs_curve_self_intersections_with(c, 1e-9, 0, NULL, NULL, NULL, NULL, NULL, &count, &complete,
                                                 &call));
    CHECK(count == 0 && complete == 1);
    CHECK_OK(nurbs_curve_surface_intersections_with(space, s, 0, 0, NULL, NULL, NULL, NULL, NULL, &count,
                                                    &complete, &call));
    CHECK(count == 1 && complete == 1);
    call.work = 1;
    CHECK_OK(nurbs_curve_surface_intersections_with(space, s, 0, 0, NULL, NULL, NULL, NULL, NULL, &count,
                                                    &complete, &call));
    CHECK(count == 1 && complete == 0);
    CHECK_OK(nurbs_roots_with(g, 0, 0, 0, NULL, NULL, NULL, &count, &complete, &call));
    CHECK_INT(complete, 0);
    CHECK_OK(nurbs_curve_level_with(c, 1, plane, 0, 0, NULL, NULL, NULL, &count, &complete, &call));
    CHECK_INT(complete, 0);
    CHECK_OK(nurbs_curve_intersections_with(c, other, 1e-9, 0, NULL, NULL, NULL, NULL, NULL, &count,
                                            &complete, &call));
    CHECK(count == 1 && complete == 0);
    CHECK_OK(nurbs_curve_self_intersections_with(c, 1e-9, 0, NULL, NULL, NULL, NULL, NULL, &count, &complete,
                                                 &call));
    CHECK(count == 1 && complete == 0);
    call.struct_size = 1;
    CHECK_FAILS(nurbs_roots_with(g, 0, 0, 0, NULL, NULL, NULL, &count, &complete, &call), NURBS_ERROR_OPTIONS,
                "struct_size");
    CHECK_FAILS(nurbs_curve_level_with(c, 1, plane, 0, 0, NULL, NULL, NULL, &count, &complete, &call),
                NURBS_ERROR_OPTIONS, "struct_size");
    CHECK_FAILS(nurbs_curve_intersections_with(c, other, 0, 0, NULL, NULL, NULL, NULL, NULL, &count,
                                               &complete, &call),
                NURBS_ERROR_OPTIONS, "struct_size");
    CHECK_FAILS(
        nurbs_curve_self_intersections_with(c, 0, 0, NULL, NULL, NULL, NULL, NULL, &count, &complete, &call),
        NURBS_ERROR_OPTIONS, "struct_size");
    CHECK_FAILS(nurbs_curve_surface_intersections_with(space, s, 0, 0, NULL, NULL, NULL, NULL, NULL, &count,
                                                       &complete, &call),
                NURBS_ERROR_OPTIONS, "struct_size");
    nurbs_destroy(s);
    nurbs_destroy(space);
    nurbs_destroy(other);
    nurbs_destroy(c);
    nurbs_destroy(g);
}

static struct pair_hits own_meets(const nurbs *g, double tolerance) {
    struct pair_hits h;
    CHECK_OK(nurbs_curve_self_intersections(g, tolerance, most, h.a, h.b, h.kinds, h.ranges_a, h.ranges_b,
                                            &h.count, &h.complete));
    return h;
}

static nurbs *polygon(int64_t count, const double *points) {
    double knots[32] = {0};
    const int32_t degree = 1;
    nurbs *g = NULL;
    for (int64_t i = 1; i <= count; ++i) {
        knots[i] = (double)(i < count ? i - 1 : count - 2);
    }
    knots[count + 1] = (double)(count - 1);
    knots[count] = (double)(count - 1);
    CHECK_OK(nurbs_create(1, &degree, &count, knots, count + 2, 2, points, 0, 0, NULL, 0, 0, &g));
    return g;
}

/* A bow that crosses itself, a polygon that closes and is simple, one that turns back on itself. */
static void self(void) {
    const double bow[] = {0, 0, 1, 1, 1, 0, 0, 1}, ring[] = {0, 0, 1, 0, 1, 1, 0, 0},
                 back[] = {0, 0, 2, 0, 1, 0};
    nurbs *g = polygon(4, bow);
    struct pair_hits h = own_meets(g, 0);
    CHECK(h.count == 1 && h.complete == 1 && h.kinds[0] == NURBS_HIT_CROSSING);
    CHECK(h.a[0] == 0.5 && h.b[0] == 2.5);
    nurbs_destroy(g);
    g = polygon(4, ring);
    h = own_meets(g, 0);
    CHECK(h.count == 0 && h.complete == 1);
    h = own_meets(g, 1e-6);
    CHECK(h.count == 0 && h.complete == 1);
    nurbs_destroy(g);
    g = polygon(3, back);
    h = own_meets(g, 1e-9);
    CHECK(h.count == 1 && h.complete == 1 && h.kinds[0] == NURBS_HIT_OVERLAP);
    CHECK(fabs(h.ranges_a[0] - 0.5) < 1e-8 && fabs(h.ranges_a[1] - 1) < 1e-8 && h.ranges_b[0] == 2 &&
          fabs(h.ranges_b[1] - 1) < 1e-8);
    h = own_meets(g, 0);
    CHECK(h.count == 1 && h.complete == 0 && h.kinds[0] == NURBS_HIT_UNDECIDED);
    nurbs_destroy(g);
}

static void refused_pairs(void) {
    nurbs *g = make(arch()), *s = make(trough()), *space = make(twist()), *other = NULL,
          *flat = scalar(2, 3, (const double[]){0, 0, 0, 1, 1, 1}, (const double[]){1, -2, 1}, 0),
          *bow = polygon(4, (const double[]){0, 0, 1, 1, 1, 0, 0, 1});
    double a[most], b[most], c[2 * most], d[2 * most];
    int32_t i[most], complete = 0;
    int64_t count = 0;
    FILL(a);
    FILL(b);
    FILL(c);
    FILL(d);
    FILL(i);
    CHECK_OK(nurbs_reverse(g, 0, 0, &other));
    CHECK_FAILS(nurbs_curve_intersections(NULL, g, 0, most, a, b, i, c, d, &count, &complete),
                NURBS_ERROR_NULL, "a is NULL");
    CHECK_FAILS(nurbs_curve_intersections(g, NULL, 0, most, a, b, i, c, d, &count, &complete),
                NURBS_ERROR_NULL, "b is NULL");
    CHECK_FAILS(nurbs_curve_intersections(s, g, 0, most, a, b, i, c, d, &count, &complete), NURBS_ERROR_AXES,
                "a");
    CHECK_FAILS(nurbs_curve_intersections(g, g, 0, most, a, b, i, c, d, &count, &complete), NURBS_ERROR_SAME,
                "a and b");
    CHECK_FAILS(nurbs_curve_intersections(flat, g, 0, most, a, b, i, c, d, &count, &complete),
                NURBS_ERROR_DIMENSION, "a|dimension 1");
    CHECK_FAILS(nurbs_curve_intersections(g, space, 0, most, a, b, i, c, d, &count, &complete),
                NURBS_ERROR_INCOMPATIBLE, "dimension");
    CHECK_FAILS(nurbs_curve_intersections(g, other, -1, most, a, b, i, c, d, &count, &complete),
                NURBS_ERROR_TOLERANCE, "tolerance = -1");
    CHECK_FAILS(nurbs_curve_intersections(g, other, NAN, most, a, b, i, c, d, &count, &complete),
                NURBS_ERROR_TOLERANCE, "tolerance");
    CHECK_FAILS(nurbs_curve_intersections(g, other, 1, -1, a, b, i, c, d, &count, &complete),
                NURBS_ERROR_COUNT, "cap = -1");
    CHECK_FAILS(nurbs_curve_intersections(g, other, 1e-9, most, a, a, i, c, d, &count, &complete),
                NURBS_ERROR_OVERLAP, "params_b|params_a");
    CHECK_FAILS(nurbs_curve_self_intersections(NULL, 0, most, a, b, i, c, d, &count, &complete),
                NURBS_ERROR_NULL, "g is NULL");
    CHECK_FAILS(nurbs_curve_self_intersections(s, 0, most, a, b, i, c, d, &count, &complete),
                NURBS_ERROR_AXES, "curve");
    CHECK_FAILS(nurbs_curve_self_intersections(flat, 0, most, a, b, i, c, d, &count, &complete),
                NURBS_ERROR_DIMENSION, "dimension 1");
    CHECK_FAILS(nurbs_curve_self_intersections(g, -1, most, a, b, i, c, d, &count, &complete),
                NURBS_ERROR_TOLERANCE, "tolerance = -1");
    CHECK_FAILS(nurbs_curve_self_intersections(g, 0, -1, a, b, i, c, d, &count, &complete), NURBS_ERROR_COUNT,
                "cap = -1");
    CHECK_FAILS(nurbs_curve_self_intersections(bow, 0, most, a, b, i, c, c, &count, &complete),
                NURBS_ERROR_OVERLAP, "ranges_b|ranges_a");
    CHECK_UNTOUCHED(a);
    CHECK_UNTOUCHED(b);
    CHECK_UNTOUCHED(c);
    CHECK_UNTOUCHED(d);
    CHECK_UNTOUCHED(i);
    nurbs_destroy(bow);
    nurbs_destroy(flat);
    nurbs_destroy(other);
    nurbs_destroy(space);
    nurbs_destroy(s);
    nurbs_destroy(g);
}

static void refused(void) {
    nurbs *g = make(arch()), *s = make(trough()), *line = NULL;
    const double knots[] = {0, 0, 0, 1, 1, 1}, values[] = {1, -2, 1};
    double own[most] = {0, 1, -0.5};
    const double plane[] = {1, 0, 0}, none[] = {0, 0, 1}, bad[] = {1, NAN, 0};
    double a[most], b[2 * most];
    int32_t i[most], complete = 0;
    int64_t count = 0;
    FILL(a);
    FILL(b);
    FILL(i);
    line = scalar(2, 3, knots, values, 0);
    CHECK_FAILS(nurbs_roots(NULL, 0, 0, most, a, i, b, &count, &complete), NURBS_ERROR_NULL, "g is NULL");
    CHECK_FAILS(nurbs_roots(s, 0, 0, most, a, i, b, &count, &complete), NURBS_ERROR_AXES, "curve");
    CHECK_FAILS(nurbs_roots(g, 0, 0, most, a, i, b, &count, &complete), NURBS_ERROR_DIMENSION, "dimension 2");
    CHECK_FAILS(nurbs_roots(line, NAN, 0, most, a, i, b, &count, &complete), NURBS_ERROR_POINT_NOT_FINITE,
                "value = ");
    CHECK_FAILS(nurbs_roots(line, 0, -1, most, a, i, b, &count, &complete), NURBS_ERROR_TOLERANCE,
                "tolerance = -1");
    CHECK_FAILS(nurbs_roots(line, 0, 0, -1, a, i, b, &count, &complete), NURBS_ERROR_COUNT, "cap = -1");
    CHECK_FAILS(nurbs_roots(line, 0, 0, 1, a, i, b, &count, &complete), NURBS_ERROR_SIZE, "cap = 1|2");
    CHECK_FAILS(nurbs_roots(line, 0, 0, 2, a, i, a + 1, &count, &complete), NURBS_ERROR_OVERLAP,
                "ranges|params");
    CHECK_FAILS(nurbs_curve_level(NULL, 1, plane, 0, most, a, i, b, &count, &complete), NURBS_ERROR_NULL,
                "g is NULL");
    CHECK_FAILS(nurbs_curve_level(s, 1, plane, 0, most, a, i, b, &count, &complete), NURBS_ERROR_AXES,
                "curve");
    CHECK_FAILS(nurbs_curve_level(g, 1, NULL, 0, most, a, i, b, &count, &complete), NURBS_ERROR_NULL,
                "coefficients");
    CHECK_FAILS(nurbs_curve_level(g, 0, plane, 0, most, a, i, b, &count, &complete), NURBS_ERROR_DEGREE,
                "degree = 0");
    CHECK_FAILS(nurbs_curve_level(g, 9, plane, 0, most, a, i, b, &count, &complete), NURBS_ERROR_DEGREE,
                "degree = 9");
    CHECK_FAILS(nurbs_curve_level(g, 1, none, 0, most, a, i, b, &count, &complete), NURBS_ERROR_DIRECTION,
                "all but the last of 3");
    CHECK_FAILS(nurbs_curve_level(g, 1, bad, 0, most, a, i, b, &count, &complete),
                NURBS_ERROR_POINT_NOT_FINITE, "coefficients[1]");
    CHECK_FAILS(nurbs_curve_level(g, 1, plane, NAN, most, a, i, b, &count, &complete), NURBS_ERROR_TOLERANCE,
                "tolerance");
    CHECK_FAILS(nurbs_curve_level(g, 1, plane, 0, -1, a, i, b, &count, &complete), NURBS_ERROR_COUNT, "cap");
    CHECK_FAILS(nurbs_curve_level(g, 1, own, 0, most, own, i, b, &count, &complete), NURBS_ERROR_OVERLAP,
                "params|coefficients");
    CHECK_UNTOUCHED(a);
    CHECK_UNTOUCHED(b);
    CHECK_UNTOUCHED(i);
    nurbs_destroy(line);
    nurbs_destroy(s);
    nurbs_destroy(g);
}

int main(void) {
    a_parabola();
    touches();
    knots();
    jumps();
    periods();
    a_plane_at_control_points();
    weighted_steps();
    circles();
    two_lines();
    a_parabola_and_lines();
    two_circles();
    self();
    a_line_and_a_surface();
    watched();
    refused_pairs();
    refused_surfaces();
    refused();
    return check_summary("intersections");
}
