/* SPDX-License-Identifier: MIT */
/* nurbs_hull_size(): the `hull` of the accuracy contract. */
#include "batch.h"
#include "check.h"
#include "shapes.h"

static nurbs_status hull_size(const nurbs *g, int64_t n, const double *params, int64_t stride,
                              int64_t component_stride, double *out, int64_t out_stride, int64_t unused,
                              uint32_t flags) {
    (void)unused;
    return nurbs_hull_size(g, n, params, stride, component_stride, out, out_stride, flags);
}

static void local_sizes(SplineArgs a, int64_t n, const double *params, uint32_t flags,
                        const double *expected) {
    double sizes[8];
    nurbs *g = make(a);
    FILL(sizes);
    CHECK_OK(nurbs_hull_size(g, n, params, 0, 0, sizes, 0, flags));
    CHECK_DOUBLES(sizes, expected, n);
    check_untouched(__FILE__, __LINE__, sizes + n, sizeof sizes - (size_t)n * sizeof *sizes);
    nurbs_destroy(g);
}

static void known_sizes(void) {
    static const double ends[] = {0, 1, 2}, steps[] = {0.5, 1, 2.5, 3}, mid[] = {0.5, 0.5, 0.5};
    local_sizes(arch(), 2, ends, 0, (const double[]){4, 4});
    local_sizes(jump(), 3, ends, 0, (const double[]){1, 6, 6});
    local_sizes(jump(), 3, ends, NURBS_LEFT, (const double[]){1, 1, 6});
    local_sizes(stairs(), 4, steps, 0, (const double[]){10, 20, 30, 30});
    local_sizes(stairs(), 4, steps, NURBS_LEFT, (const double[]){10, 10, 30, 30});
    local_sizes(patch(), 1, mid, 0, (const double[]){1});
    local_sizes(trough(), 1, (const double[]){0.5, 0.25}, 0, (const double[]){2});
    local_sizes(trough(), 1, (const double[]){0.5, 2.5}, 0, (const double[]){4});
    local_sizes(cube(), 1, mid, 0, (const double[]){1});
}

static void flags_outside(void) {
    static const double params[] = {-1, 3.5}, nans[] = {NAN, 0.5};
    double sizes[2];
    local_sizes(jump(), 2, params, NURBS_CLAMP, (const double[]){1, 6});
    local_sizes(jump(), 2, params, NURBS_EXTRAPOLATE, (const double[]){1, 6});
    local_sizes(jump(), 2, params, NURBS_WRAP, (const double[]){6, 6});
    local_sizes(jump(), 2, params, NURBS_NAN, (const double[]){NAN, NAN});
    nurbs *g = make(jump());
    CHECK_OK(nurbs_hull_size(g, 2, nans, 0, 0, sizes, 0, NURBS_NAN));
    CHECK(isnan(sizes[0]));
    CHECK_DOUBLE(sizes[1], 1);
    nurbs_destroy(g);
}

/* A point of weight 0 does not count. */
static void zero_weights(void) {
    static const int32_t degrees[] = {2};
    static const int64_t counts[] = {3};
    static const double knots[] = {0, 0, 0, 1, 1, 1}, points[] = {1, 100, -2}, weights[] = {1, 0, 1},
                        half = 0.5;
    SplineArgs a = {1, degrees, counts, knots, 6, 1, points, 0, 0, weights, 0, 0};
    local_sizes(a, 1, &half, 0, (const double[]){2});
}

/* With signed weights: (max |w_i P_i| + |C(t)| max |w_i|) / |w(t)|, here (1 + |t / (1 - 2 t)|) / |1 - 2
 * t|. */
static void signed_weights(void) {
    static const int32_t degree = 1;
    static const int64_t count = 2;
    static const double knots[] = {0, 0, 1, 1}, records[] = {0, 1, 1, -1}, params[] = {0, 0.25, 0.75, 1};
    static const double expected[] = {1, 3, 5, 2};
    double sizes[4];
    nurbs *g = NULL;
    CHECK_OK(nurbs_create_homogeneous(1, &degree, &count, knots, 4, 1, records, 0, 0, 0, &g));
    CHECK_OK(nurbs_hull_size(g, 4, params, 0, 0, sizes, 0, 0));
    CHECK_DOUBLES(sizes, expected, 4);
    nurbs_destroy(g);
}

int main(void) {
    nurbs *curve = make(arch()), *surface = make(patch()), *volume = make(cube());
    BatchCase c = {hull_size, curve, 1, 1, "sizes", "size", 1, 0, 1, 1};
    known_sizes();
    flags_outside();
    zero_weights();
    signed_weights();
    batch_checks(&c);
    c.g = surface;
    c.axes = 2;
    batch_checks(&c);
    c.g = volume;
    c.axes = 3;
    batch_checks(&c);
    nurbs_destroy(curve);
    nurbs_destroy(surface);
    nurbs_destroy(volume);
    return check_summary("hull_size");
}
