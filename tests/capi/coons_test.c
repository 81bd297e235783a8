/* SPDX-License-Identifier: MIT */
/* Surfaces and volumes from their boundaries: known values, gaps, and what is refused. */
#include "check.h"
#include "shapes.h"

#define VALUES(...) ((const double[]){__VA_ARGS__})

/* A Bezier curve in space over [0, 1]. */
static nurbs *bezier(int32_t degree, const double *points, const double *weights) {
    nurbs *g = NULL;
    CHECK_OK(nurbs_create_bezier(1, &degree, 3, points, 0, 0, weights, 0, &g));
    return g;
}

typedef struct Curves {
    nurbs *curves[4];
} Curves;

static const nurbs *const *handles(const Curves *c) {
    return (const nurbs *const *)c->curves;
}

static void destroy(Curves *c) {
    for (int i = 0; i < 4; ++i) {
        nurbs_destroy(c->curves[i]);
    }
}

/* The unit square with an arch over boundary 2. */
static Curves arched(void) {
    Curves c = {{bezier(1, VALUES(0, 0, 0, 0, 1, 0), NULL), bezier(1, VALUES(1, 0, 0, 1, 1, 0), NULL),
                 bezier(2, VALUES(0, 0, 0, 0.5, 0, 1, 1, 0, 0), NULL),
                 bezier(1, VALUES(0, 1, 0, 1, 1, 0), NULL)}};
    return c;
}

static void replace(Curves *c, int i, nurbs *g) {
    nurbs_destroy(c->curves[i]);
    c->curves[i] = g;
}

static void check_eval(const nurbs *g, const double *params, const double *expected) {
    double point[3];
    CHECK_OK(nurbs_eval(g, 1, params, 0, 0, point, 0, 0, 0));
    CHECK_NEAR(point, expected, 3, 1e-15);
}

static void bilinear(void) {
    Curves c = arched();
    nurbs *g = NULL;
    CHECK_OK(nurbs_surface_coons(handles(&c), 0, &g));
    CHECK_POINTS(g, VALUES(0, 0, 0, 0, 1, 0, 0.5, 0, 1, 0.5, 1, 0, 1, 0, 0, 1, 1, 0));
    check_eval(g, VALUES(0.5, 0.5), VALUES(0.5, 0.5, 0.25));
    nurbs_destroy(g);
    destroy(&c);
}

static void boundaries(void) {
    static const char *const names[] = {"0-", "0+", "1-", "1+", "2-", "2+"};
    nurbs *g = make(cube());
    nurbs_list *list = NULL;
    int64_t count = 0;
    CHECK_OK(nurbs_boundaries(g, &list));
    CHECK_OK(nurbs_list_count(list, &count));
    CHECK_INT(count, 6);
    for (int64_t i = 0; i < count; ++i) {
        char name[8];
        nurbs *face = NULL, *iso = NULL;
        double point[4], same[4];
        CHECK_OK(nurbs_list_name(list, i, name, sizeof name, NULL));
        CHECK(strcmp(name, names[i]) == 0);
        CHECK_OK(nurbs_list_get(list, i, &face));
        CHECK_OK(nurbs_iso(g, (int32_t)(i / 2), (double)(i % 2), 0, &iso));
        CHECK_OK(nurbs_eval(face, 1, VALUES(0.25, 0.75), 0, 0, point, 0, 0, 0));
        CHECK_OK(nurbs_eval(iso, 1, VALUES(0.25, 0.75), 0, 0, same, 0, 0, 0));
        CHECK_BITS(point, same, 3 * sizeof *point);
        nurbs_destroy(face);
        nurbs_destroy(iso);
    }
    nurbs_list_destroy(list);
    nurbs_destroy(g);
    g = make(patch());
    CHECK_OK(nurbs_boundaries(g, &list));
    CHECK_OK(nurbs_list_count(list, &count));
    CHECK_INT(count, 4);
    nurbs_list_destroy(list);
    nurbs_destroy(g);
    g = make(arch());
    list = (nurbs_list *)(void *)check_poison();
    CHECK_FAILS(nurbs_boundaries(g, &list), NURBS_ERROR_AXES, "g is a curve");
    CHECK(list == NULL);
    CHECK_FAILS(nurbs_boundaries(NULL, &list), NURBS_ERROR_NULL, "g");
    CHECK_FAILS(nurbs_boundaries(g, NULL), NURBS_ERROR_NULL, "out");
    nurbs_destroy(g);
}

/* Corner (u0, v1) is 0.25 away, in the end of boundary 0; corner (u1, v0) 0.5, in that of boundary 2. */
static void gaps(void) {
    static const double expected[] = {0, 0.25, 0.5, 0};
    Curves c = arched();
    nurbs *g = NULL;
    double positions[4], tangents[8], twists[4];
    replace(&c, 0, bezier(1, VALUES(0, 0, 0, 0.25, 1, 0), NULL));
    replace(&c, 2, bezier(1, VALUES(0, 0, 0, 1, 0, 0.5), NULL));
    CHECK_OK(nurbs_coons_gaps(handles(&c), NULL, positions, tangents, twists));
    CHECK_DOUBLES(positions, expected, 4);
    CHECK_DOUBLES(tangents, VALUES(0, 0, 0, 0, 0, 0, 0, 0), 8);
    CHECK_DOUBLES(twists, VALUES(0, 0, 0, 0), 4);
    CHECK_OK(nurbs_coons_gaps(handles(&c), NULL, positions, NULL, NULL));
    CHECK_NO_HANDLE(g, nurbs_surface_coons(handles(&c), 0.25, &g), NURBS_ERROR_GAP,
                    "corner (u1, v0)|boundaries[1]|boundaries[2]|0.5|0.25");
    CHECK_NO_HANDLE(g, nurbs_surface_coons(handles(&c), 0, &g), NURBS_ERROR_GAP, "corner (u0, v1)|0.25");
    CHECK_OK(nurbs_surface_coons(handles(&c), 0.5, &g));
    CHECK_POINTS(g, VALUES(0, 0, 0, 0.125, 1, 0, 1, 0, 0.25, 1, 1, 0));
    nurbs_destroy(g);
    CHECK_FAILS(nurbs_coons_gaps(handles(&c), NULL, NULL, tangents, twists), NURBS_ERROR_NULL, "positions");
    CHECK_FAILS(nurbs_coons_gaps(NULL, NULL, positions, NULL, NULL), NURBS_ERROR_NULL, "boundaries");
    CHECK_FAILS(nurbs_coons_gaps(handles(&c), NULL, positions, positions, NULL), NURBS_ERROR_OVERLAP,
                "positions");
    destroy(&c);
}

static void refused_curves(void) {
    Curves c = arched();
    nurbs *g = NULL, *flat = make(arch()), *surface = make(patch()), *kept = c.curves[3];
    CHECK_NO_HANDLE(g, nurbs_surface_coons(NULL, 0, &g), NURBS_ERROR_NULL, "boundaries");
    CHECK_FAILS(nurbs_surface_coons(handles(&c), 0, NULL), NURBS_ERROR_NULL, "out");
    CHECK_NO_HANDLE(g, nurbs_surface_coons(handles(&c), -1, &g), NURBS_ERROR_TOLERANCE, "tolerance = -1");
    CHECK_NO_HANDLE(g, nurbs_surface_coons(handles(&c), NAN, &g), NURBS_ERROR_TOLERANCE, "tolerance = nan");
    c.curves[3] = NULL;
    CHECK_NO_HANDLE(g, nurbs_surface_coons(handles(&c), 0, &g), NURBS_ERROR_NULL, "boundaries[3]");
    c.curves[3] = flat;
    CHECK_NO_HANDLE(g, nurbs_surface_coons(handles(&c), 0, &g), NURBS_ERROR_DIMENSION,
                    "boundaries[3]|dimension 2");
    c.curves[3] = surface;
    CHECK_NO_HANDLE(g, nurbs_surface_coons(handles(&c), 0, &g), NURBS_ERROR_AXES, "boundaries[3]|2 axes");
    c.curves[3] = kept;
    nurbs_destroy(flat);
    nurbs_destroy(surface);
    destroy(&c);
}

/* Ends at infinity, and degrees that would be too high: two rational curves of degree 16. */
static void refused_weights(void) {
    Curves c = arched();
    nurbs *g = NULL, *far = NULL;
    static const int32_t one = 1;
    double points[51] = {0}, weights[17];
    CHECK_OK(nurbs_create_homogeneous(1, &one, (const int64_t[]){2}, VALUES(0, 0, 1, 1), 4, 3,
                                      VALUES(0, 0, 1, 0, 1, 0, 0, 1), 0, 0, 0, &far));
    replace(&c, 2, far);
    CHECK_NO_HANDLE(g, nurbs_surface_coons(handles(&c), 10, &g), NURBS_ERROR_WEIGHTS_VANISH,
                    "boundaries[2]|start|infinity");
    for (int i = 0; i < 17; ++i) {
        points[3 * i] = i / 16.0;
        weights[i] = 1 + i % 3;
    }
    replace(&c, 2, bezier(16, points, weights));
    weights[3] = 7;
    replace(&c, 3, bezier(16, points, weights));
    CHECK_NO_HANDLE(g, nurbs_surface_coons(handles(&c), 10, &g), NURBS_ERROR_DEGREE, "limit of 31");
    destroy(&c);
}

/* Straight cross tangents of the unit square, but for a factor. */
static Curves straight(double factor) {
    Curves c = {{bezier(1, VALUES(factor, 0, 0, 1, 0, 0), NULL), bezier(1, VALUES(1, 0, 0, 1, 0, 0), NULL),
                 bezier(1, VALUES(0, 1, 0, 0, 1, 0), NULL), bezier(1, VALUES(0, 1, 0, 0, 1, 0), NULL)}};
    return c;
}

static Curves square(void) {
    Curves c = arched();
    replace(&c, 2, bezier(1, VALUES(0, 0, 0, 1, 0, 0), NULL));
    return c;
}

static nurbs_status hermite(const Curves *c, const Curves *cross, int32_t twist, const double *twists,
                            double tolerance, double *bound, nurbs **out) {
    return nurbs_surface_coons_hermite(handles(c), cross == NULL ? NULL : handles(cross), twist, twists,
                                       tolerance, bound, out);
}

static void bicubic(void) {
    static const double bent[] = {0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1};
    Curves c = square(), cross = straight(1);
    nurbs *g = NULL;
    double bound = -1, derivatives[18];
    CHECK_OK(hermite(&c, &cross, NURBS_TWIST_COMPATIBLE, NULL, 0, &bound, &g));
    CHECK_DOUBLE(bound, 0);
    check_eval(g, VALUES(0.25, 0.75), VALUES(0.25, 0.75, 0));
    nurbs_destroy(g);
    CHECK_OK(hermite(&c, &cross, NURBS_TWIST_GIVEN, bent, 0, &bound, &g));
    CHECK_DOUBLE(bound, 1);
    CHECK_OK(nurbs_eval_derivs(g, 2, 1, VALUES(1, 0), 0, 0, derivatives, 0, 0, 0));
    CHECK_NEAR(derivatives + 12, VALUES(0, 0, 1), 3, 1e-13); /* S_uv */
    nurbs_destroy(g);
    CHECK_OK(hermite(&c, NULL, NURBS_TWIST_BILINEAR, NULL, 0, NULL, &g));
    check_eval(g, VALUES(0.25, 0.75), VALUES(0.25, 0.75, 0));
    nurbs_destroy(g);
    destroy(&c);
    destroy(&cross);
}

/* The surface (u, v, u^3 + u v + v^2) over [0, 2] x [0, 3]. */
static nurbs *over_a_rectangle(void) {
    static const int32_t degrees[] = {3, 2};
    static const int64_t counts[] = {4, 3};
    static const double knots[] = {0, 0, 0, 0, 2, 2, 2, 2, 0, 0, 0, 3, 3, 3};
    nurbs *g = NULL;
    double points[36];
    for (int i = 0; i < 12; ++i) {
        const double u = 2 * (i / 3) / 3.0, v = 1.5 * (i % 3); /* Greville abscissae */
        points[3 * i] = u;
        points[3 * i + 1] = v;
        points[3 * i + 2] = (i / 3 == 3 ? 8 : 0) + u * v + (i % 3 == 2 ? 9 : 0);
    }
    CHECK_OK(nurbs_create(2, degrees, counts, knots, 14, 3, points, 0, 0, NULL, 0, 0, &g));
    return g;
}

/* Its boundaries, or the derivatives across them. */
static Curves around(const nurbs *g, int32_t derivative) {
    Curves c;
    for (int32_t i = 0; i < 4; ++i) {
        nurbs *across = NULL;
        CHECK_OK(nurbs_derivative(g, i / 2, derivative, &across));
        CHECK_OK(nurbs_iso(across, i / 2, i % 2 * (i < 2 ? 2 : 3), 0, &c.curves[i]));
        nurbs_destroy(across);
    }
    return c;
}

/* A bicubic surface is what its boundaries, cross tangents and twists make, over a domain that is no square;
 * without cross tangents too, as those here are cubics of their ends, and Adini's twists those of the
 * surface. */
static void rectangle(void) {
    nurbs *surface = over_a_rectangle(), *g = NULL;
    Curves c = around(surface, 0), cross = around(surface, 1);
    for (int with = 0; with < 2; ++with) {
        CHECK_OK(hermite(&c, with ? &cross : NULL, with ? NURBS_TWIST_COMPATIBLE : NURBS_TWIST_ADINI, NULL,
                         1e-12, NULL, &g));
        for (int i = 0; i < 25; ++i) {
            const double u = i / 5 * 0.5, v = i % 5 * 0.75;
            double at[3];
            CHECK_OK(nurbs_eval(g, 1, ((const double[]){u, v}), 0, 0, at, 0, 0, 0));
            CHECK_NEAR(at, ((const double[]){u, v, u * u * u + u * v + v * v}), 3, 1e-13);
        }
        nurbs_destroy(g);
    }
    destroy(&c);
    destroy(&cross);
    nurbs_destroy(surface);
}

/* The same curve of homogeneous records. */
static nurbs *in_records(const nurbs *g) {
    int32_t degree = 0;
    int64_t count = 0;
    double knots[32], records[64];
    nurbs *h = NULL;
    CHECK_OK(nurbs_degree(g, 0, &degree));
    CHECK_OK(nurbs_count(g, 0, &count));
    CHECK_OK(nurbs_knots(g, 0, count + degree + 1, knots));
    CHECK_OK(nurbs_homogeneous_points(g, count, records, 0, 0));
    CHECK_OK(
        nurbs_create_homogeneous(1, &degree, &count, knots, count + degree + 1, 3, records, 0, 0, 0, &h));
    return h;
}

/* Gaps are those of the curves, however they are stored. */
static void gaps_of_records(void) {
    static const double weights[] = {1, 3, 0.5};
    Curves c, cross, stored, stored_cross;
    double positions[8], tangents[16], twists[8];
    for (int i = 0; i < 4; ++i) {
        const double points[] = {i, 0, 1, 1, i, 2, 0, 2, i}, other[] = {1, i, 0, i, 0, 3, 2, 1, 1};
        c.curves[i] = bezier(2, points, weights);
        cross.curves[i] = bezier(2, other, weights);
        stored.curves[i] = in_records(c.curves[i]);
        stored_cross.curves[i] = in_records(cross.curves[i]);
    }
    CHECK_OK(nurbs_coons_gaps(handles(&c), handles(&cross), positions, tangents, twists));
    CHECK_OK(
        nurbs_coons_gaps(handles(&stored), handles(&stored_cross), positions + 4, tangents + 8, twists + 4));
    CHECK_NEAR(positions + 4, positions, 4, 1e-14);
    CHECK_NEAR(tangents + 8, tangents, 8, 1e-13);
    CHECK_NEAR(twists + 4, twists, 4, 1e-13);
    destroy(&c);
    destroy(&cross);
    destroy(&stored);
    destroy(&stored_cross);
}

static void refused_tangents(void) {
    Curves c = square(), cross = straight(1.5);
    nurbs *g = NULL;
    double positions[4], tangents[8], twists[4];
    CHECK_OK(nurbs_coons_gaps(handles(&c), handles(&cross), positions, tangents, twists));
    CHECK_DOUBLES(tangents, VALUES(0.5, 0, 0, 0, 0, 0, 0, 0), 8);
    CHECK_DOUBLES(twists, VALUES(0.5, 0.5, 0, 0), 4);
    CHECK_NO_HANDLE(g, hermite(&c, &cross, NURBS_TWIST_COMPATIBLE, NULL, 0.4, NULL, &g), NURBS_ERROR_TANGENT,
                    "corner (u0, v0)|boundaries[2]|cross[0]|0.5|0.4");
    replace(&cross, 0, bezier(2, VALUES(1, 0, 0, 1.5, 0, 0, 1, 0, 0), NULL));
    CHECK_NO_HANDLE(g, hermite(&c, &cross, NURBS_TWIST_COMPATIBLE, NULL, 0.4, NULL, &g), NURBS_ERROR_TWIST,
                    "corner (u0, v0)|cross[0]|cross[2]|1|0.4");
    double bound = -1;
    CHECK_OK(hermite(&c, &cross, NURBS_TWIST_AVERAGE, NULL, 0.4, &bound, &g));
    CHECK_DOUBLE(bound, 0.5);
    nurbs_destroy(g);
    bound = -1;
    replace(&c, 2, bezier(1, VALUES(0, 0, 0, 1, 0, 1), NULL));
    CHECK_NO_HANDLE(g, hermite(&c, &cross, NURBS_TWIST_AVERAGE, NULL, 0.4, &bound, &g), NURBS_ERROR_GAP,
                    "corner (u1, v0)");
    CHECK_DOUBLE(bound, -1);
    destroy(&c);
    destroy(&cross);
}

static void refused_rules(void) {
    static const double zeros[12] = {0};
    Curves c = square(), cross = straight(1);
    nurbs *g = NULL;
    CHECK_NO_HANDLE(g, hermite(&c, &cross, 6, NULL, 0, NULL, &g), NURBS_ERROR_TWIST_RULE, "twist = 6");
    CHECK_NO_HANDLE(g, hermite(&c, &cross, -1, NULL, 0, NULL, &g), NURBS_ERROR_TWIST_RULE, "twist = -1");
    CHECK_NO_HANDLE(g, hermite(&c, NULL, NURBS_TWIST_COMPATIBLE, NULL, 0, NULL, &g), NURBS_ERROR_TWIST_RULE,
                    "cross");
    CHECK_NO_HANDLE(g, hermite(&c, NULL, NURBS_TWIST_AVERAGE, NULL, 0, NULL, &g), NURBS_ERROR_TWIST_RULE,
                    "cross");
    CHECK_NO_HANDLE(g, hermite(&c, &cross, NURBS_TWIST_ZERO, zeros, 0, NULL, &g), NURBS_ERROR_TWIST_RULE,
                    "twists");
    CHECK_NO_HANDLE(g, hermite(&c, &cross, NURBS_TWIST_GIVEN, NULL, 0, NULL, &g), NURBS_ERROR_NULL, "twists");
    CHECK_NO_HANDLE(g, hermite(&c, &cross, NURBS_TWIST_GIVEN, edited(zeros, 12, 7, INFINITY), 0, NULL, &g),
                    NURBS_ERROR_POINT_NOT_FINITE, "twists[2][1] = inf");
    nurbs *kept = cross.curves[1];
    cross.curves[1] = NULL;
    CHECK_NO_HANDLE(g, hermite(&c, &cross, NURBS_TWIST_ZERO, NULL, 0, NULL, &g), NURBS_ERROR_NULL,
                    "cross[1]");
    cross.curves[1] = make(arch());
    CHECK_NO_HANDLE(g, hermite(&c, &cross, NURBS_TWIST_ZERO, NULL, 0, NULL, &g), NURBS_ERROR_DIMENSION,
                    "cross[1]");
    nurbs_destroy(cross.curves[1]);
    cross.curves[1] = kept;
    CHECK_NO_HANDLE(g, hermite(&c, &cross, NURBS_TWIST_ZERO, NULL, -1, NULL, &g), NURBS_ERROR_TOLERANCE,
                    "-1");
    destroy(&c);
    destroy(&cross);
}

static void make_faces_of_cube(nurbs **faces) {
    nurbs *g = make(cube());
    nurbs_list *list = NULL;
    CHECK_OK(nurbs_boundaries(g, &list));
    for (int i = 0; i < 6; ++i) {
        CHECK_OK(nurbs_list_get(list, i, &faces[i]));
    }
    nurbs_list_destroy(list);
    nurbs_destroy(g);
}

static void destroy_faces(nurbs **faces) {
    for (int i = 0; i < 6; ++i) {
        nurbs_destroy(faces[i]);
    }
}

/* A face of the cube again, with weights that are equal where they have influence. */
static void volume_with_unseen_weights(void) {
    static const int32_t degrees[] = {1, 1};
    static const int64_t counts[] = {3, 2};
    static const double knots[] = {-1, 0, 0, 1, 1, 0, 0, 1, 1};
    static const double points[] = {9, 9, 9, 9, 9, 9, 9, 9, 0, 0, 0, 0, 0, 0, 1, 0, 0, 1, 0, 0, 0, 1, 1, 0};
    static const double weights[] = {2, 3, 1, 1, 1, 1};
    const SplineArgs seen = {2, degrees, counts, knots, 9, 4, points, 0, 0, weights, 0, 0};
    nurbs *h = NULL, *faces[6];
    make_faces_of_cube(faces);
    nurbs_destroy(faces[0]);
    faces[0] = make(seen);
    CHECK_OK(nurbs_volume_coons((const nurbs *const *)faces, 0, &h));
    CHECK_POINTS(h, cube().points);
    nurbs_destroy(h);
    destroy_faces(faces);
}

static void volume(void) {
    nurbs *h = NULL, *faces[6];
    make_faces_of_cube(faces);
    const nurbs *const *given = (const nurbs *const *)faces;
    CHECK_OK(nurbs_volume_coons(given, 0, &h));
    CHECK_POINTS(h, cube().points);
    nurbs_destroy(h);
    CHECK_NO_HANDLE(h, nurbs_volume_coons(NULL, 0, &h), NURBS_ERROR_NULL, "faces");
    CHECK_FAILS(nurbs_volume_coons(given, 0, NULL), NURBS_ERROR_NULL, "out");
    CHECK_NO_HANDLE(h, nurbs_volume_coons(given, -1, &h), NURBS_ERROR_TOLERANCE, "-1");
    nurbs *kept = faces[4];
    faces[4] = faces[5];
    CHECK_NO_HANDLE(h, nurbs_volume_coons(given, 0.5, &h), NURBS_ERROR_GAP,
                    "edge along axis 0|start of axis 2|faces[4]|apart|0.5");
    faces[4] = NULL;
    CHECK_NO_HANDLE(h, nurbs_volume_coons(given, 0.5, &h), NURBS_ERROR_NULL, "faces[4]");
    faces[4] = make(arch());
    CHECK_NO_HANDLE(h, nurbs_volume_coons(given, 0.5, &h), NURBS_ERROR_AXES, "faces[4]|1 axes");
    nurbs_destroy(faces[4]);
    faces[4] = make(trough());
    CHECK_FAILS(nurbs_volume_coons(given, 0.5, &h), NURBS_ERROR_DIMENSION, "faces[");
    nurbs_destroy(faces[4]);
    faces[4] = kept;
    destroy_faces(faces);
}

int main(void) {
    boundaries();
    bilinear();
    gaps();
    refused_curves();
    refused_weights();
    bicubic();
    rectangle();
    gaps_of_records();
    refused_tangents();
    refused_rules();
    volume();
    volume_with_unseen_weights();
    return check_summary("coons");
}
