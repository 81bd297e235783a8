/* SPDX-License-Identifier: MIT */
/* Lines, conics and helices: one example for each function. Placements are left out where the default
 * serves. */
#ifndef GALLERY_CURVES_H
#define GALLERY_CURVES_H

#include "draw.h"

#define PI 3.14159265358979323846

/* Points and directions that an example is given. */
static void add_given(gallery *p, const double *point, const double *tangent) {
    const double ends[4] = {point[0], point[1], point[0] + 0.5 * tangent[0], point[1] + 0.5 * tangent[1]};
    add_line(p, "tangent", ends, 2, 2);
    add_dots(p, "given", point, 1, 2);
}

static void lines(gallery *p) {
    const double a[2] = {0, 0}, b[2] = {2, 1};
    const double star[6][2] = {{0, 1}, {-0.59, -0.81}, {0.95, 0.31}, {-0.95, 0.31}, {0.59, -0.81}, {0, 1}};
    nurbs *g;
    check(nurbs_curve_line(2, a, b, &g));
    show_curve(p, "curve_line", g);
    check(nurbs_curve_polyline(6, 2, star[0], 0, 0, NULL, 0, &g));
    show_curve(p, "curve_polyline", g);
    check(nurbs_curve_polygon(2, NULL, NULL, NULL, 1, 7, &g));
    show_curve(p, "curve_polygon", g);
    check(nurbs_curve_rounded_rectangle(2, NULL, NULL, NULL, 3, 2, 0.6, &g));
    show_curve(p, "curve_rounded_rectangle", g);
}

/* Four pieces, three pieces, or one smooth one of degree 5. */
static void circles(gallery *p) {
    static const char *const labels[] = {"circle, ARC_QUARTERS", "circle, ARC_THIRDS", "circle, ARC_SMOOTH"};
    nurbs *g;
    int32_t form;
    for (form = NURBS_ARC_QUARTERS; form <= NURBS_ARC_SMOOTH; ++form) {
        check(nurbs_curve_circle(2, NULL, NULL, NULL, 1, form, &g));
        show_curve(p, labels[form], g);
    }
    check(nurbs_curve_arc(2, NULL, NULL, NULL, 1, PI / 6, 1.25 * PI, NURBS_ARC_QUARTERS, &g));
    show_curve(p, "curve_arc", g);
}

static void arcs_through_points(gallery *p) {
    const double a[2] = {1, 0}, b[2] = {0.2, 1.3}, c[2] = {-0.8, 0.1}, tangent[2] = {-0.6, 0.9};
    nurbs *g;
    check(nurbs_curve_arc_through(2, a, b, c, NURBS_ARC_QUARTERS, &g));
    add_dots(p, "given", a, 1, 2);
    add_dots(p, "given", b, 1, 2);
    add_dots(p, "given", c, 1, 2);
    show_curve(p, "curve_arc_through", g);
    check(nurbs_curve_arc_tangent(2, a, tangent, c, NURBS_ARC_QUARTERS, &g));
    add_given(p, a, tangent);
    add_dots(p, "given", c, 1, 2);
    show_curve(p, "curve_arc_tangent", g);
}

static void conics_by_axes(gallery *p) {
    const double x[2] = {0.9, 0.4};
    nurbs *g;
    check(nurbs_curve_ellipse(2, NULL, NULL, x, 2, 1, 0, 1.5 * PI, NURBS_ARC_QUARTERS, &g));
    show_curve(p, "curve_ellipse", g);
    check(nurbs_curve_parabola(2, NULL, NULL, x, 0.3, -1.5, 1.2, &g));
    show_curve(p, "curve_parabola", g);
    check(nurbs_curve_hyperbola(2, NULL, NULL, x, 1, 0.8, -1.6, 1.4, &g));
    show_curve(p, "curve_hyperbola", g);
}

/* From the chord over ellipses, the parabola and hyperbolas to the legs; the factor can be read back. */
static void conics_of_a_triangle(gallery *p) {
    const double p0[2] = {-1, 0}, p1[2] = {0.3, 1.6}, p2[2] = {1, 0};
    const double factors[] = {0, 0.05, 0.3, 1, 4, 30, HUGE_VAL};
    double factor;
    int32_t type;
    nurbs *g;
    int i;
    for (i = 0; i < 7; ++i) {
        check(nurbs_curve_conic_triangle(2, p0, p1, p2, factors[i], &g));
        add_curve(p, g, factors[i] == 1 ? "curve" : "other");
        if (factors[i] > 0 && factors[i] < HUGE_VAL) {
            check(nurbs_curve_shape_factor(g, &factor, &type));
            printf("a conic of shape factor %.4g is %s\n", factor,
                   type == NURBS_CONIC_ELLIPSE    ? "an ellipse"
                   : type == NURBS_CONIC_PARABOLA ? "a parabola"
                                                  : "a hyperbola");
        }
        nurbs_destroy(g);
    }
    end_cell(p, "curve_conic_triangle");
}

static void conics_by_conditions(gallery *p) {
    const double a[2] = {-1, 0}, leaving[2] = {0.2, 1}, b[2] = {1, 0.2}, arriving[2] = {0.5, -1};
    const double middle[2] = {-0.2, 1.3};
    const double points[5][2] = {{-1, 0}, {-0.9, 0.9}, {0.1, 1.3}, {1.2, 0.8}, {1.4, -0.3}};
    nurbs *g;
    check(nurbs_curve_conic_shoulder(2, a, leaving, b, arriving, 0.6, &g));
    add_given(p, a, leaving);
    add_given(p, b, arriving);
    show_curve(p, "curve_conic_shoulder", g);
    check(nurbs_curve_conic_point(2, a, leaving, b, arriving, middle, NURBS_ARC_QUARTERS, &g));
    add_given(p, a, leaving);
    add_given(p, b, arriving);
    add_dots(p, "given", middle, 1, 2);
    show_curve(p, "curve_conic_point", g);
    check(nurbs_curve_conic_through(2, points[0], 0, 0, NURBS_ARC_QUARTERS, &g));
    add_dots(p, "given", points[0], 5, 2);
    show_curve(p, "curve_conic_through", g);
}

/* The axes of an ellipse that is given by its equation. */
static void conic_by_equation(gallery *p) {
    const double coefficients[6] = {5, -4, 3, -6, 2, -4};
    double origin[2], x[2], sizes[2], axes[2][4];
    int32_t type;
    nurbs *g;
    int k;
    check(nurbs_conic_axes(coefficients, &type, origin, x, sizes));
    check(nurbs_curve_conic_implicit(coefficients, 0, 2 * PI, NURBS_ARC_QUARTERS, &g));
    for (k = 0; k < 2; ++k) {
        const double across = k == 0 ? -x[1] : x[0];
        axes[0][k] = origin[k] - sizes[0] * x[k];
        axes[0][2 + k] = origin[k] + sizes[0] * x[k];
        axes[1][k] = origin[k] - sizes[1] * across;
        axes[1][2 + k] = origin[k] + sizes[1] * across;
    }
    add_line(p, "tangent", axes[0], 2, 2);
    add_line(p, "tangent", axes[1], 2, 2);
    add_curve(p, g, "curve");
    end_cell(p, "curve_conic_implicit");
    nurbs_destroy(g);
}

/* One focus, one directrix, three eccentricities. */
static void conics_by_focus(gallery *p) {
    const double focus[2] = {0, 0}, foot[2] = {1.2, 0}, directrix[4] = {1.2, -1.8, 1.2, 1.8};
    const double eccentricities[3] = {0.6, 1, 1.6}, sweeps[3] = {2 * PI, 1.4 * PI, 1.1 * PI};
    nurbs *g;
    int i;
    for (i = 0; i < 3; ++i) {
        check(nurbs_curve_conic_focus(2, focus, NULL, foot, eccentricities[i], -0.5 * sweeps[i], sweeps[i],
                                      NURBS_ARC_QUARTERS, &g));
        add_curve(p, g, i == 1 ? "curve" : "other");
        nurbs_destroy(g);
    }
    add_line(p, "net", directrix, 2, 2);
    add_dots(p, "given", focus, 1, 2);
    end_cell(p, "curve_conic_focus");
}

/* The only curves here that are not exact: to a tolerance, with a proven error. */
static void helices(gallery *p) {
    double error;
    nurbs *g;
    check(nurbs_curve_helix(3, NULL, NULL, NULL, 1, 0, 0.8, 0, 3, 1e-6, &error, &g));
    printf("a helix to 1e-6 has an error of at most %.1e\n", error);
    add_curve(p, g, "curve");
    end_cell(p, "curve_helix");
    nurbs_destroy(g);
    check(nurbs_curve_helix(2, NULL, NULL, NULL, 0, 0.3, 0, 0, 3, 1e-6, NULL, &g));
    add_curve(p, g, "curve");
    end_cell(p, "curve_helix, a spiral");
    nurbs_destroy(g);
}

static void show_curves(gallery *p) {
    lines(p);
    circles(p);
    arcs_through_points(p);
    conics_by_axes(p);
    conics_of_a_triangle(p);
    conics_by_conditions(p);
    conic_by_equation(p);
    conics_by_focus(p);
    helices(p);
}

#endif
