/* SPDX-License-Identifier: MIT */
/* Surfaces and volumes from their boundaries, and shapes that are recognized. */
#ifndef GALLERY_BOUNDARIES_H
#define GALLERY_BOUNDARIES_H

#include "sweeps.h"

/* Four curves that meet at their ends: at u = 0 and 1 along v, at v = 0 and 1 along u. */
static void frame_of_curves(nurbs *curves[4]) {
    const double points[4][4][3] = {{{0, 0, 0}, {0, 0.3, 0.9}, {0, 0.7, 0.6}, {0, 1, 0.1}},
                                    {{1, 0, 0.2}, {1.3, 0.3, -0.3}, {1.2, 0.7, -0.1}, {1, 1, 0.3}},
                                    {{0, 0, 0}, {0.3, 0, 0.5}, {0.7, 0.1, 0.5}, {1, 0, 0.2}},
                                    {{0, 1, 0.1}, {0.3, 1.2, 0.6}, {0.7, 1.1, -0.4}, {1, 1, 0.3}}};
    int i;
    for (i = 0; i < 4; ++i) {
        curves[i] = cubic(3, points[i][0], 4);
    }
}

static void coons_of_curves(gallery *p) {
    nurbs *curves[4], *g;
    double gaps[4];
    int i;
    frame_of_curves(curves);
    check(nurbs_coons_gaps((const nurbs *const *)curves, NULL, gaps, NULL, NULL));
    printf("gaps at the corners of a Coons surface: %g, %g, %g, %g\n", gaps[0], gaps[1], gaps[2], gaps[3]);
    for (i = 0; i < 4; ++i) {
        add_curve(p, curves[i], "edge");
    }
    end_cell(p, "four boundary curves");
    check(nurbs_surface_coons((const nurbs *const *)curves, 0, &g));
    add_edges(p, g);
    show_surface(p, "surface_coons", g, 10, 10, OPEN);
    for (i = 0; i < 4; ++i) {
        nurbs_destroy(curves[i]);
    }
}

/* The derivative by the axis on which a boundary is fixed, along that boundary. */
static nurbs *cross_tangent(const nurbs *g, int boundary) {
    const int32_t axis = boundary / 2;
    double domain[2];
    nurbs *derivative, *curve;
    check(nurbs_domain(g, axis, domain));
    check(nurbs_derivative(g, axis, 1, &derivative));
    check(nurbs_iso(derivative, axis, domain[boundary % 2], 0, &curve));
    nurbs_destroy(derivative);
    return curve;
}

/* A surface made again from its boundaries and the derivatives across them. */
static void coons_with_tangents(gallery *p) {
    const double across[4][3] = {{0, 0, 0}, {0, 0.6, 0.9}, {0, 1.4, 0.9}, {0, 2, 0}};
    nurbs *a = wave(), *b = cubic(3, across[0], 4), *whole, *curves[4], *cross[4], *g;
    nurbs_list *list;
    double bound;
    int i;
    check(nurbs_tensor_sum(a, 1, b, 1, &whole));
    check(nurbs_boundaries(whole, &list));
    for (i = 0; i < 4; ++i) {
        curves[i] = item_of(list, i);
        cross[i] = cross_tangent(whole, i);
    }
    check(nurbs_surface_coons_hermite((const nurbs *const *)curves, (const nurbs *const *)cross,
                                      NURBS_TWIST_AVERAGE, NULL, 1e-12, &bound, &g));
    printf("the twists of a Coons surface differ by %.1e\n", bound);
    add_edges(p, g);
    show_surface(p, "surface_coons_hermite", g, 10, 10, OPEN);
    for (i = 0; i < 4; ++i) {
        nurbs_destroy(curves[i]);
        nurbs_destroy(cross[i]);
    }
    nurbs_list_destroy(list);
    nurbs_destroy(whole);
    nurbs_destroy(a);
    nurbs_destroy(b);
}

/* A volume made again from its six faces. */
static void coons_of_faces(gallery *p) {
    const double eight[8][3] = {{0, 0, 0}, {0, 0, 1},   {0, 1, 0},   {0, 1, 1},
                                {1, 0, 0}, {1, 0, 1.5}, {1, 1, 0.4}, {1, 1, 1.2}};
    nurbs *g, *solid, *faces[6];
    nurbs_list *list;
    int i;
    check(nurbs_volume_trilinear(3, eight[0], 0, 0, &g));
    check(nurbs_boundaries(g, &list));
    for (i = 0; i < 6; ++i) {
        faces[i] = item_of(list, i);
    }
    check(nurbs_volume_coons((const nurbs *const *)faces, 0, &solid));
    show_volume(p, "volume_coons", solid, 5);
    for (i = 0; i < 6; ++i) {
        nurbs_destroy(faces[i]);
    }
    nurbs_list_destroy(list);
    nurbs_destroy(g);
}

/* A torus that has been refined and elevated is a torus still. */
static void recognized(gallery *p) {
    nurbs *torus, *finer, *g;
    double placement[9], sizes[3], deviation;
    int32_t shape;
    check(nurbs_surface_torus(NULL, NULL, NULL, 2, 0.5, 0, PI, 0, 2 * PI, NURBS_ARC_THIRDS, &torus));
    check(nurbs_refine_uniform(torus, 0, 3, &finer));
    check(nurbs_elevate(finer, 1, 1, &g));
    check(nurbs_recognize(g, 1e-9, &shape, placement, sizes, &deviation));
    printf("%s: radii %.9g and %.9g, deviation at most %.0e\n",
           shape == NURBS_SHAPE_TORUS ? "recognized a torus" : "recognized something else", sizes[0],
           sizes[1], deviation);
    show_surface(p, "recognize", g, 16, 10, OPEN);
    nurbs_destroy(finer);
    nurbs_destroy(torus);
}

static void show_boundaries(gallery *p) {
    coons_of_curves(p);
    coons_with_tangents(p);
    coons_of_faces(p);
    recognized(p);
}

#endif
