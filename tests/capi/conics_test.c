/* SPDX-License-Identifier: MIT */
/* Arcs of circles and conics by points, tangents and equations: known ones, and what is refused. */
#include "check.h"
#include "shapes.h"

#define VALUES(...) ((const double[]){__VA_ARGS__})
#define PI 3.14159265358979323846

static void check_point(const nurbs *g, double t, const double *expected, int dim, double bound) {
    double point[4];
    CHECK_OK(nurbs_eval(g, 1, &t, 0, 0, point, 0, 0, 0));
    check_doubles(__FILE__, __LINE__, point, expected, dim, bound);
}

static void arcs(void) {
    const int32_t q = NURBS_ARC_QUARTERS;
    nurbs *g = NULL;
    CHECK_OK(
        nurbs_curve_arc_through(2, VALUES(1, 0), VALUES(0, 1), VALUES(0, -1), q, &g)); /* three quarters */
    CHECK_KNOTS(g, 0, VALUES(0, 0, 0, 1.0 / 3, 1.0 / 3, 2.0 / 3, 2.0 / 3, 1, 1, 1));
    check_point(g, 0, VALUES(1, 0), 2, 0);
    check_point(g, 1, VALUES(0, -1), 2, 0);
    check_point(g, 0.5, VALUES(-sqrt(0.5), sqrt(0.5)), 2, 1e-15);
    nurbs_destroy(g);
    CHECK_OK(nurbs_curve_arc_through(4, VALUES(1, 0, 5, 0), VALUES(0, 0, 5, 1), VALUES(-1, 0, 5, 0), 2, &g));
    check_point(g, 0.5, VALUES(0, 0, 5, 1), 4, 1e-15);
    nurbs_destroy(g);
    CHECK_OK(nurbs_curve_arc_tangent(2, VALUES(1, 0), VALUES(0, 7), VALUES(0, 1), q, &g));
    check_point(g, 0.5, VALUES(sqrt(0.5), sqrt(0.5)), 2, 1e-15);
    nurbs_destroy(g);
    CHECK_OK(nurbs_curve_arc_tangent(2, VALUES(1, 0), VALUES(0, 1), VALUES(-1, 0), q, &g));
    check_point(g, 0.5, VALUES(0, 1), 2, 1e-15);
    nurbs_destroy(g);
    CHECK_NO_HANDLE(g, nurbs_curve_arc_through(2, VALUES(0, 0), VALUES(1, 1), VALUES(3, 3), q, &g),
                    NURBS_ERROR_COLLINEAR, "a, b and c|line");
    CHECK_NO_HANDLE(g, nurbs_curve_arc_through(2, VALUES(0, 0), VALUES(0, 0), VALUES(3, 3), q, &g),
                    NURBS_ERROR_COLLINEAR, "equal");
    CHECK_NO_HANDLE(g, nurbs_curve_arc_through(2, VALUES(1, 0), VALUES(0, 1), VALUES(1, 0), q, &g),
                    NURBS_ERROR_COLLINEAR, "equal");
    CHECK_NO_HANDLE(g, nurbs_curve_arc_through(2, VALUES(0, 0), NULL, VALUES(3, 3), q, &g), NURBS_ERROR_NULL,
                    "b");
    CHECK_NO_HANDLE(g, nurbs_curve_arc_through(1, VALUES(0), VALUES(1), VALUES(3), q, &g),
                    NURBS_ERROR_DIMENSION, "dim|1|2");
    CHECK_NO_HANDLE(g, nurbs_curve_arc_through(2, VALUES(0, 0), VALUES(0, 1), VALUES(3, 3), 9, &g),
                    NURBS_ERROR_FORM, "form|9");
    CHECK_NO_HANDLE(g, nurbs_curve_arc_tangent(2, VALUES(0, 0), VALUES(1, 1), VALUES(3, 3), q, &g),
                    NURBS_ERROR_COLLINEAR, "tangent");
    CHECK_NO_HANDLE(g, nurbs_curve_arc_tangent(2, VALUES(0, 0), VALUES(0, 0), VALUES(3, 3), q, &g),
                    NURBS_ERROR_DIRECTION, "tangent|zero");
    CHECK_NO_HANDLE(g, nurbs_curve_arc_tangent(2, VALUES(0, 0), VALUES(0, 1), VALUES(NAN, 3), q, &g),
                    NURBS_ERROR_POINT_NOT_FINITE, "b[0]");
}

static void triangles(void) {
    nurbs *g = NULL;
    const double *a = VALUES(0, 0), *b = VALUES(1, 2), *c = VALUES(2, 0);
    CHECK_OK(nurbs_curve_conic_triangle(2, a, b, c, 0.25, &g));
    CHECK_POINTS(g, VALUES(0, 0, 1, 2, 2, 0));
    CHECK_WEIGHTS(g, VALUES(1, 0.5, 1));
    nurbs_destroy(g);
    CHECK_OK(nurbs_curve_conic_triangle(2, a, b, c, 1, &g));
    int32_t rational = 1;
    CHECK_OK(nurbs_is_rational(g, &rational));
    CHECK_INT(rational, 0);
    nurbs_destroy(g);
    CHECK_OK(nurbs_curve_conic_triangle(2, a, b, c, 0, &g)); /* the chord */
    CHECK_POINTS(g, VALUES(0, 0, 2, 0));
    nurbs_destroy(g);
    CHECK_OK(nurbs_curve_conic_triangle(2, a, b, c, INFINITY, &g)); /* the legs */
    CHECK_POINTS(g, VALUES(0, 0, 1, 2, 2, 0));
    CHECK_KNOTS(g, 0, VALUES(0, 0, 0.5, 1, 1));
    nurbs_destroy(g);
    CHECK_NO_HANDLE(g, nurbs_curve_conic_triangle(2, a, b, c, -0.5, &g), NURBS_ERROR_FACTOR,
                    "shape_factor|-0.5");
    CHECK_NO_HANDLE(g, nurbs_curve_conic_triangle(2, a, b, c, NAN, &g), NURBS_ERROR_FACTOR,
                    "shape_factor|nan");
    CHECK_NO_HANDLE(g, nurbs_curve_conic_triangle(2, a, NULL, c, 1, &g), NURBS_ERROR_NULL, "p1");
    CHECK_NO_HANDLE(g, nurbs_curve_conic_triangle(2, a, b, VALUES(1, NAN), 1, &g),
                    NURBS_ERROR_POINT_NOT_FINITE, "p2[1]");
}

static void shoulders(void) {
    nurbs *g = NULL;
    const double *a = VALUES(0, 0), *b = VALUES(2, 0), *up = VALUES(1, 2), *down = VALUES(3, -6);
    CHECK_OK(nurbs_curve_conic_shoulder(2, a, up, b, down, 0.5, &g)); /* a parabola */
    CHECK_POINTS(g, VALUES(0, 0, 1, 2, 2, 0));
    nurbs_destroy(g);
    CHECK_OK(nurbs_curve_conic_shoulder(2, a, up, b, down, 0.75, &g));
    CHECK_WEIGHTS(g, VALUES(1, 3, 1));
    check_point(g, 0.5, VALUES(1, 1.5), 2, 1e-15);
    nurbs_destroy(g);
    CHECK_NO_HANDLE(g, nurbs_curve_conic_shoulder(2, a, up, b, down, 1, &g), NURBS_ERROR_FACTOR, "rho|1");
    CHECK_NO_HANDLE(g, nurbs_curve_conic_shoulder(2, a, up, b, down, -0.1, &g), NURBS_ERROR_FACTOR,
                    "rho|-0.1");
    CHECK_NO_HANDLE(g, nurbs_curve_conic_shoulder(2, a, up, b, up, 0.5, &g), NURBS_ERROR_CONIC, "tangents");
    CHECK_NO_HANDLE(g, nurbs_curve_conic_shoulder(2, a, VALUES(-1, 2), b, VALUES(-1, -2), 0.5, &g),
                    NURBS_ERROR_CONIC, "tangent_a|tangent_b");
    CHECK_NO_HANDLE(g,
                    nurbs_curve_conic_shoulder(3, VALUES(0, 0, 0), VALUES(1, 2, 0), VALUES(2, 0, 1),
                                               VALUES(1, -2, 0), 0.5, &g),
                    NURBS_ERROR_CONIC, "distance");
    /* The same gap of 2^-23 is a unit of rounding of coordinates of 2^29, and of those alone. */
    for (int far = 0; far < 2; ++far) {
        const double z = far ? 0x1p29 : 0;
        const nurbs_status status = nurbs_curve_conic_shoulder(
            3, VALUES(0, 0, z), VALUES(1, 2, 0), VALUES(2, 0, z + 0x1p-23), VALUES(1, -2, 0), 0.5, &g);
        CHECK_INT(status, far ? NURBS_OK : NURBS_ERROR_CONIC);
        nurbs_destroy(g);
        g = NULL;
    }
    CHECK_NO_HANDLE(g, nurbs_curve_conic_shoulder(2, a, VALUES(0, 0), b, down, 0.5, &g),
                    NURBS_ERROR_DIRECTION, "tangent_a|zero");
}

static void points(void) {
    nurbs *g = NULL;
    const double *a = VALUES(1, 0), *b = VALUES(-1, 0), *up = VALUES(0, 1), *down = VALUES(0, -1);
    CHECK_OK(nurbs_curve_conic_point(2, a, up, b, down, VALUES(0, 2), 0, &g)); /* half an ellipse */
    check_point(g, 0.5, VALUES(0, 2), 2, 1e-15);
    nurbs_destroy(g);
    CHECK_OK(nurbs_curve_conic_point(2, a, up, VALUES(0, -1), VALUES(1, 0), VALUES(0, 1), 1,
                                     &g)); /* 270 degrees */
    check_point(g, 0.5, VALUES(-sqrt(0.5), sqrt(0.5)), 2, 1e-15);
    nurbs_destroy(g);
    CHECK_NO_HANDLE(g, nurbs_curve_conic_point(2, a, up, b, down, VALUES(0, 0), 0, &g), NURBS_ERROR_COLLINEAR,
                    "point");
    CHECK_NO_HANDLE(g, nurbs_curve_conic_point(2, a, up, b, down, VALUES(3, 1), 0, &g), NURBS_ERROR_CONIC,
                    "point");
    CHECK_NO_HANDLE(g, nurbs_curve_conic_point(2, a, VALUES(1, 0), b, down, VALUES(0, 1), 0, &g),
                    NURBS_ERROR_CONIC, "chord");
    CHECK_NO_HANDLE(g, nurbs_curve_conic_point(2, a, up, b, down, VALUES(0, 2), 2, &g), NURBS_ERROR_FORM,
                    "form|2");
    CHECK_NO_HANDLE(g,
                    nurbs_curve_conic_point(3, VALUES(1, 0, 0), VALUES(0, 1, 1), VALUES(-1, 0, 0),
                                            VALUES(0, 1, 0), VALUES(0, 1, 0), 0, &g),
                    NURBS_ERROR_CONIC, "tangent_a|plane");
    CHECK_NO_HANDLE(g,
                    nurbs_curve_conic_point(3, VALUES(1, 0, 0), VALUES(0, 1, 0), VALUES(-1, 0, 0),
                                            VALUES(0, -1, 1), VALUES(0, 1, 0), 0, &g),
                    NURBS_ERROR_CONIC, "tangent_b|plane");
}

static void five_points(void) {
    nurbs *g = NULL;
    const double h = sqrt(0.5);
    CHECK_OK(nurbs_curve_conic_through(2, VALUES(1, 0, h, h, 0, 1, -h, h, -1, 0), 0, 0, 0, &g));
    check_point(g, 0.25, VALUES(h, h), 2, 1e-14);
    check_point(g, 1, VALUES(-1, 0), 2, 0);
    nurbs_destroy(g);
    CHECK_OK(nurbs_curve_conic_through(2, VALUES(-2, -1, 0, 1, 2, 4, 1, 0, 1, 4), 1, 5, 0, &g)); /* y = x^2 */
    check_point(g, 0.5, VALUES(0, 0), 2, 1e-14);
    nurbs_destroy(g);
    CHECK_NO_HANDLE(g, nurbs_curve_conic_through(2, VALUES(1, 0, 0, 1, h, h, -h, h, -1, 0), 0, 0, 0, &g),
                    NURBS_ERROR_CONIC, "points[2]|arc");
    CHECK_NO_HANDLE(g, nurbs_curve_conic_through(2, VALUES(1, 0, 2, 0, 3, 0, 4, 2, 5, 6), 0, 0, 0, &g),
                    NURBS_ERROR_COLLINEAR, "points[0]|points[1]|points[2]");
    CHECK_NO_HANDLE(
        g, nurbs_curve_conic_through(3, VALUES(1, 0, 0, h, h, 0, 0, 1, 0, -h, h, 0.5, -1, 0, 0), 0, 0, 0, &g),
        NURBS_ERROR_CONIC, "points[3]|plane");
    CHECK_NO_HANDLE(g, nurbs_curve_conic_through(2, NULL, 0, 0, 0, &g), NURBS_ERROR_NULL, "points");
    CHECK_NO_HANDLE(g, nurbs_curve_conic_through(2, VALUES(1, 0, 2, 0, 3, 0, 4, 2, 5, NAN), 0, 0, 0, &g),
                    NURBS_ERROR_POINT_NOT_FINITE, "points[4][1]|nan");
    CHECK_NO_HANDLE(g, nurbs_curve_conic_through(2, VALUES(0), -1, 0, 0, &g), NURBS_ERROR_STRIDE,
                    "points|-1");
}

static void equations(void) {
    nurbs *g = NULL;
    CHECK_OK(nurbs_curve_conic_implicit(VALUES(1, 0, 4, -2, 0, -3), 0, 2 * PI, 0,
                                        &g)); /* (x - 1)^2 / 4 + y^2 = 1 */
    double point[2], t = 0.125;
    CHECK_OK(nurbs_eval(g, 1, &t, 0, 0, point, 0, 0, 0));
    CHECK(fabs((point[0] - 1) * (point[0] - 1) / 4 + point[1] * point[1] - 1) < 1e-15);
    nurbs_destroy(g);
    CHECK_OK(nurbs_curve_conic_implicit(VALUES(0, 0, 1, -1, 0, 0), -1, 1, 0, &g)); /* x = y^2 */
    check_point(g, 0, VALUES(0, 0), 2, 1e-15);
    nurbs_destroy(g);
    CHECK_OK(nurbs_curve_conic_implicit(VALUES(1, 0, -1, 0, 0, -1), -1, 1, 0, &g));
    CHECK_OK(nurbs_eval(g, 1, &t, 0, 0, point, 0, 0, 0));
    CHECK(fabs(point[0] * point[0] - point[1] * point[1] - 1) < 1e-14);
    nurbs_destroy(g);
    CHECK_NO_HANDLE(g, nurbs_curve_conic_implicit(VALUES(1, 0, 1, 0, 0, 1), 0, 1, 0, &g), NURBS_ERROR_CONIC,
                    "");
    CHECK_NO_HANDLE(g, nurbs_curve_conic_implicit(VALUES(1, NAN, 1, 0, 0, 1), 0, 1, 0, &g),
                    NURBS_ERROR_FACTOR, "coefficients[1]|nan");
    CHECK_NO_HANDLE(g, nurbs_curve_conic_implicit(VALUES(1, 0, 1, 0, 0, -1), 0, 7, 0, &g), NURBS_ERROR_ANGLE,
                    "7");
    CHECK_NO_HANDLE(g, nurbs_curve_conic_implicit(VALUES(1, 0, 1, 0, 0, -1), 0, 1, 7, &g), NURBS_ERROR_FORM,
                    "form|7");
    CHECK_NO_HANDLE(g, nurbs_curve_conic_implicit(NULL, 0, 1, 0, &g), NURBS_ERROR_NULL, "coefficients");
}

static void focal_conics(void) {
    nurbs *g = NULL;
    const double *f = VALUES(0, 0), *d = VALUES(2, 0);
    CHECK_OK(nurbs_curve_conic_focus(2, f, NULL, d, 1, -PI / 2, PI, 0, &g)); /* r = 2 / (1 + cos a) */
    check_point(g, 0, VALUES(0, -2), 2, 0);
    check_point(g, 0.5, VALUES(1, 0), 2, 1e-15);
    check_point(g, 1, VALUES(0, 2), 2, 0);
    nurbs_destroy(g);
    CHECK_OK(
        nurbs_curve_conic_focus(3, VALUES(0, 0, 1), VALUES(0, 0, 1), VALUES(2, 0, 1), 0.5, 0, 2 * PI, 1, &g));
    double first[3], last[3], t[2] = {0, 1};
    CHECK_OK(nurbs_eval(g, 1, t, 0, 0, first, 0, 0, 0));
    CHECK_OK(nurbs_eval(g, 1, t + 1, 0, 0, last, 0, 0, 0));
    CHECK_BITS(first, last, sizeof first);
    check_doubles(__FILE__, __LINE__, first, VALUES(2.0 / 3, 0, 1), 3, 1e-15);
    nurbs_destroy(g);
    CHECK_NO_HANDLE(g, nurbs_curve_conic_focus(2, f, NULL, d, 2, 0, PI, 0, &g), NURBS_ERROR_CONIC,
                    "infinity");
    CHECK_NO_HANDLE(g, nurbs_curve_conic_focus(2, f, NULL, d, 0, 0, 1, 0, &g), NURBS_ERROR_FACTOR,
                    "eccentricity|0");
    CHECK_NO_HANDLE(g, nurbs_curve_conic_focus(2, f, NULL, f, 1, 0, 1, 0, &g), NURBS_ERROR_DIRECTION,
                    "foot - focus");
    CHECK_NO_HANDLE(
        g, nurbs_curve_conic_focus(3, VALUES(0, 0, 0), VALUES(1, 0, 0), VALUES(1, 0, 0), 1, 0, 1, 0, &g),
        NURBS_ERROR_DIRECTION, "axis|parallel");
    CHECK_NO_HANDLE(g, nurbs_curve_conic_focus(2, f, NULL, d, 1, 0, 0, 0, &g), NURBS_ERROR_ANGLE, "sweep|0");
    CHECK_NO_HANDLE(g, nurbs_curve_conic_focus(2, f, NULL, NULL, 1, 0, 1, 0, &g), NURBS_ERROR_NULL, "foot");
    CHECK_NO_HANDLE(g, nurbs_curve_conic_focus(2, NULL, NULL, d, 1, 0, 1, 0, &g), NURBS_ERROR_NULL, "focus");
    CHECK_NO_HANDLE(g, nurbs_curve_conic_focus(2, f, NULL, d, 1, 0, 1, 2, &g), NURBS_ERROR_FORM, "form|2");
}

int main(void) {
    arcs();
    triangles();
    shoulders();
    points();
    five_points();
    equations();
    focal_conics();
    return check_summary("conics");
}
