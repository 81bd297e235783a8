/* SPDX-License-Identifier: MIT */
/* nurbs_curve_eval_frames() and nurbs_curve_rotation_minimizing_frames(). */
#include "batch.h"
#include "check.h"
#include "shapes.h"

typedef struct Outputs {
    double *points, *tangents, *normals, *binormals, *curvatures, *torsions;
    int32_t *status;
} Outputs;

static nurbs_status frenet(const nurbs *g, int64_t n, const double *t, Outputs o, uint32_t flags) {
    return nurbs_curve_eval_frames(g, n, t, 0, o.points, 0, 0, o.tangents, 0, 0, o.normals, 0, 0, o.binormals,
                                   0, 0, o.curvatures, 0, o.torsions, 0, o.status, flags);
}

static nurbs_status minimal(const nurbs *g, int64_t n, const double *t, const double *first, Outputs o,
                            uint32_t flags) {
    return nurbs_curve_rotation_minimizing_frames(g, n, t, 0, first, o.points, 0, 0, o.tangents, 0, 0,
                                                  o.normals, 0, 0, o.binormals, 0, 0, o.status, flags);
}

/* Output `which` alone, in the common shape of batches; the strides of the others are bad and ignored. */
static nurbs_status one_of_frenet(int which, const nurbs *g, int64_t n, const double *t, int64_t ts,
                                  double *out, int64_t s, int64_t c, uint32_t flags) {
    double *o[6] = {NULL, NULL, NULL, NULL, NULL, NULL};
    int64_t stride[6] = {-1, -1, -1, -1, -1, -1}, component[6] = {-1, -1, -1, -1, -1, -1};
    o[which] = out;
    stride[which] = s;
    component[which] = c;
    return nurbs_curve_eval_frames(g, n, t, ts, o[0], stride[0], component[0], o[1], stride[1], component[1],
                                   o[2], stride[2], component[2], o[3], stride[3], component[3], o[4],
                                   stride[4], o[5], stride[5], NULL, flags);
}

static nurbs_status one_of_minimal(int which, const nurbs *g, int64_t n, const double *t, int64_t ts,
                                   double *out, int64_t s, int64_t c, uint32_t flags) {
    double *o[4] = {NULL, NULL, NULL, NULL};
    int64_t stride[4] = {-1, -1, -1, -1}, component[4] = {-1, -1, -1, -1};
    o[which] = out;
    stride[which] = s;
    component[which] = c;
    return nurbs_curve_rotation_minimizing_frames(g, n, t, ts, NULL, o[0], stride[0], component[0], o[1],
                                                  stride[1], component[1], o[2], stride[2], component[2],
                                                  o[3], stride[3], component[3], NULL, flags);
}

#define ADAPTER(name, function, which)                                                                       \
    static nurbs_status name(const nurbs *g, int64_t n, const double *t, int64_t ts, int64_t tc,             \
                             double *out, int64_t s, int64_t c, uint32_t flags) {                            \
        (void)tc;                                                                                            \
        return function(which, g, n, t, ts, out, s, c, flags);                                               \
    }
ADAPTER(frenet_points, one_of_frenet, 0)
ADAPTER(frenet_tangents, one_of_frenet, 1)
ADAPTER(frenet_normals, one_of_frenet, 2)
ADAPTER(frenet_binormals, one_of_frenet, 3)
ADAPTER(frenet_curvatures, one_of_frenet, 4)
ADAPTER(frenet_torsions, one_of_frenet, 5)
ADAPTER(minimal_points, one_of_minimal, 0)
ADAPTER(minimal_tangents, one_of_minimal, 1)
ADAPTER(minimal_normals, one_of_minimal, 2)
ADAPTER(minimal_binormals, one_of_minimal, 3)

/* C(t) = 3 (t, t^2, t^3) at 0. */
static void known_frame(void) {
    static const double start = 0;
    double p[3], t[3], n[3], b[3], curvature, torsion;
    int32_t status = -7;
    nurbs *g = make(twist());
    const Outputs all = {p, t, n, b, &curvature, &torsion, &status};
    const Outputs frame = {p, t, n, b, NULL, NULL, &status};
    CHECK_OK(frenet(g, 1, &start, all, 0));
    CHECK_DOUBLES(p, ((const double[]){0, 0, 0}), 3);
    CHECK_DOUBLES(t, ((const double[]){1, 0, 0}), 3);
    CHECK_DOUBLES(n, ((const double[]){0, 1, 0}), 3);
    CHECK_DOUBLES(b, ((const double[]){0, 0, 1}), 3);
    CHECK_NEAR(&curvature, ((const double[]){2.0 / 3}), 1, 0x1p-51);
    CHECK_DOUBLE(torsion, 1);
    CHECK_INT(status, 0);
    status = -7;
    CHECK_OK(minimal(g, 1, &start, ((const double[]){5, 0, -2}), frame, 0));
    CHECK_DOUBLES(t, ((const double[]){1, 0, 0}), 3);
    CHECK_DOUBLES(n, ((const double[]){0, 0, -1}), 3);
    CHECK_DOUBLES(b, ((const double[]){0, 1, 0}), 3);
    CHECK_INT(status, 0);
    CHECK_OK(frenet(g, 1, &start, ((Outputs){NULL, NULL, NULL, NULL, NULL, NULL, NULL}), 0));
    CHECK_OK(minimal(g, 1, &start, NULL, ((Outputs){NULL, NULL, NULL, NULL, NULL, NULL, NULL}), 0));
    nurbs_destroy(g);
}

static void in_the_plane(void) {
    static const double start = 0;
    double t[2], n[2], curvature, other[3];
    int32_t status = -7;
    nurbs *g = make(circle());
    FILL(other);
    CHECK_OK(frenet(g, 1, &start, ((Outputs){NULL, t, n, NULL, &curvature, NULL, &status}), 0));
    CHECK_DOUBLES(t, ((const double[]){0, 1}), 2);
    CHECK_DOUBLES(n, ((const double[]){-1, 0}), 2);
    CHECK_NEAR(&curvature, ((const double[]){1}), 1, 0x1p-49);
    CHECK_INT(status, 0);
    CHECK_FAILS(frenet(g, 1, &start, ((Outputs){NULL, NULL, NULL, other, NULL, NULL, NULL}), 0),
                NURBS_ERROR_DIMENSION, "binormals|NULL");
    CHECK_FAILS(frenet(g, 1, &start, ((Outputs){NULL, NULL, NULL, NULL, NULL, other, NULL}), 0),
                NURBS_ERROR_DIMENSION, "torsions|NULL");
    CHECK_FAILS(minimal(g, 1, &start, NULL, ((Outputs){other, NULL, NULL, NULL, NULL, NULL, NULL}), 0),
                NURBS_ERROR_DIMENSION, "dimension 2|3");
    CHECK_UNTOUCHED(other);
    nurbs_destroy(g);
}

static void wrong_kinds(void) {
    static const double params[] = {2.5, 2.5, 2.5};
    double out[6];
    const Outputs o = {out, NULL, NULL, NULL, NULL, NULL, NULL};
    nurbs *line = make(hill()), *surface = make(patch());
    FILL(out);
    CHECK_FAILS(frenet(line, 1, params, o, 0), NURBS_ERROR_DIMENSION, "dimension 1|2 or 3");
    CHECK_FAILS(frenet(surface, 1, params, o, 0), NURBS_ERROR_AXES, "curve|2");
    CHECK_FAILS(minimal(surface, 1, params, NULL, o, 0), NURBS_ERROR_AXES, "curve|2");
    CHECK_FAILS(minimal(line, 1, params, NULL, o, 0), NURBS_ERROR_DIMENSION, "dimension 1|3");
    CHECK_UNTOUCHED(out);
    nurbs_destroy(line);
    nurbs_destroy(surface);
}

static void overlaps(void) {
    static const double params[] = {0.25, 0.5};
    double a[32], in[8], normal[3] = {0, 0, 1};
    nurbs *g = make(twist());
    FILL(a);
    CHECK_FAILS(frenet(g, 2, params, ((Outputs){a, a + 5, NULL, NULL, NULL, NULL, NULL}), 0),
                NURBS_ERROR_OVERLAP, "tangents|points");
    CHECK_FAILS(frenet(g, 2, params, ((Outputs){NULL, NULL, a, a + 5, NULL, NULL, NULL}), 0),
                NURBS_ERROR_OVERLAP, "binormals|normals");
    CHECK_FAILS(frenet(g, 2, params, ((Outputs){NULL, NULL, NULL, NULL, a, a + 1, NULL}), 0),
                NURBS_ERROR_OVERLAP, "torsions|curvatures");
    CHECK_FAILS(frenet(g, 2, params, ((Outputs){NULL, NULL, NULL, NULL, NULL, a, (int32_t *)(void *)a}), 0),
                NURBS_ERROR_OVERLAP, "status|torsions");
    CHECK_FAILS(minimal(g, 2, params, NULL, ((Outputs){NULL, a, a + 5, NULL, NULL, NULL, NULL}), 0),
                NURBS_ERROR_OVERLAP, "normals|tangents");
    CHECK_FAILS(
        minimal(g, 2, params, NULL, ((Outputs){NULL, NULL, NULL, a, NULL, NULL, (int32_t *)(void *)a}), 0),
        NURBS_ERROR_OVERLAP, "status|binormals");
    CHECK_UNTOUCHED(a);
    CHECK_FAILS(minimal(g, 2, params, normal, ((Outputs){NULL, NULL, normal, NULL, NULL, NULL, NULL}), 0),
                NURBS_ERROR_OVERLAP, "normals|first_normal");
    CHECK_FAILS(minimal(g, 2, params, normal,
                        ((Outputs){NULL, NULL, NULL, NULL, NULL, NULL, (int32_t *)(void *)normal}), 0),
                NURBS_ERROR_OVERLAP, "status|first_normal");
    CHECK_DOUBLES(normal, ((const double[]){0, 0, 1}), 3);
    memcpy(in, params, sizeof params);
    CHECK_FAILS(frenet(g, 2, in, ((Outputs){NULL, NULL, NULL, NULL, NULL, NULL, (int32_t *)(void *)in}), 0),
                NURBS_ERROR_OVERLAP, "status|params");
    CHECK_FAILS(
        minimal(g, 2, in, NULL, ((Outputs){NULL, NULL, NULL, NULL, NULL, NULL, (int32_t *)(void *)in}), 0),
        NURBS_ERROR_OVERLAP, "status|params");
    nurbs_destroy(g);
}

static void first_normals(void) {
    static const double params[] = {0, 0.5}, spoilt[] = {0, 1.5};
    static const double bad[][3] = {{NAN, 0, 1}, {0, INFINITY, 1}, {0, 0, -INFINITY},
                                    {0, 0, 0},   {-0.0, 0, 0},     {1, 0, 0},
                                    {-5, 0, 0},  {1e-300, 0, 0},   {1, 1e-17, 0}};
    static const double good[][3] = {{0, 1e-300, 0}, {0, 1e300, 1e300}, {1, 1e-8, 0}};
    double out[6];
    int32_t status[2];
    const Outputs o = {NULL, NULL, out, NULL, NULL, NULL, status};
    nurbs *g = make(twist());
    FILL(out);
    FILL(status);
    for (size_t i = 0; i < sizeof bad / sizeof *bad; ++i) {
        CHECK_FAILS(minimal(g, 2, params, bad[i], o, 0), NURBS_ERROR_DIRECTION, "first_normal");
        if (i < 5) { /* bad without a tangent too */
            CHECK_FAILS(minimal(g, 0, NULL, bad[i], o, 0), NURBS_ERROR_DIRECTION, "first_normal");
        }
    }
    CHECK_FAILS(minimal(g, 2, spoilt, good[0], o, 0), NURBS_ERROR_OUTSIDE_DOMAIN, "params[1]");
    CHECK_UNTOUCHED(out);
    CHECK_UNTOUCHED(status);
    for (size_t i = 0; i < sizeof good / sizeof *good; ++i) {
        CHECK_OK(minimal(g, 2, params, good[i], o, 0));
        CHECK(fabs(hypot(out[0], hypot(out[1], out[2])) - 1) <= 0x1p-51);
        CHECK(fabs(out[0]) <= 0x1p-52);
    }
    nurbs_destroy(g);
}

/* A straight line: the rule, and its status. */
static void a_straight_line(void) {
    static const int32_t degree = 1;
    static const double points[] = {0, 0, 0, 0, 0, 2}, param = 0.5;
    double n[3], curvature, torsion;
    int32_t status;
    nurbs *g = NULL;
    CHECK_OK(nurbs_create_bezier(1, &degree, 3, points, 0, 0, NULL, 0, &g));
    CHECK_OK(frenet(g, 1, &param, ((Outputs){NULL, NULL, n, NULL, &curvature, &torsion, &status}), 0));
    CHECK_DOUBLES(n, ((const double[]){1, 0, 0}), 3);
    CHECK_DOUBLE(curvature, 0);
    CHECK_DOUBLE(torsion, 0);
    CHECK_INT(status, NURBS_FRAME_RULE);
    nurbs_destroy(g);
}

/* The parabola y = s t^2, z = s t in the plane x = 1, with s much smaller than 1: at t = 1/2 its tangent is
 * (0, 1, 1), its curvature 2 / (s sqrt(8)). */
static void tiny_and_far(void) {
    static const int32_t degree = 2;
    static const double param = 0.5, half = 0.70710678118654757, sizes[] = {1e-12, 1e-100, 1e-200, 1e-300};
    for (int i = 0; i < 4; ++i) {
        const double s = sizes[i], points[] = {1, 0, 0, 1, 0, 0.5 * s, 1, s, s};
        double p[3], t[3], n[3], curvature;
        int32_t status = -7;
        nurbs *g = NULL;
        CHECK_OK(nurbs_create_bezier(1, &degree, 3, points, 0, 0, NULL, 0, &g));
        CHECK_OK(frenet(g, 1, &param, ((Outputs){p, t, n, NULL, &curvature, NULL, &status}), 0));
        CHECK_INT(status, 0);
        CHECK_DOUBLES(p, ((const double[]){1, 0.25 * s, 0.5 * s}), 3);
        CHECK_NEAR(t, ((const double[]){0, half, half}), 3, 0x1p-51);
        CHECK_NEAR(n, ((const double[]){0, half, -half}), 3, 0x1p-51);
        CHECK(fabs(curvature * s - half) <= 0x1p-50);
        const double params[] = {0, 0.5, 1};
        double tangents[9], normals[9];
        int32_t each[3];
        const double along[] = {0, 1, 0};
        CHECK_OK(
            minimal(g, 3, params, along, ((Outputs){NULL, tangents, normals, NULL, NULL, NULL, each}), 0));
        CHECK_INT(each[0] + each[1] + each[2], 0);
        CHECK_NEAR(tangents + 3, t, 3, 0x1p-51);
        CHECK_NEAR(normals + 3, n, 3, 0x1p-50);
        nurbs_destroy(g);
    }
}

int main(void) {
    nurbs *g = make(twist()), *flat = make(arch());
    const BatchCase cases[] = {{frenet_points, g, 1, 3, "points", "points", 0, 1, 1, 1},
                               {frenet_tangents, g, 1, 3, "tangents", "tangents", 0, 1, 1, 1},
                               {frenet_normals, g, 1, 3, "normals", "normals", 0, 1, 1, 1},
                               {frenet_binormals, g, 1, 3, "binormals", "binormals", 0, 1, 1, 1},
                               {frenet_curvatures, g, 1, 1, "curvatures", "curvatures", 0, 0, 1, 1},
                               {frenet_torsions, g, 1, 1, "torsions", "torsions", 0, 0, 1, 1},
                               {frenet_tangents, flat, 1, 2, "tangents", "tangents", 0, 1, 1, 1},
                               {frenet_normals, flat, 1, 2, "normals", "normals", 0, 1, 1, 1},
                               {frenet_curvatures, flat, 1, 1, "curvatures", "curvatures", 0, 0, 1, 1},
                               {minimal_points, g, 1, 3, "points", "points", 0, 1, 1, 1},
                               {minimal_tangents, g, 1, 3, "tangents", "tangents", 0, 1, 1, 1},
                               {minimal_normals, g, 1, 3, "normals", "normals", 0, 1, 1, 1},
                               {minimal_binormals, g, 1, 3, "binormals", "binormals", 0, 1, 1, 1}};
    for (size_t i = 0; i < sizeof cases / sizeof *cases; ++i) {
        batch_checks_optional(cases + i);
    }
    known_frame();
    tiny_and_far();
    in_the_plane();
    wrong_kinds();
    overlaps();
    first_normals();
    a_straight_line();
    nurbs_destroy(g);
    nurbs_destroy(flat);
    return check_summary("curve_frames");
}
