/* SPDX-License-Identifier: MIT */
/* nurbs_surface_eval_frames(), nurbs_surface_eval_grid_frames() and nurbs_surface_eval_curvatures(). */
#include "batch.h"
#include "check.h"
#include "shapes.h"

/* Each output alone, in the common shape of batches. */
#define FRAMES(g, n, t, ts, tc, p, ps, pc, u, us, uc, v, vs, vc, w, ws, wc, status, flags)                   \
    nurbs_surface_eval_frames(g, n, t, ts, tc, p, ps, pc, u, us, uc, v, vs, vc, w, ws, wc, status, flags)

static nurbs_status points_only(const nurbs *g, int64_t n, const double *t, int64_t ts, int64_t tc,
                                double *out, int64_t s, int64_t c, uint32_t flags) {
    return FRAMES(g, n, t, ts, tc, out, s, c, NULL, 0, 0, NULL, 0, 0, NULL, 0, 0, NULL, flags);
}

static nurbs_status du_only(const nurbs *g, int64_t n, const double *t, int64_t ts, int64_t tc, double *out,
                            int64_t s, int64_t c, uint32_t flags) {
    return FRAMES(g, n, t, ts, tc, NULL, -1, -1, out, s, c, NULL, -1, -1, NULL, -1, -1, NULL, flags);
}

static nurbs_status dv_only(const nurbs *g, int64_t n, const double *t, int64_t ts, int64_t tc, double *out,
                            int64_t s, int64_t c, uint32_t flags) {
    return FRAMES(g, n, t, ts, tc, NULL, 0, 0, NULL, 0, 0, out, s, c, NULL, 0, 0, NULL, flags);
}

static nurbs_status normals_only(const nurbs *g, int64_t n, const double *t, int64_t ts, int64_t tc,
                                 double *out, int64_t s, int64_t c, uint32_t flags) {
    return FRAMES(g, n, t, ts, tc, NULL, 0, 0, NULL, 0, 0, NULL, 0, 0, out, s, c, NULL, flags);
}

#define CURVATURES(g, n, t, ts, tc, k, ks, kc, d, ds, dc, h, hs, q, qs, status, flags)                       \
    nurbs_surface_eval_curvatures(g, n, t, ts, tc, k, ks, kc, d, ds, dc, h, hs, q, qs, status, flags)

static nurbs_status principal_only(const nurbs *g, int64_t n, const double *t, int64_t ts, int64_t tc,
                                   double *out, int64_t s, int64_t c, uint32_t flags) {
    return CURVATURES(g, n, t, ts, tc, out, s, c, NULL, -1, -1, NULL, -1, NULL, -1, NULL, flags);
}

static nurbs_status directions_only(const nurbs *g, int64_t n, const double *t, int64_t ts, int64_t tc,
                                    double *out, int64_t s, int64_t c, uint32_t flags) {
    return CURVATURES(g, n, t, ts, tc, NULL, 0, 0, out, s, c, NULL, 0, NULL, 0, NULL, flags);
}

static nurbs_status mean_only(const nurbs *g, int64_t n, const double *t, int64_t ts, int64_t tc, double *out,
                              int64_t s, int64_t c, uint32_t flags) {
    (void)c;
    return CURVATURES(g, n, t, ts, tc, NULL, 0, 0, NULL, 0, 0, out, s, NULL, 0, NULL, flags);
}

static nurbs_status gaussian_only(const nurbs *g, int64_t n, const double *t, int64_t ts, int64_t tc,
                                  double *out, int64_t s, int64_t c, uint32_t flags) {
    (void)c;
    return CURVATURES(g, n, t, ts, tc, NULL, 0, 0, NULL, 0, 0, NULL, 0, out, s, NULL, flags);
}

/* S(u, v) = (u, v, u v) at (0.5, 0.25): N = (-v, -u, 1) / sqrt(1 + u^2 + v^2). */
static void known_frame(void) {
    static const double param[] = {0.5, 0.25};
    const double length = sqrt(1 + 0.25 + 0.0625);
    const double normal[] = {-0.25 / length, -0.5 / length, 1 / length};
    double p[3], du[3], dv[3], w[3], k[2], d[6], h, q;
    int32_t status = -7;
    nurbs *g = make(patch());
    CHECK_OK(FRAMES(g, 1, param, 0, 0, p, 0, 0, du, 0, 0, dv, 0, 0, w, 0, 0, &status, 0));
    CHECK_DOUBLES(p, ((const double[]){0.5, 0.25, 0.125}), 3);
    CHECK_DOUBLES(du, ((const double[]){1, 0, 0.25}), 3);
    CHECK_DOUBLES(dv, ((const double[]){0, 1, 0.5}), 3);
    CHECK_NEAR(w, normal, 3, 0x1p-52);
    CHECK_INT(status, 0);
    status = -7;
    CHECK_OK(CURVATURES(g, 1, param, 0, 0, k, 0, 0, d, 0, 0, &h, 0, &q, 0, &status, 0));
    /* L = N = 0, M = 1 / length; det = length^2 */
    CHECK_NEAR(&q, ((const double[]){-1 / pow(length, 4)}), 1, 0x1p-50);
    CHECK_NEAR(&h, ((const double[]){-0.125 / pow(length, 3)}), 1, 0x1p-50);
    CHECK_NEAR(k, ((const double[]){h + sqrt(h * h - q), h - sqrt(h * h - q)}), 2, 0x1p-50);
    CHECK_INT(status, 0);
    nurbs_destroy(g);
}

/* All outputs at once, in one array of records of 12 and in arrays of columns. */
static void layouts(void) {
    static const double params[] = {0.5, 0.25, 0, 1, 0.75, 0.75};
    double apart[4][9], together[3 * 12], columns[4][9];
    int32_t status[4] = {-7, -7, -7, -7};
    nurbs *g = make(trough());
    CHECK_OK(FRAMES(g, 3, params, 0, 0, apart[0], 0, 0, apart[1], 0, 0, apart[2], 0, 0, apart[3], 0, 0,
                    status, 0));
    CHECK_OK(FRAMES(g, 3, params, 0, 0, together, 12, 0, together + 3, 12, 0, together + 6, 12, 0,
                    together + 9, 12, 0, NULL, 0));
    CHECK_OK(FRAMES(g, 3, params, 0, 0, columns[0], 1, 3, columns[1], 1, 3, columns[2], 1, 3, columns[3], 1,
                    3, NULL, 0));
    for (int k = 0; k < 4; ++k) {
        for (int i = 0; i < 9; ++i) {
            CHECK_DOUBLE(together[12 * (i / 3) + 3 * k + i % 3], apart[k][i]);
            CHECK_DOUBLE(columns[k][3 * (i % 3) + i / 3], apart[k][i]);
        }
    }
    CHECK_INT(status[2], 0);
    CHECK_INT(status[3], -7);
    CHECK_OK(FRAMES(g, 3, params, 0, 0, NULL, 0, 0, NULL, 0, 0, NULL, 0, 0, NULL, 0, 0, NULL, 0));
    nurbs_destroy(g);
}

static void overlaps(void) {
    static const double params[] = {0.5, 0.25, 0.25, 0.5};
    double a[64], in[16];
    int32_t *status = (int32_t *)(void *)a;
    nurbs *g = make(patch());
    FILL(a);
    CHECK_FAILS(FRAMES(g, 2, params, 0, 0, a, 0, 0, a + 5, 0, 0, NULL, 0, 0, NULL, 0, 0, NULL, 0),
                NURBS_ERROR_OVERLAP, "du|points");
    CHECK_FAILS(FRAMES(g, 2, params, 0, 0, a, 0, 0, NULL, 0, 0, a + 6, 0, 0, a + 11, 0, 0, NULL, 0),
                NURBS_ERROR_OVERLAP, "normals|dv");
    CHECK_FAILS(FRAMES(g, 2, params, 0, 0, NULL, 0, 0, NULL, 0, 0, a, 0, 0, NULL, 0, 0, status, 0),
                NURBS_ERROR_OVERLAP, "status|dv");
    CHECK_FAILS(CURVATURES(g, 2, params, 0, 0, a, 0, 0, NULL, 0, 0, a + 3, 0, NULL, 0, NULL, 0),
                NURBS_ERROR_OVERLAP, "mean|principal");
    CHECK_FAILS(CURVATURES(g, 2, params, 0, 0, NULL, 0, 0, a, 0, 0, NULL, 0, a + 11, 0, NULL, 0),
                NURBS_ERROR_OVERLAP, "gaussian|directions");
    CHECK_FAILS(CURVATURES(g, 2, params, 0, 0, NULL, 0, 0, NULL, 0, 0, a, 0, NULL, 0, status, 0),
                NURBS_ERROR_OVERLAP, "status|mean");
    CHECK_UNTOUCHED(a);
    memcpy(in, params, sizeof params);
    CHECK_FAILS(
        FRAMES(g, 2, in, 0, 0, NULL, 0, 0, NULL, 0, 0, NULL, 0, 0, NULL, 0, 0, (int32_t *)(void *)in, 0),
        NURBS_ERROR_OVERLAP, "status|params");
    CHECK_FAILS(
        CURVATURES(g, 2, in, 0, 0, NULL, 0, 0, NULL, 0, 0, NULL, 0, NULL, 0, (int32_t *)(void *)in, 0),
        NURBS_ERROR_OVERLAP, "status|params");
    CHECK_BITS(in, params, sizeof params);
    nurbs_destroy(g);
}

static void wrong_kinds(void) {
    static const double params[] = {0.5, 0.25, 0.5};
    static const int32_t degrees[] = {1, 1};
    static const int64_t counts[] = {1, 1};
    static const double flat[] = {0, 0, 0, 1, 1, 0, 1, 1};
    double out[12];
    nurbs *curve = make(twist()), *volume = make(cube()), *plane = NULL;
    FILL(out);
    CHECK_OK(nurbs_create_bezier(2, degrees, 2, flat, 0, 0, NULL, 0, &plane));
    CHECK_FAILS(points_only(curve, 1, params, 0, 0, out, 0, 0, 0), NURBS_ERROR_AXES, "surface|1");
    CHECK_FAILS(points_only(volume, 1, params, 0, 0, out, 0, 0, 0), NURBS_ERROR_AXES, "surface|3");
    CHECK_FAILS(points_only(plane, 1, params, 0, 0, out, 0, 0, 0), NURBS_ERROR_DIMENSION, "dimension 2");
    CHECK_FAILS(principal_only(curve, 1, params, 0, 0, out, 0, 0, 0), NURBS_ERROR_AXES, "surface|1");
    CHECK_FAILS(principal_only(plane, 1, params, 0, 0, out, 0, 0, 0), NURBS_ERROR_DIMENSION, "dimension 2");
    CHECK_FAILS(nurbs_surface_eval_grid_frames(curve, counts, params, out, 0, 0, NULL, 0, 0, NULL, 0, 0, NULL,
                                               0, 0, NULL, 0),
                NURBS_ERROR_AXES, "surface|1");
    CHECK_FAILS(nurbs_surface_eval_grid_frames(plane, counts, params, out, 0, 0, NULL, 0, 0, NULL, 0, 0, NULL,
                                               0, 0, NULL, 0),
                NURBS_ERROR_DIMENSION, "dimension 2");
    CHECK_UNTOUCHED(out);
    nurbs_destroy(curve);
    nurbs_destroy(volume);
    nurbs_destroy(plane);
}

/* Whatever output is bad, nothing is written to the others. */
static void nothing_is_written(void) {
    static const double params[] = {0.5, 0.25, 1.5, 0.5};
    double out[4][16];
    int32_t status[2];
    nurbs *g = make(patch());
    FILL(out);
    FILL(status);
    for (int64_t bad = 0; bad < 4; ++bad) {
        const int64_t s[4] = {bad == 0 ? 2 : 0, bad == 1 ? 2 : 0, bad == 2 ? 2 : 0, bad == 3 ? 2 : 0};
        CHECK_FAILS(FRAMES(g, 2, params, 0, 0, out[0], s[0], 0, out[1], s[1], 0, out[2], s[2], 0, out[3],
                           s[3], 0, status, NURBS_CLAMP),
                    NURBS_ERROR_STRIDE, "stride");
    }
    CHECK_FAILS(FRAMES(g, 2, params, 0, 0, out[0], 0, 0, out[1], 0, 0, out[2], 0, 0, out[3], 0, 0, status, 0),
                NURBS_ERROR_OUTSIDE_DOMAIN, "params[1]");
    CHECK_FAILS(CURVATURES(g, 2, params, 0, 0, out[0], 0, 0, out[1], 0, 0, out[2], 0, out[3], 0, status, 0),
                NURBS_ERROR_OUTSIDE_DOMAIN, "params[1]");
    CHECK_FAILS(CURVATURES(g, 2, params, 0, 0, out[0], 0, 0, out[1], 0, 0, out[2], -1, out[3], 0, status, 0),
                NURBS_ERROR_STRIDE, "mean");
    CHECK_FAILS(CURVATURES(g, 2, params, 0, 0, out[0], 0, 0, out[1], 0, 0, out[2], 0, out[3], -1, status, 0),
                NURBS_ERROR_STRIDE, "gaussian");
    CHECK_UNTOUCHED(out);
    CHECK_UNTOUCHED(status);
    nurbs_destroy(g);
}

static nurbs_status grid(const nurbs *g, const int64_t *counts, const double *params, double *out, int64_t s,
                         int64_t c, int32_t *status, uint32_t flags) {
    return nurbs_surface_eval_grid_frames(g, counts, params, NULL, 0, 0, NULL, 0, 0, NULL, 0, 0, out, s, c,
                                          status, flags);
}

static void bad_grids(void) {
    static const int64_t counts[] = {2, 2}, negative[] = {2, -1}, huge[] = {INT64_MAX / 4, 8},
                         none[] = {0, 2}, empty[] = {0, 0};
    static const double params[] = {0.25, 0.75, 0.5, 1};
    static const double spoilt[] = {0.25, 0.75, 0.5, NAN}, outside[] = {0.25, 0.75, 0.5, 1.25};
    double out[16], shared[16];
    int32_t status[4];
    nurbs *g = make(patch());
    FILL(out);
    FILL(status);
    CHECK_FAILS(grid(NULL, counts, params, out, 0, 0, status, 0), NURBS_ERROR_NULL, "g");
    CHECK_FAILS(grid(g, NULL, params, out, 0, 0, status, 0), NURBS_ERROR_NULL, "counts");
    CHECK_FAILS(grid(g, counts, NULL, out, 0, 0, status, 0), NURBS_ERROR_NULL, "params");
    CHECK_FAILS(grid(g, negative, params, out, 0, 0, status, 0), NURBS_ERROR_COUNT, "counts[1]|-1");
    CHECK_FAILS(grid(g, huge, params, out, 0, 0, status, 0), NURBS_ERROR_OVERFLOW, "address space");
    CHECK_FAILS(grid(g, counts, params, out, -1, 0, status, 0), NURBS_ERROR_STRIDE, "normals|-1");
    CHECK_FAILS(grid(g, counts, params, out, 2, 0, status, 0), NURBS_ERROR_STRIDE, "normals");
    CHECK_FAILS(grid(g, counts, params, out, 0, INT64_MAX, status, 0), NURBS_ERROR_OVERFLOW, "normals");
    CHECK_FAILS(grid(g, counts, params, out, 0, 0, status, 0x20), NURBS_ERROR_FLAGS, "flags");
    CHECK_FAILS(grid(g, counts, spoilt, out, 0, 0, status, 0), NURBS_ERROR_PARAMETER_NOT_FINITE, "params[3]");
    CHECK_FAILS(grid(g, counts, outside, out, 0, 0, status, 0), NURBS_ERROR_OUTSIDE_DOMAIN, "params[3]");
    CHECK_UNTOUCHED(out);
    CHECK_UNTOUCHED(status);
    memcpy(shared, params, sizeof params);
    CHECK_FAILS(grid(g, counts, shared, shared + 3, 0, 0, NULL, 0), NURBS_ERROR_OVERLAP, "normals|params");
    CHECK_FAILS(grid(g, (const int64_t *)(void *)memcpy(shared + 8, counts, sizeof counts), params, shared, 0,
                     0, NULL, 0),
                NURBS_ERROR_OVERLAP, "normals|counts");
    CHECK_FAILS(grid(g, counts, shared, NULL, 0, 0, (int32_t *)(void *)shared, 0), NURBS_ERROR_OVERLAP,
                "status|params");
    CHECK_BITS(shared, params, sizeof params);
    CHECK_OK(grid(g, none, params, NULL, 0, 0, NULL, 0));
    CHECK_OK(grid(g, empty, NULL, NULL, 0, 0, NULL, 0));
    CHECK_OK(grid(g, counts, params, out, 0, 0, status, 0));
    CHECK_INT(status[3], 0);
    nurbs_destroy(g);
}

/* A triangle: the edge u = 0 of a bilinear patch is one point, where the normal is a limit. */
static void a_collapsed_edge(void) {
    static const int32_t degrees[] = {1, 1};
    static const double points[] = {0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 1, 0}, params[] = {0, 0.5, 0.5, 0.5};
    double normals[6];
    int32_t status[2];
    nurbs *g = NULL;
    CHECK_OK(nurbs_create_bezier(2, degrees, 3, points, 0, 0, NULL, 0, &g));
    CHECK_OK(FRAMES(g, 2, params, 0, 0, NULL, 0, 0, NULL, 0, 0, NULL, 0, 0, normals, 0, 0, status, 0));
    CHECK_DOUBLES(normals, ((const double[]){0, 0, 1, 0, 0, 1}), 6);
    CHECK_INT(status[0], NURBS_FRAME_LIMIT);
    CHECK_INT(status[1], 0);
    CHECK_OK(CURVATURES(g, 2, params, 0, 0, NULL, 0, 0, NULL, 0, 0, NULL, 0, NULL, 0, status, 0));
    CHECK_INT(status[0], NURBS_FRAME_UNDEFINED);
    CHECK_INT(status[1], NURBS_FRAME_RULE);
    nurbs_destroy(g);
}

/* Patches of the plane x = 1 that are much smaller than 1. */
static void tiny_and_far(void) {
    static const int32_t degrees[] = {1, 1};
    static const double param[] = {0.5, 0.5}, sizes[] = {1e-12, 1e-100, 1e-200, 1e-300};
    for (int i = 0; i < 4; ++i) {
        const double s = sizes[i], points[] = {1, 0, 0, 1, 0, s, 1, s, 0, 1, s, s};
        double p[3], du[3], normal[3], k[2], h;
        int32_t status = -7;
        nurbs *g = NULL;
        CHECK_OK(nurbs_create_bezier(2, degrees, 3, points, 0, 0, NULL, 0, &g));
        CHECK_OK(FRAMES(g, 1, param, 0, 0, p, 0, 0, du, 0, 0, NULL, 0, 0, normal, 0, 0, &status, 0));
        CHECK_INT(status, 0);
        CHECK_DOUBLES(p, ((const double[]){1, 0.5 * s, 0.5 * s}), 3);
        CHECK_DOUBLES(du, ((const double[]){0, s, 0}), 3);
        CHECK_NEAR(normal, ((const double[]){1, 0, 0}), 3, 0x1p-52);
        status = -7;
        CHECK_OK(CURVATURES(g, 1, param, 0, 0, k, 0, 0, NULL, 0, 0, &h, 0, NULL, 0, &status, 0));
        CHECK_INT(status, NURBS_FRAME_RULE);
        CHECK_DOUBLES(k, ((const double[]){0, 0}), 2);
        CHECK_DOUBLE(h, 0);
        nurbs_destroy(g);
    }
}

int main(void) {
    nurbs *g = make(patch());
    const BatchCase cases[] = {{points_only, g, 2, 3, "points", "points", 1, 1, 1, 1},
                               {du_only, g, 2, 3, "du", "du", 1, 1, 1, 1},
                               {dv_only, g, 2, 3, "dv", "dv", 1, 1, 1, 1},
                               {normals_only, g, 2, 3, "normals", "normals", 1, 1, 1, 1},
                               {principal_only, g, 2, 2, "principal", "principal", 1, 1, 1, 1},
                               {directions_only, g, 2, 6, "directions", "directions", 1, 1, 1, 1},
                               {mean_only, g, 2, 1, "mean", "mean", 1, 0, 1, 1},
                               {gaussian_only, g, 2, 1, "gaussian", "gaussian", 1, 0, 1, 1}};
    for (size_t i = 0; i < sizeof cases / sizeof *cases; ++i) {
        batch_checks_optional(cases + i);
    }
    known_frame();
    layouts();
    overlaps();
    wrong_kinds();
    nothing_is_written();
    bad_grids();
    a_collapsed_edge();
    tiny_and_far();
    nurbs_destroy(g);
    return check_summary("surface_frames");
}
