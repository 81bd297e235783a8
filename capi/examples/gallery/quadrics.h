/* SPDX-License-Identifier: MIT */
/* Patches and quadrics. Placements are left out, so that the shapes stand at the origin with their axes along
 * z. */
#ifndef GALLERY_QUADRICS_H
#define GALLERY_QUADRICS_H

#include "curves.h"

static void patches(gallery *p) {
    const double u[3] = {2, 0, 0.3}, v[3] = {0, 1.5, 0};
    const double four[4][3] = {{0, 0, 0}, {0, 1, 0.7}, {1, 0, 0.7}, {1, 1, 0}};
    const double eight[8][3] = {{0, 0, 0}, {0.2, 0.2, 1},   {0, 1, 0},   {0.2, 0.8, 1.2},
                                {1, 0, 0}, {0.8, 0.2, 1.2}, {1, 1, 0.2}, {0.7, 0.7, 1}};
    nurbs *g;
    check(nurbs_surface_plane(3, NULL, u, v, &g));
    show_surface(p, "surface_plane", g, 1, 1, OPEN);
    check(nurbs_surface_bilinear(3, four[0], 0, 0, &g));
    show_surface(p, "surface_bilinear", g, 9, 9, OPEN);
    check(nurbs_volume_trilinear(3, eight[0], 0, 0, &g));
    show_volume(p, "volume_trilinear", g, 5);
}

static void spheres(gallery *p) {
    nurbs *g;
    nurbs_list *list;
    int64_t i, count;
    check(nurbs_surface_sphere(NULL, NULL, NULL, 1, NURBS_ARC_QUARTERS, &g));
    show_surface(p, "surface_sphere", g, 24, 12, CLOSED);
    check(nurbs_surface_spherical_patch(NULL, NULL, NULL, 1, -PI / 2, 1.25 * PI, -PI / 4, PI / 3,
                                        NURBS_ARC_QUARTERS, &g));
    show_surface(p, "surface_spherical_patch", g, 18, 8, OPEN);
    check(nurbs_surface_sphere_patches(NULL, NULL, NULL, 1, NURBS_HEMISPHERE, &list));
    check(nurbs_list_count(list, &count));
    for (i = 0; i < count; ++i) {
        g = item_of(list, i);
        add_surface(p, g, 6, 6, OPEN);
        nurbs_destroy(g);
    }
    end_cell(p, "surface_sphere_patches");
    nurbs_list_destroy(list);
    check(nurbs_surface_ellipsoid(NULL, NULL, NULL, 0.8, 1.4, 0.6, NURBS_ARC_QUARTERS, &g));
    show_surface(p, "surface_ellipsoid", g, 24, 12, CLOSED);
}

static void surfaces_of_revolution(gallery *p) {
    nurbs *g;
    check(nurbs_surface_cylinder(NULL, NULL, NULL, 1, 1.6, 0, 2 * PI, NURBS_ARC_QUARTERS, &g));
    show_surface(p, "surface_cylinder", g, 28, 1, OPEN);
    check(nurbs_surface_cone(NULL, NULL, NULL, 1, 0.3, 1.6, 0, 2 * PI, NURBS_ARC_QUARTERS, &g));
    show_surface(p, "surface_cone", g, 28, 1, OPEN);
    check(nurbs_surface_torus(NULL, NULL, NULL, 1, 0.4, 0, 1.5 * PI, 0, 2 * PI, NURBS_ARC_QUARTERS, &g));
    show_surface(p, "surface_torus", g, 18, 10, OPEN);
}

static void other_quadrics(gallery *p) {
    nurbs *g;
    check(nurbs_surface_paraboloid(NULL, NULL, NULL, 1, 0.7, 1.2, 0, 2 * PI, NURBS_ARC_QUARTERS, &g));
    show_surface(p, "surface_paraboloid", g, 20, 7, OPEN);
    check(nurbs_surface_saddle(NULL, NULL, NULL, 1, 1, 0.6, &g));
    show_surface(p, "surface_saddle", g, 11, 11, OPEN);
    check(nurbs_surface_hyperboloid(NULL, NULL, NULL, 0.5, 0.5, 0.6, -1, 1, 0, 2 * PI, NURBS_ARC_QUARTERS, 0,
                                    &g));
    show_surface(p, "surface_hyperboloid", g, 20, 8, OPEN);
}

/* Both sheets, one call each. */
static void two_sheets(gallery *p) {
    nurbs *g;
    int side;
    for (side = -1; side <= 1; side += 2) {
        check(nurbs_surface_hyperboloid(NULL, NULL, NULL, 0.5, 0.5, 0.3, side < 0 ? -1 : 0.3,
                                        side < 0 ? -0.3 : 1, 0, 2 * PI, NURBS_ARC_QUARTERS, NURBS_TWO_SHEETS,
                                        &g));
        add_surface(p, g, 20, 4, OPEN);
        nurbs_destroy(g);
    }
    end_cell(p, "hyperboloid, TWO_SHEETS");
}

static void show_quadrics(gallery *p) {
    patches(p);
    spheres(p);
    surfaces_of_revolution(p);
    other_quadrics(p);
    two_sheets(p);
}

#endif
