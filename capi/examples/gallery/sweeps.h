/* SPDX-License-Identifier: MIT */
/* Surfaces and volumes from curves: moved, turned, ruled, added and multiplied. */
#ifndef GALLERY_SWEEPS_H
#define GALLERY_SWEEPS_H

#include "curves.h"

/* A cubic Bezier curve or, with more points, several that share their ends. */
static nurbs *cubic(int32_t dim, const double *points, int64_t n) {
    const int32_t degree = 3;
    const int64_t pieces = (n - 1) / 3;
    double knots[32];
    nurbs *g;
    check(nurbs_knots_bezier(3, pieces, NULL, n + 4, knots));
    check(nurbs_create(1, &degree, &n, knots, n + 4, dim, points, 0, 0, NULL, 0, 0, &g));
    return g;
}

static nurbs *wave(void) {
    const double points[4][3] = {{0, 0, 0}, {0.7, 0, 1.2}, {1.3, 0, -1}, {2, 0, 0.4}};
    return cubic(3, points[0], 4);
}

/* Half of the outline of a vase, in the plane of x and z. */
static nurbs *outline(void) {
    const double points[7][3] = {{0.5, 0, 0},     {1.2, 0, 0.3}, {1.1, 0, 1},  {0.7, 0, 1.4},
                                 {0.35, 0, 1.75}, {0.4, 0, 2.1}, {0.7, 0, 2.4}};
    return cubic(3, points[0], 7);
}

static void moved_and_turned(gallery *p) {
    const double way[3] = {0, 1.5, 0.2}, corner[3] = {0.5, 0, 0}, up[3] = {0.2, 0, 0.6}, out[3] = {1, 0, 0};
    nurbs *curve = wave(), *g, *solid;
    check(nurbs_extrude(curve, way, &g));
    add_curve(p, curve, "edge");
    show_surface(p, "extrude", g, 20, 1, OPEN);
    nurbs_destroy(curve);
    curve = outline();
    check(nurbs_revolve(curve, NULL, NULL, 1.5 * PI, NURBS_ARC_QUARTERS, &g));
    add_curve(p, curve, "edge");
    show_surface(p, "revolve", g, 18, 10, OPEN);
    nurbs_destroy(curve);
    check(nurbs_surface_plane(3, corner, up, out, &g));
    check(nurbs_revolve(g, NULL, NULL, 1.25 * PI, NURBS_ARC_QUARTERS, &solid));
    nurbs_destroy(g);
    show_volume(p, "revolve, a volume", solid, 9);
}

static void ruled_between(gallery *p) {
    const double above[3] = {0, 0, 2}, x[3] = {-0.5, 0.86, 0};
    nurbs *low, *high, *g;
    check(nurbs_curve_circle(3, NULL, NULL, NULL, 1, NURBS_ARC_QUARTERS, &low));
    check(nurbs_curve_circle(3, above, NULL, x, 1, NURBS_ARC_QUARTERS, &high));
    check(nurbs_ruled(low, high, 0, &g));
    add_curve(p, low, "edge");
    add_curve(p, high, "edge");
    show_surface(p, "ruled", g, 24, 4, OPEN);
    nurbs_destroy(low);
    nurbs_destroy(high);
}

/* A curve carried along another one. */
static void translated(gallery *p) {
    const double across[4][3] = {{0, 0, 0}, {0, 0.6, 0.9}, {0, 1.4, 0.9}, {0, 2, 0}};
    nurbs *a = wave(), *b = cubic(3, across[0], 4), *g;
    check(nurbs_tensor_sum(a, 1, b, 1, &g));
    add_curve(p, a, "edge");
    add_curve(p, b, "edge");
    show_surface(p, "tensor_sum", g, 12, 12, OPEN);
    nurbs_destroy(a);
    nurbs_destroy(b);
}

/* (x, y, 1) times (r, r, z): a trajectory scaled and lifted by a profile. */
static void multiplied(gallery *p) {
    const double profile[4][3] = {{1, 1, 0}, {0.2, 0.2, 0.5}, {0.5, 0.5, 1.2}, {0.9, 0.9, 1.6}};
    const double unit[3] = {0, 0, 1};
    nurbs *a, *b = cubic(3, profile[0], 4), *g;
    check(nurbs_curve_polygon(3, unit, NULL, NULL, 1, 6, &a));
    check(nurbs_tensor_product(a, b, &g));
    show_surface(p, "tensor_product", g, 6, 10, OPEN);
    nurbs_destroy(a);
    nurbs_destroy(b);
}

/* A rounded square swung about the axis of an outline. */
static void swung(gallery *p) {
    const double profile[7][2] = {{0, 0},      {0.6, 0},    {1, 0.25}, {0.9, 0.7},
                                  {0.8, 1.15}, {0.45, 1.1}, {0.4, 1.5}};
    nurbs *trajectory, *curve = cubic(2, profile[0], 7), *g;
    check(nurbs_curve_rounded_rectangle(2, NULL, NULL, NULL, 2, 2, 0.5, &trajectory));
    check(nurbs_surface_swung(trajectory, curve, 1, &g));
    show_surface(p, "surface_swung", g, 24, 8, OPEN);
    nurbs_destroy(trajectory);
    nurbs_destroy(curve);
}

static void show_sweeps(gallery *p) {
    moved_and_turned(p);
    ruled_between(p);
    translated(p);
    multiplied(p);
    swung(p);
}

#endif
