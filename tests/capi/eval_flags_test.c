/* SPDX-License-Identifier: MIT */
/* Every combination of evaluation flags, on clamped, unclamped, periodic and discontinuous curves, against
 * closed forms. */
#include "check.h"
#include "shapes.h"

/* Coordinate c of the polynomial piece that holds at t, t anywhere; `left` chooses the piece below a knot. */
typedef double (*Exact)(double t, int left, int c);

static double exact_arch(double t, int left, int c) {
    (void)left;
    return c == 0 ? t * (3 + t * (3 - 2 * t)) : 6 * t * (1 - t);
}

/* Piece number of t among `pieces` unit pieces that begin at `start`. */
static int piece(double t, double start, int pieces, int left) {
    double place = left ? ceil(t - start) - 1 : floor(t - start);
    return place < 0 ? 0 : place > pieces - 1 ? pieces - 1 : (int)place;
}

static double uniform_quadratic(const double *points, int dim, int pieces, double t, int left, int c) {
    int i = piece(t, 2, pieces, left);
    double s = t - 2 - i;
    const double *p = points + dim * i + c;
    return 0.5 * (1 - s) * (1 - s) * p[0] + (0.5 + s * (1 - s)) * p[dim] + 0.5 * s * s * p[2 * dim];
}

static double exact_hill(double t, int left, int c) {
    return uniform_quadratic(hill().points, 1, 3, t, left, c);
}

static double exact_loop(double t, int left, int c) {
    return uniform_quadratic(loop().points, 2, 4, t, left, c);
}

static double exact_jump(double t, int left, int c) {
    (void)c;
    return piece(t, 0, 2, left) == 0 ? t : 4 + t;
}

static double exact_stairs(double t, int left, int c) {
    (void)c;
    return 10.0 + 10.0 * piece(t, 0, 3, left);
}

typedef struct Model {
    SplineArgs args;
    Exact exact;
    double lower, upper;
} Model;

/* What the header says about one parameter: the status, and the value if there is one. */
static nurbs_status expected(const Model *m, double t, uint32_t flags, double *point) {
    const int left = (flags & NURBS_LEFT) != 0, nan = (flags & NURBS_NAN) != 0;
    const double length = m->upper - m->lower;
    nurbs_status status = NURBS_OK;
    if (isnan(t) || (isinf(t) && !(flags & NURBS_CLAMP))) {
        status = NURBS_ERROR_PARAMETER_NOT_FINITE;
    } else if ((t < m->lower || t > m->upper) && !(flags & (NURBS_CLAMP | NURBS_EXTRAPOLATE | NURBS_WRAP))) {
        status = NURBS_ERROR_OUTSIDE_DOMAIN;
    } else if (flags & NURBS_CLAMP) {
        t = fmin(fmax(t, m->lower), m->upper);
    } else if (flags & NURBS_WRAP) {
        t -= length * floor((t - m->lower) / length);
        t = left && t == m->lower ? m->upper : t;
    }
    for (int c = 0; c < m->args.dim; ++c) {
        point[c] = status == NURBS_OK ? m->exact(t, left, c) : NAN;
    }
    return nan ? NURBS_OK : status;
}

static void one_parameter(const Model *m, const nurbs *g, double t, uint32_t flags) {
    double point[2], wanted[2];
    nurbs_status status = expected(m, t, flags, wanted);
    FILL(point);
    int before = check_failures;
    if (status == NURBS_OK) {
        CHECK_OK(nurbs_eval(g, 1, &t, 0, 0, point, 0, 0, flags));
        /* dyadic parameters near the domain: sizes up to 64, a few roundings */
        CHECK_NEAR(point, wanted, m->args.dim, 64 * 8 * 0x1p-52);
    } else {
        CHECK_FAILS(nurbs_eval(g, 1, &t, 0, 0, point, 0, 0, flags), status, "params[0]");
        CHECK_UNTOUCHED(point);
    }
    if (check_failures != before) {
        fprintf(stderr, "    ... at %g with flags 0x%x on [%g, %g]\n", t, flags, m->lower, m->upper);
    }
}

static void every_combination(const Model *m) {
    static const uint32_t outside[] = {0, NURBS_CLAMP, NURBS_EXTRAPOLATE, NURBS_WRAP};
    static const double offsets[] = {-3.25, -1, -0.5, 0, 0.25, 1, 1.5, 2};
    nurbs *g = make(m->args);
    for (int mode = 0; mode < 4; ++mode) {
        for (int bits = 0; bits < 4; ++bits) {
            uint32_t flags = outside[mode] | (bits & 1 ? NURBS_LEFT : 0) | (bits & 2 ? NURBS_NAN : 0);
            for (int i = 0; i < 8; ++i) {
                one_parameter(m, g, m->lower + offsets[i], flags);
                one_parameter(m, g, m->upper + offsets[i], flags);
            }
            one_parameter(m, g, NAN, flags);
            one_parameter(m, g, INFINITY, flags);
            one_parameter(m, g, -INFINITY, flags);
        }
    }
    nurbs_destroy(g);
}

/* Infinite parameters under NURBS_CLAMP, and their refusal under the others, in one batch. */
static void infinities(void) {
    static const double params[] = {-INFINITY, 0.5, INFINITY};
    double points[6];
    nurbs *g = make(arch());
    CHECK_OK(nurbs_eval(g, 3, params, 0, 0, points, 0, 0, NURBS_CLAMP));
    CHECK_DOUBLES(points, ((const double[]){0, 0, 2, 1.5, 4, 0}), 6);
    CHECK_OK(nurbs_eval(g, 3, params, 0, 0, points, 0, 0, NURBS_NAN));
    CHECK_DOUBLES(points, ((const double[]){NAN, NAN, 2, 1.5, NAN, NAN}), 6);
    nurbs_destroy(g);
}

/* Each axis has its own flags. */
static void flags_of_axes(void) {
    static const double params[] = {2, -0.25};
    double point[3];
    nurbs *g = make(patch());
    CHECK_OK(nurbs_eval(g, 1, params, 0, 0, point, 0, 0, NURBS_CLAMP | NURBS_ON_AXIS(1, NURBS_WRAP)));
    CHECK_DOUBLES(point, ((const double[]){1, 0.75, 0.75}), 3);
    CHECK_OK(nurbs_eval(g, 1, params, 0, 0, point, 0, 0, NURBS_ON_ALL_AXES(2, NURBS_EXTRAPOLATE)));
    CHECK_DOUBLES(point, ((const double[]){2, -0.25, -0.5}), 3);
    CHECK_OK(nurbs_eval(g, 1, params, 0, 0, point, 0, 0, NURBS_CLAMP | NURBS_ON_AXIS(1, NURBS_NAN)));
    CHECK_DOUBLES(point, ((const double[]){NAN, NAN, NAN}), 3);
    FILL(point);
    CHECK_FAILS(nurbs_eval(g, 1, params, 0, 0, point, 0, 0, NURBS_CLAMP), NURBS_ERROR_OUTSIDE_DOMAIN,
                "params[0|-0.25");
    CHECK_FAILS(nurbs_eval(g, 1, params, 0, 0, point, 0, 0, NURBS_ON_AXIS(1, NURBS_CLAMP)),
                NURBS_ERROR_OUTSIDE_DOMAIN, "params[0|2");
    CHECK_UNTOUCHED(point);
    nurbs_destroy(g);
}

/* A jump in one direction of a surface, seen from either side on either axis. */
static void sides_of_a_surface(void) {
    static const int32_t degrees[] = {0, 1};
    static const int64_t counts[] = {2, 4};
    static const double knots[] = {0, 1, 2, 0, 0, 1, 1, 2, 2}, points[] = {0, 1, 5, 6, 10, 11, 15, 16};
    static const double params[] = {1, 1}, expected_values[] = {15, 5, 11, 1};
    SplineArgs a = {2, degrees, counts, knots, 9, 1, points, 0, 0, NULL, 0, 0};
    nurbs *g = make(a);
    for (uint32_t i = 0; i < 4; ++i) {
        double value = 0;
        uint32_t flags = (i & 1 ? NURBS_LEFT : 0) | (i & 2 ? NURBS_ON_AXIS(1, NURBS_LEFT) : 0);
        CHECK_OK(nurbs_eval(g, 1, params, 0, 0, &value, 0, 0, flags));
        CHECK_DOUBLE(value, expected_values[i]);
    }
    nurbs_destroy(g);
}

/* Parameters far away wrap without losing the place: 2^40 periods are exact in double precision. */
static void far_away(void) {
    double t = 2 + 4 * 0x1p40 + 1, point[2];
    nurbs *g = make(loop());
    CHECK_OK(nurbs_eval(g, 1, &t, 0, 0, point, 0, 0, NURBS_WRAP));
    CHECK_DOUBLES(point, ((const double[]){-1, 0}), 2);
    t = -1.7976931348623157e308;
    CHECK_OK(nurbs_eval(g, 1, &t, 0, 0, point, 0, 0, NURBS_WRAP));
    CHECK(fabs(point[0]) <= 1 && fabs(point[1]) <= 1);
    nurbs_destroy(g);
}

int main(void) {
    const Model models[] = {{arch(), exact_arch, 0, 1},
                            {hill(), exact_hill, 2, 5},
                            {loop(), exact_loop, 2, 6},
                            {jump(), exact_jump, 0, 2},
                            {stairs(), exact_stairs, 0, 3}};
    for (int i = 0; i < 5; ++i) {
        every_combination(models + i);
    }
    infinities();
    flags_of_axes();
    sides_of_a_surface();
    far_away();
    return check_summary("eval_flags");
}
