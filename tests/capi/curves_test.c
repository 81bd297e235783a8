/* SPDX-License-Identifier: MIT */
/* Lines, arcs, conics in their axes and helices: known control points, and what is refused. */
#include "check.h"
#include "shapes.h"

#define VALUES(...) ((const double[]){__VA_ARGS__})
#define PI 3.14159265358979323846

static void check_point(const nurbs *g, double t, const double *expected, int dim, double bound) {
    double point[4];
    CHECK_OK(nurbs_eval(g, 1, &t, 0, 0, point, 0, 0, 0));
    check_doubles(__FILE__, __LINE__, point, expected, dim, bound);
}

static void lines(void) {
    nurbs *g = NULL;
    CHECK_OK(nurbs_curve_line(3, VALUES(1, 2, 3), VALUES(4, 6, 8), &g));
    CHECK_KNOTS(g, 0, VALUES(0, 0, 1, 1));
    CHECK_POINTS(g, VALUES(1, 2, 3, 4, 6, 8));
    nurbs_destroy(g);
    CHECK_OK(nurbs_curve_line(1, VALUES(-1), VALUES(1), &g));
    CHECK_POINTS(g, VALUES(-1, 1));
    nurbs_destroy(g);
    CHECK_NO_HANDLE(g, nurbs_curve_line(0, VALUES(1), VALUES(2), &g), NURBS_ERROR_DIMENSION, "dim|0");
    CHECK_NO_HANDLE(g, nurbs_curve_line(2, NULL, VALUES(2, 3), &g), NURBS_ERROR_NULL, "a");
    CHECK_NO_HANDLE(g, nurbs_curve_line(2, VALUES(2, 3), NULL, &g), NURBS_ERROR_NULL, "b");
    CHECK_NO_HANDLE(g, nurbs_curve_line(2, VALUES(2, 3), VALUES(2, NAN), &g), NURBS_ERROR_POINT_NOT_FINITE,
                    "b[1]|nan");
    CHECK_FAILS(nurbs_curve_line(2, VALUES(2, 3), VALUES(2, 4), NULL), NURBS_ERROR_NULL, "out");
}

static void polylines(void) {
    nurbs *g = NULL;
    CHECK_OK(nurbs_curve_polyline(3, 2, VALUES(0, 0, 1, 0, 1, 2), 0, 0, NULL, 0, &g));
    CHECK_KNOTS(g, 0, VALUES(0, 0, 1, 2, 2));
    CHECK_POINTS(g, VALUES(0, 0, 1, 0, 1, 2));
    nurbs_destroy(g);
    CHECK_OK(nurbs_curve_polyline(3, 2, VALUES(0, 1, 1, 0, 0, 2), 1, 3, VALUES(-1, 9, 0, 9, 2), 2, &g));
    CHECK_KNOTS(g, 0, VALUES(-1, -1, 0, 2, 2));
    CHECK_POINTS(g, VALUES(0, 0, 1, 0, 1, 2));
    nurbs_destroy(g);
    CHECK_NO_HANDLE(g, nurbs_curve_polyline(1, 2, VALUES(0, 0), 0, 0, NULL, 0, &g),
                    NURBS_ERROR_TOO_FEW_POINTS, "n|1|2");
    CHECK_NO_HANDLE(g, nurbs_curve_polyline(0, 2, NULL, 0, 0, NULL, 0, &g), NURBS_ERROR_TOO_FEW_POINTS,
                    "n|0");
    CHECK_NO_HANDLE(g, nurbs_curve_polyline(-1, 2, VALUES(0, 0), 0, 0, NULL, 0, &g), NURBS_ERROR_COUNT,
                    "n|-1");
    CHECK_NO_HANDLE(g, nurbs_curve_polyline(2, 2, NULL, 0, 0, NULL, 0, &g), NURBS_ERROR_NULL, "points");
    CHECK_NO_HANDLE(g, nurbs_curve_polyline(2, 2, VALUES(0, 0, 1, 1), 1, 0, NULL, 0, &g), NURBS_ERROR_STRIDE,
                    "points");
    CHECK_NO_HANDLE(g, nurbs_curve_polyline(2, 2, VALUES(0, 0, 1, INFINITY), 0, 0, NULL, 0, &g),
                    NURBS_ERROR_POINT_NOT_FINITE, "points|inf");
    CHECK_NO_HANDLE(g, nurbs_curve_polyline(2, 1, VALUES(0, 1), 0, 0, VALUES(3, 3), 0, &g),
                    NURBS_ERROR_KNOTS_DECREASING, "params[1]|params[0]|3");
    CHECK_NO_HANDLE(g, nurbs_curve_polyline(2, 1, VALUES(0, 1), 0, 0, VALUES(3, NAN), 0, &g),
                    NURBS_ERROR_PARAMETER_NOT_FINITE, "params[1]|nan");
    CHECK_NO_HANDLE(g, nurbs_curve_polyline(INT64_MAX, 2, VALUES(0, 1), 0, 0, NULL, 0, &g),
                    NURBS_ERROR_OVERFLOW, "points");
}

static void polygons(void) {
    nurbs *g = NULL;
    CHECK_OK(nurbs_curve_polygon(2, VALUES(1, 1), NULL, NULL, 2, 4, &g));
    CHECK_POINTS(g, VALUES(3, 1, 1, 3, -1, 1, 1, -1, 3, 1));
    CHECK_KNOTS(g, 0, VALUES(0, 0, 0.25, 0.5, 0.75, 1, 1));
    nurbs_destroy(g);
    CHECK_OK(nurbs_curve_polygon(3, NULL, VALUES(0, 0, 5), VALUES(0, 2, 9), 1, 4, &g));
    CHECK_POINTS(g, VALUES(0, 1, 0, -1, 0, 0, 0, -1, 0, 1, 0, 0, 0, 1, 0));
    nurbs_destroy(g);
    CHECK_NO_HANDLE(g, nurbs_curve_polygon(2, NULL, NULL, NULL, 1, 2, &g), NURBS_ERROR_COUNT, "sides|2|3");
    CHECK_NO_HANDLE(g, nurbs_curve_polygon(2, NULL, NULL, NULL, 0, 3, &g), NURBS_ERROR_LENGTH, "radius|0");
    CHECK_NO_HANDLE(g, nurbs_curve_polygon(2, NULL, NULL, NULL, 1, INT64_MAX, &g), NURBS_ERROR_OVERFLOW,
                    "sides");
    CHECK_NO_HANDLE(g, nurbs_curve_polygon(4, NULL, NULL, NULL, 1, 3, &g), NURBS_ERROR_DIMENSION, "dim|4");
}

static void rectangles(void) {
    const double h = HALF_ROOT;
    nurbs *g = NULL;
    CHECK_OK(nurbs_curve_rounded_rectangle(2, NULL, NULL, NULL, 6, 4, 1, &g));
    CHECK_POINTS(g, VALUES(-2, -2, 0, -2, 2, -2, 3, -2, 3, -1, 3, 0, 3, 1, 3, 2, 2, 2, 0, 2, -2, 2, -3, 2, -3,
                           1, -3, 0, -3, -1, -3, -2, -2, -2));
    CHECK_WEIGHTS(g, VALUES(1, 1, 1, h, 1, 1, 1, h, 1, 1, 1, h, 1, 1, 1, h, 1));
    nurbs_destroy(g);
    CHECK_OK(
        nurbs_curve_rounded_rectangle(2, VALUES(1, 0), NULL, NULL, 6, 4, 2, &g)); /* no sides left upright */
    CHECK_POINTS(
        g, VALUES(0, -2, 1, -2, 2, -2, 4, -2, 4, 0, 4, 2, 2, 2, 1, 2, 0, 2, -2, 2, -2, 0, -2, -2, 0, -2));
    nurbs_destroy(g);
    CHECK_OK(nurbs_curve_rounded_rectangle(2, NULL, NULL, NULL, 6, 4, 0, &g));
    CHECK_POINTS(g, VALUES(-3, -2, 3, -2, 3, 2, -3, 2, -3, -2));
    nurbs_destroy(g);
    CHECK_NO_HANDLE(g, nurbs_curve_rounded_rectangle(2, NULL, NULL, NULL, 6, 4, 2.5, &g), NURBS_ERROR_LENGTH,
                    "corner_radius|2.5|2");
    CHECK_NO_HANDLE(g, nurbs_curve_rounded_rectangle(2, NULL, NULL, NULL, 6, 4, -1, &g), NURBS_ERROR_LENGTH,
                    "corner_radius|-1");
    CHECK_NO_HANDLE(g, nurbs_curve_rounded_rectangle(2, NULL, NULL, NULL, NAN, 4, 1, &g), NURBS_ERROR_LENGTH,
                    "width|nan");
    CHECK_NO_HANDLE(g, nurbs_curve_rounded_rectangle(2, NULL, NULL, NULL, 1, -4, 1, &g), NURBS_ERROR_LENGTH,
                    "height|-4");
}

static void circles(void) {
    const double h = HALF_ROOT, root3 = 1.7320508075688772;
    nurbs *g = NULL;
    CHECK_OK(nurbs_curve_circle(2, VALUES(10, 20), NULL, NULL, 2, NURBS_ARC_QUARTERS, &g));
    CHECK_POINTS(g, VALUES(12, 20, 12, 22, 10, 22, 8, 22, 8, 20, 8, 18, 10, 18, 12, 18, 12, 20));
    CHECK_WEIGHTS(g, VALUES(1, h, 1, h, 1, h, 1, h, 1));
    CHECK_KNOTS(g, 0, VALUES(0, 0, 0, 0.25, 0.25, 0.5, 0.5, 0.75, 0.75, 1, 1, 1));
    nurbs_destroy(g);
    CHECK_OK(nurbs_curve_circle(2, NULL, NULL, VALUES(0, -3), 1, NURBS_ARC_THIRDS, &g));
    CHECK_WEIGHTS(g, VALUES(1, 0.5, 1, 0.5, 1, 0.5, 1));
    check_point(g, 0, VALUES(0, -1), 2, 0);
    check_point(g, 0.5, VALUES(0, 1), 2, 1e-15);
    nurbs_destroy(g);
    CHECK_OK(nurbs_curve_circle(3, NULL, NULL, NULL, 1, NURBS_ARC_SMOOTH, &g));
    CHECK_POINTS(g, VALUES(1, 0, 0, 1, 4, 0, -3, 2, 0, -3, -2, 0, 1, -4, 0, 1, 0, 0));
    CHECK_WEIGHTS(g, VALUES(1, 0.2, 0.2, 0.2, 0.2, 1));
    nurbs_destroy(g);
    CHECK_OK(nurbs_curve_arc(2, NULL, NULL, NULL, 2, PI / 6, -PI / 2, NURBS_ARC_QUARTERS, &g));
    check_point(g, 0, VALUES(root3, 1), 2, 0);
    check_point(g, 1, VALUES(1, -root3), 2, 0);
    nurbs_destroy(g);
    CHECK_OK(nurbs_curve_arc(3, VALUES(1, 1, 1), VALUES(0, 3, 0), VALUES(1, 7, 0), 1, 0, PI, NURBS_ARC_THIRDS,
                             &g));
    check_point(g, 0, VALUES(2, 1, 1), 3, 0); /* Z = y, X = x, Y = -z */
    check_point(g, 0.5, VALUES(1, 1, 0), 3, 1e-15);
    check_point(g, 1, VALUES(0, 1, 1), 3, 0);
    nurbs_destroy(g);
    CHECK_OK(nurbs_curve_ellipse(2, NULL, NULL, NULL, 3, 2, 0, 2 * PI, NURBS_ARC_QUARTERS, &g));
    CHECK_POINTS(g, VALUES(3, 0, 3, 2, 0, 2, -3, 2, -3, 0, -3, -2, 0, -2, 3, -2, 3, 0));
    nurbs_destroy(g);
}

static void arcs_refused(void) {
    nurbs *g = NULL;
    const int32_t q = NURBS_ARC_QUARTERS;
    CHECK_NO_HANDLE(g, nurbs_curve_circle(2, NULL, NULL, NULL, 0, q, &g), NURBS_ERROR_LENGTH, "radius|0");
    CHECK_NO_HANDLE(g, nurbs_curve_circle(2, NULL, NULL, NULL, -1, q, &g), NURBS_ERROR_LENGTH, "radius|-1");
    CHECK_NO_HANDLE(g, nurbs_curve_circle(2, NULL, NULL, NULL, INFINITY, q, &g), NURBS_ERROR_LENGTH,
                    "radius|inf");
    CHECK_NO_HANDLE(g, nurbs_curve_circle(2, NULL, NULL, NULL, 1, 3, &g), NURBS_ERROR_FORM, "form|3");
    CHECK_NO_HANDLE(g, nurbs_curve_circle(2, NULL, NULL, NULL, 1, -1, &g), NURBS_ERROR_FORM, "form|-1");
    CHECK_NO_HANDLE(g, nurbs_curve_circle(1, NULL, NULL, NULL, 1, q, &g), NURBS_ERROR_DIMENSION,
                    "dim|1|2 or 3");
    CHECK_NO_HANDLE(g, nurbs_curve_circle(2, VALUES(0, NAN), NULL, NULL, 1, q, &g),
                    NURBS_ERROR_POINT_NOT_FINITE, "center[1]");
    CHECK_NO_HANDLE(g, nurbs_curve_circle(2, NULL, VALUES(0, 0, 1), NULL, 1, q, &g), NURBS_ERROR_DIRECTION,
                    "axis|NULL");
    CHECK_NO_HANDLE(g, nurbs_curve_circle(3, NULL, VALUES(0, 0, 0), NULL, 1, q, &g), NURBS_ERROR_DIRECTION,
                    "axis|zero");
    CHECK_NO_HANDLE(g, nurbs_curve_circle(3, NULL, VALUES(0, INFINITY, 0), NULL, 1, q, &g),
                    NURBS_ERROR_DIRECTION, "axis[1]");
    CHECK_NO_HANDLE(g, nurbs_curve_circle(3, NULL, VALUES(1, 1, 0), VALUES(-2, -2, 0), 1, q, &g),
                    NURBS_ERROR_DIRECTION, "x|parallel");
    CHECK_NO_HANDLE(g, nurbs_curve_circle(2, NULL, NULL, VALUES(0, 0), 1, q, &g), NURBS_ERROR_DIRECTION,
                    "x|zero");
    CHECK_NO_HANDLE(g, nurbs_curve_arc(2, NULL, NULL, NULL, 1, 0, 0, q, &g), NURBS_ERROR_ANGLE, "sweep|0");
    CHECK_NO_HANDLE(g, nurbs_curve_arc(2, NULL, NULL, NULL, 1, 0, 6.3, q, &g), NURBS_ERROR_ANGLE,
                    "sweep|6.3|full turn");
    CHECK_NO_HANDLE(g, nurbs_curve_arc(2, NULL, NULL, NULL, 1, 0, NAN, q, &g), NURBS_ERROR_ANGLE,
                    "sweep|nan");
    CHECK_NO_HANDLE(g, nurbs_curve_arc(2, NULL, NULL, NULL, 1, INFINITY, 1, q, &g), NURBS_ERROR_ANGLE,
                    "start|inf");
    CHECK_NO_HANDLE(g, nurbs_curve_ellipse(2, NULL, NULL, NULL, 1, 0, 0, 1, q, &g), NURBS_ERROR_LENGTH,
                    "radius_y|0");
    CHECK_NO_HANDLE(g, nurbs_curve_ellipse(2, NULL, NULL, NULL, NAN, 1, 0, 1, q, &g), NURBS_ERROR_LENGTH,
                    "radius_x|nan");
}

static void parabolas_and_hyperbolas(void) {
    nurbs *g = NULL;
    CHECK_OK(nurbs_curve_parabola(2, VALUES(1, 0), NULL, NULL, 0.25, -1, 2, &g)); /* (1 + t^2, t) */
    CHECK_KNOTS(g, 0, VALUES(-1, -1, -1, 2, 2, 2));
    CHECK_POINTS(g, VALUES(2, -1, -1, 0.5, 5, 2));
    check_point(g, 0.5, VALUES(1.25, 0.5), 2, 0);
    nurbs_destroy(g);
    CHECK_OK(nurbs_curve_hyperbola(2, NULL, NULL, NULL, 2, 3, -1, 1, &g));
    check_point(g, 0.5, VALUES(2, 0), 2, 1e-15);
    CHECK_WEIGHTS(g, VALUES(1, cosh(1), 1));
    nurbs_destroy(g);
    CHECK_OK(nurbs_curve_hyperbola(3, NULL, NULL, NULL, 1, 1, 0, 5, &g));
    CHECK_KNOTS(g, 0, VALUES(0, 0, 0, 1.0 / 3, 1.0 / 3, 2.0 / 3, 2.0 / 3, 1, 1, 1));
    check_point(g, 1, VALUES(cosh(5), sinh(5), 0), 3, 1e-13);
    nurbs_destroy(g);
    CHECK_NO_HANDLE(g, nurbs_curve_parabola(2, NULL, NULL, NULL, 0, 0, 1, &g), NURBS_ERROR_LENGTH,
                    "focal_length|0");
    CHECK_NO_HANDLE(g, nurbs_curve_parabola(2, NULL, NULL, NULL, 1, 1, 1, &g), NURBS_ERROR_EMPTY_DOMAIN,
                    "start|1|end");
    CHECK_NO_HANDLE(g, nurbs_curve_parabola(2, NULL, NULL, NULL, 1, NAN, 1, &g),
                    NURBS_ERROR_PARAMETER_NOT_FINITE, "start|nan");
    CHECK_NO_HANDLE(g, nurbs_curve_parabola(2, NULL, NULL, NULL, 1e-300, 0, 1e10, &g),
                    NURBS_ERROR_NOT_REPRESENTABLE, "");
    CHECK_NO_HANDLE(g, nurbs_curve_hyperbola(2, NULL, NULL, NULL, 1, -2, 0, 1, &g), NURBS_ERROR_LENGTH,
                    "radius_y|-2");
    CHECK_NO_HANDLE(g, nurbs_curve_hyperbola(2, NULL, NULL, NULL, 1, 1, 0, INFINITY, &g),
                    NURBS_ERROR_PARAMETER_NOT_FINITE, "end|inf");
    CHECK_NO_HANDLE(g, nurbs_curve_hyperbola(2, NULL, NULL, NULL, 1, 1, 0, 800, &g),
                    NURBS_ERROR_NOT_REPRESENTABLE, "");
    CHECK_NO_HANDLE(g, nurbs_curve_hyperbola(2, NULL, NULL, NULL, 1, 1, -1e308, 1e308, &g),
                    NURBS_ERROR_NOT_REPRESENTABLE, "hyperbola");
}

static void helices(void) {
    nurbs *g = NULL;
    double error = -1;
    CHECK_OK(nurbs_curve_helix(3, NULL, NULL, NULL, 2, 0, 3, 0, 2, 1e-6, &error, &g));
    CHECK(error > 0 && error <= 1e-6);
    check_point(g, 0, VALUES(2, 0, 0), 3, 0);
    check_point(g, 2, VALUES(2, 0, 6), 3, 0);
    check_point(g, 1, VALUES(2, 0, 3), 3, 1e-15);
    nurbs_destroy(g);
    CHECK_OK(
        nurbs_curve_helix(2, VALUES(1, 1), NULL, NULL, 0, 1, 0, PI / 2, 1, 1e-3, NULL, &g)); /* a spiral */
    check_point(g, 0, VALUES(1, 1), 2, 0);
    check_point(g, 1, VALUES(1, 2), 2, 0);
    nurbs_destroy(g);
    /* 0.3 - 3 * 0.1 is less than 0 by rounding: the end is on the axis */
    CHECK_OK(nurbs_curve_helix(3, NULL, NULL, NULL, 0.3, -0.1, 1, 0, 3, 1e-3, NULL, &g));
    check_point(g, 3, VALUES(0, 0, 3), 3, 0);
    nurbs_destroy(g);
    error = -1;
    CHECK_NO_HANDLE(g, nurbs_curve_helix(3, NULL, NULL, NULL, 0, 0, 1, 0, 1, 1, &error, &g),
                    NURBS_ERROR_LENGTH, "radius|0");
    CHECK(error == -1);
    CHECK_NO_HANDLE(g, nurbs_curve_helix(3, NULL, NULL, NULL, 1, -1, 1, 0, 2, 1, NULL, &g),
                    NURBS_ERROR_LENGTH, "growth|turns|-1");
    CHECK_NO_HANDLE(g, nurbs_curve_helix(3, NULL, NULL, NULL, 1, NAN, 1, 0, 2, 1, NULL, &g),
                    NURBS_ERROR_LENGTH, "growth|nan");
    CHECK_NO_HANDLE(g, nurbs_curve_helix(2, NULL, NULL, NULL, 1, 0, 1, 0, 2, 1, NULL, &g), NURBS_ERROR_LENGTH,
                    "pitch|dimension 2");
    CHECK_NO_HANDLE(g, nurbs_curve_helix(3, NULL, NULL, NULL, 1, 0, 1, 0, 0, 1, NULL, &g), NURBS_ERROR_FACTOR,
                    "turns|0");
    CHECK_NO_HANDLE(g, nurbs_curve_helix(3, NULL, NULL, NULL, 1, 0, 1, NAN, 1, 1, NULL, &g),
                    NURBS_ERROR_ANGLE, "start|nan");
    CHECK_NO_HANDLE(g, nurbs_curve_helix(3, NULL, NULL, NULL, 1, 0, 1, 0, 1, 0, NULL, &g),
                    NURBS_ERROR_TOLERANCE, "tolerance|0");
    CHECK_NO_HANDLE(g, nurbs_curve_helix(3, NULL, NULL, NULL, 1, 0, 1, 0, 1, 1e-200, NULL, &g),
                    NURBS_ERROR_OVERFLOW, "1e-200|pieces");
    CHECK_FAILS(nurbs_curve_helix(3, NULL, NULL, NULL, 1, 0, 1, 0, 1, 1, NULL, NULL), NURBS_ERROR_NULL,
                "out");
}

int main(void) {
    lines();
    polylines();
    polygons();
    rectangles();
    circles();
    arcs_refused();
    parabolas_and_hyperbolas();
    helices();
    return check_summary("curves");
}
